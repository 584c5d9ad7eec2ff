// SPDX-License-Identifier: MIT
#include "cover_piece.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "rounded_float.h"

namespace occlude::culler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kWord = 64;
constexpr std::uint64_t kAll = ~std::uint64_t{0};

/// The smallest upright rectangle of places.
struct Hull {
  Place low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};

  void hold(const Place& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
};

std::uint64_t from_bit(int k) { return kAll << static_cast<unsigned>(k); }

/// Of 64 pixels from 64 `word` on, those from x0 to x1, both held.
std::uint64_t between(int word, int x0, int x1) {
  std::uint64_t mask = kAll;
  if (word == x0 / kWord) mask &= from_bit(x0 % kWord);
  if (word == x1 / kWord && x1 % kWord != kWord - 1) mask &= ~from_bit(x1 % kWord + 1);
  return mask;
}

/// How near the plane of a triangle is at a ray, less what that is out by.
class PlaneNearness {
 public:
  /// `error` of each coordinate.
  PlaneNearness(const Seen& a, const Seen& b, const Seen& c, double error) {
    const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
    const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) length = std::max({length, std::fabs(p[axis]), std::fabs(q[axis])});
    normal_ = glm::cross(p, q);
    height_ = normal_.x * a.right + normal_.y * a.up + normal_.z * a.forward;
    if (height_ < 0) {
      normal_ = -normal_;
      height_ = -height_;
    }
    // Edges are out by 2 e and a rounding, u = 2^-53; a component of the normal by four products of that with an edge, and
    // three roundings of two products of edges: 8 e l + 10 u l^2. Twice that makes room for the roundings of at().
    normal_error_ = 16 * error * (length + error) + 0x1p-48 * length * length;
    const double reach = std::fabs(a.right) + std::fabs(a.up) + std::fabs(a.forward) + 3 * error;
    height_error_ = 2 * normal_error_ * reach + 8 * length * length * error;
  }

  /// Nothing is known of the plane of a sliver, nor of one seen nearly edge-on.
  [[nodiscard]] bool is_known() const { return height_ > 4 * height_error_; }

  /// At the ray (x, y, 1). Concave: over a rectangle it is lowest at a corner. REQUIRES: is_known().
  [[nodiscard]] double at(const Place& slope) const {
    const double value = normal_.x * slope.x + normal_.y * slope.y + normal_.z;
    const double least = value - normal_error_ * (std::fabs(slope.x) + std::fabs(slope.y) + 1);
    constexpr double kRounded = 0x1p-50;
    return least > 0 ? least / (height_ + height_error_) * (1 - kRounded)
                     : least / (height_ - height_error_) * (1 + kRounded);
  }

 private:
  glm::dvec3 normal_{};
  double height_ = 0, normal_error_ = 0, height_error_ = 0;
};

}  // namespace

bool CoverPiece::draw(const BeamPicture& picture, std::span<const glm::dvec3> vertices,
                      std::span<const Triangle> triangles) {
  picture_ = picture;
  see(vertices, triangles);
  if (!find_place()) return false;
  find_border();
  clear();
  for (const Edge& edge : edges_) draw_edge(edge);
  for (const Triangle& triangle : triangles_) {
    if (is_cut_) draw_cut(triangle);
    lay_depth(triangle);
  }
  return true;
}

/// Each corner once, however many triangles have it.
void CoverPiece::see(std::span<const glm::dvec3> vertices, std::span<const Triangle> triangles) {
  if (stamp_.size() < vertices.size()) {
    stamp_.resize(vertices.size());
    own_.resize(vertices.size());
  }
  if (++stamp_now_ == 0) {  // it has been everything
    std::ranges::fill(stamp_, 0);
    stamp_now_ = 1;
  }
  seen_.clear();
  triangles_.clear();
  for (const Triangle& triangle : triangles) {
    Triangle& own = triangles_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = triangle[i];
      if (stamp_[vertex] != stamp_now_) {
        stamp_[vertex] = stamp_now_;
        own_[vertex] = static_cast<std::uint32_t>(seen_.size());
        seen_.push_back(picture_.see(vertices[vertex]));
      }
      own[i] = own_[vertex];
    }
  }
}

Seen CoverPiece::cut(std::uint32_t a, std::uint32_t b) const {
  const auto [from, to] = std::minmax(a, b);
  return picture_.cut(seen_[from], seen_[to]);
}

CoverPiece::Part CoverPiece::part(const Triangle& triangle) const {
  Part part;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (!is_before(a)) part.corners[part.count++] = seen_[a];
    if (is_before(a) != is_before(b)) part.corners[part.count++] = cut(a, b);
  }
  return part;
}

/// Whether any of the piece is in the picture, where that is, and what its places are out by.
bool CoverPiece::find_place() {
  is_cut_ = false;
  double nearest = kInfinity;
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    is_cut_ = is_cut_ || is_before(i);
    nearest = std::min(nearest, seen_[i].forward);
  }
  Hull hull;
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    if (!is_before(i)) hull.hold(picture_.place(seen_[i]));
  }
  if (is_cut_) {
    for (const Triangle& triangle : triangles_) {
      const Part left = part(triangle);
      for (std::size_t i = 0; i < left.count; ++i) hull.hold(picture_.place(left.corners[i]));
    }
  }
  if (hull.is_empty()) return false;
  const double aside =
      std::max({std::fabs(hull.low.x), std::fabs(hull.high.x), std::fabs(hull.low.y), std::fabs(hull.high.y)}) +
      picture_.width() + picture_.height();
  widening_ = picture_.place_error(std::max(nearest, picture_.near()), aside);
  if (!(widening_ < 1)) return false;  // too doubtful to close anything
  rectangle_ = picture_.clipped(picture_.pixels(hull.low, hull.high, widening_));
  return rectangle_.x0 < rectangle_.x1 && rectangle_.y0 < rectangle_.y1;
}

void CoverPiece::find_border() {
  edges_.clear();
  for (const Triangle& triangle : triangles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      if (from != to) edges_.push_back({from, to});
    }
  }
  const auto key = [](const Edge& edge) { return std::uint64_t{edge.from} << 32U | edge.to; };
  std::ranges::sort(edges_, {}, key);
  std::size_t kept = 0;
  for (std::size_t i = 0, next = 0; i < edges_.size(); i = next) {
    while (next < edges_.size() && key(edges_[next]) == key(edges_[i])) ++next;
    if ((next - i) % 2 == 1) edges_[kept++] = edges_[i];
  }
  edges_.resize(kept);
}

void CoverPiece::clear() {
  words_ = picture_.width() / kWord;
  tiles_across_ = picture_.width() / kTile;
  parity_.resize(static_cast<std::size_t>(words_ * picture_.height()));
  border_.resize(parity_.size());
  tiles_.resize(static_cast<std::size_t>(tiles_across_ * (picture_.height() / kTile)));
  const auto rows = [&](auto& cells, int across, int from, int to, auto value) {
    std::fill(cells.begin() + std::ptrdiff_t{from} * across, cells.begin() + std::ptrdiff_t{to} * across, value);
  };
  rows(parity_, words_, rectangle_.y0, rectangle_.y1, std::uint64_t{0});
  rows(border_, words_, rectangle_.y0, rectangle_.y1, std::uint64_t{0});
  rows(tiles_, tiles_across_, rectangle_.y0 / kTile, (rectangle_.y1 - 1) / kTile + 1,
       std::numeric_limits<float>::infinity());
}

void CoverPiece::draw_edge(const Edge& edge) {
  if (is_before(edge.from) && is_before(edge.to)) return;
  const auto end = [&](std::uint32_t vertex) {
    return picture_.place(is_before(vertex) ? cut(edge.from, edge.to) : seen_[vertex]);
  };
  draw_border(end(edge.from), end(edge.to));
}

/// Where a triangle is cut is border.
void CoverPiece::draw_cut(const Triangle& triangle) {
  std::array<Place, 2> ends{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (is_before(a) != is_before(b)) ends[count++] = picture_.place(cut(a, b));
  }
  if (count == 2) draw_border(ends[0], ends[1]);
}

/// Marks all pixels that come within the widening of the edge, and changes the parity of all whose middle is to the right.
void CoverPiece::draw_border(const Place& p, const Place& q) {
  const bool is_upward = p.y <= q.y;
  const Place &a = is_upward ? p : q, &b = is_upward ? q : p;
  const double rise = b.y - a.y;
  const auto at = [&](double y) { return y <= a.y ? a.x : y >= b.y ? b.x : a.x + (y - a.y) / rise * (b.x - a.x); };
  // A place on the edge rounds four times more.
  const double wide = widening_ + 0x1p-50 * (std::fabs(a.x) + std::fabs(b.x));
  const PixelRectangle rows = picture_.clipped(picture_.pixels({0, a.y}, {0, b.y}, widening_));
  for (int row = rows.y0; row < rows.y1; ++row) {
    // Within the row, or as near it as the widening.
    const double from = rise > 0 ? at(row - widening_) : a.x, to = rise > 0 ? at(row + 1 + widening_) : b.x;
    const PixelRectangle marked = picture_.clipped(picture_.pixels({std::min(from, to), 0}, {std::max(from, to), 0}, wide));
    const auto first_word = static_cast<std::size_t>(row * words_);
    if (marked.x0 < marked.x1) {
      for (int word = marked.x0 / kWord; word <= (marked.x1 - 1) / kWord; ++word) {
        border_[first_word + static_cast<std::size_t>(word)] |= between(word, marked.x0, marked.x1 - 1);
      }
    }
    const double middle = row + 0.5;
    if (!(a.y <= middle && middle < b.y)) continue;
    // The first pixel k whose middle k + 1/2 is not to the left.
    const double right = std::clamp(std::floor(at(middle) + 0.5), 0.0, static_cast<double>(picture_.width()));
    const int first = static_cast<int>(right);
    for (int word = first / kWord; word < words_; ++word) {
      parity_[first_word + static_cast<std::size_t>(word)] ^= word == first / kWord ? from_bit(first % kWord) : kAll;
    }
  }
}

/// A triangle is nowhere farther than its farthest corner, nor, within a tile, than its plane.
void CoverPiece::lay_depth(const Triangle& triangle) {
  const Part left = part(triangle);
  if (left.count == 0) return;
  Hull hull;
  double farthest = -kInfinity;
  for (std::size_t i = 0; i < left.count; ++i) {
    hull.hold(picture_.place(left.corners[i]));
    farthest = std::max(farthest, left.corners[i].forward);
  }
  const double at_least = picture_.nearness(farthest) - picture_.nearness_error(farthest);
  const PixelRectangle r = picture_.clipped(picture_.pixels(hull.low, hull.high, widening_));
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return;
  const PlaneNearness plane(seen_[triangle[0]], seen_[triangle[1]], seen_[triangle[2]], picture_.error());
  const bool has_plane = picture_.is_perspective() && plane.is_known();
  for (int y = r.y0 / kTile; y <= (r.y1 - 1) / kTile; ++y) {
    for (int x = r.x0 / kTile; x <= (r.x1 - 1) / kTile; ++x) {
      double bound = at_least;
      if (has_plane) {
        double lowest = kInfinity;
        for (const int i : {0, 1}) {
          for (const int k : {0, 1}) lowest = std::min(lowest, plane.at(picture_.slope((x + i) * kTile, (y + k) * kTile)));
        }
        bound = std::max(bound, lowest);
      }
      float& tile = tiles_[static_cast<std::size_t>(y * tiles_across_ + x)];
      tile = std::min(tile, rounded_down(bound));
    }
  }
}

}  // namespace occlude::culler
