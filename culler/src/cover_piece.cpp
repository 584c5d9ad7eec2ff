// SPDX-License-Identifier: MIT
#include "cover_piece.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "rounded_float.h"

namespace occlude::culler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A mesh that is narrower, in pixels, closes at most a few of them.
constexpr int kLeastSide = 6;

static_assert(std::endian::native == std::endian::little, "mark() takes the first byte for the lowest");

/// Marks pixels x0 to before x1 of a row. Few at a time, as nearly always: eight are written at once. REQUIRES: eight bytes
/// more behind the row.
void mark(std::uint8_t* row, int x0, int x1) {
  for (int x = x0; x < x1; x += 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, row + x, sizeof bytes);
    bytes |= 0x0101010101010101U >> (8U * static_cast<unsigned>(8 - std::min(x1 - x, 8)));
    std::memcpy(row + x, &bytes, sizeof bytes);
  }
}

/// The plane n . x = h of a triangle, and by how much it may be out.
class SeenPlane {
 public:
  /// `error` of each coordinate as computed; a renderer has points of the triangle out by `rounding` beside that.
  SeenPlane(const Seen& a, const Seen& b, const Seen& c, double error, double rounding) {
    const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
    const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) length = std::max({length, std::fabs(p[axis]), std::fabs(q[axis])});
    normal_ = glm::cross(p, q);
    height_ = normal_.x * a.right + normal_.y * a.up + normal_.z * a.forward;
    // Edges are out by 2 e and a rounding, u = 2^-53; a component of the normal by four products of that with an edge, and
    // three roundings of two products of edges: 8 e l + 10 u l^2. Twice that makes room for the roundings of least().
    normal_error_ = 16 * error * (length + error) + 0x1p-48 * length * length;
    const double reach = std::fabs(a.right) + std::fabs(a.up) + std::fabs(a.forward) + 3 * error;
    height_error_ = 2 * normal_error_ * reach + 8 * length * length * error;
    // A point x of the triangle that is moved by d lies at n . x = h + n . d.
    height_error_ += rounding * (std::fabs(normal_.x) + std::fabs(normal_.y) + std::fabs(normal_.z) + 3 * normal_error_);
  }

  /// Nothing is known of the plane of a sliver, nor of one seen nearly edge-on.
  [[nodiscard]] bool is_known(bool is_perspective) const {
    return is_perspective ? std::fabs(height_) > 4 * height_error_ : std::fabs(normal_.z) > 4 * normal_error_;
  }

  /// The nearness 1 / f along the rays (x, y, 1) of the rectangle is n . (x, y, 1) / h: no less than this.
  /// REQUIRES: is_known(true).
  [[nodiscard]] double least_nearness(const Place& low, const Place& high) const {
    const double sign = height_ < 0 ? -1 : 1, height = std::fabs(height_);
    const double value = lowest(sign, low, high) + sign * normal_.z - normal_error_ * (reach(low, high) + 1);
    return value > 0 ? value / (height + height_error_) * (1 - kRounded) : value / (height - height_error_) * (1 + kRounded);
  }

  /// How far the plane is along the parallel rays through the rectangle, f = (h - n . (x, y, 0)) / n_z: no more than this.
  /// REQUIRES: is_known(false).
  [[nodiscard]] double most_forward(const Place& low, const Place& high) const {
    const double sign = normal_.z < 0 ? -1 : 1, depth = std::fabs(normal_.z);
    const double error = height_error_ + normal_error_ * reach(low, high);
    const double most = sign * height_ - lowest(sign, low, high);
    const double value = most + error + kRounded * (std::fabs(height_) + std::fabs(most - sign * height_));
    return value > 0 ? value / (depth - normal_error_) * (1 + kRounded) : value / (depth + normal_error_) * (1 - kRounded);
  }

 private:
  static constexpr double kRounded = 0x1p-50;

  /// The least of sign n . (x, y, 0) over the rectangle.
  [[nodiscard]] double lowest(double sign, const Place& low, const Place& high) const {
    const double x = sign * normal_.x, y = sign * normal_.y;
    return x * (x > 0 ? low.x : high.x) + y * (y > 0 ? low.y : high.y);
  }
  /// The most of |x| + |y| over the rectangle.
  [[nodiscard]] static double reach(const Place& low, const Place& high) {
    return std::max(std::fabs(low.x), std::fabs(high.x)) + std::max(std::fabs(low.y), std::fabs(high.y));
  }

  glm::dvec3 normal_{};
  double height_ = 0, normal_error_ = 0, height_error_ = 0;
};

}  // namespace

/// The smallest upright rectangle about places, with what they are out by, and the farthest of them.
struct CoverPiece::Extent {
  Place low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  double farthest = -kInfinity;

  void hold(const Corner& corner) {
    low = {std::min(low.x, corner.place.x - corner.error), std::min(low.y, corner.place.y - corner.error)};
    high = {std::max(high.x, corner.place.x + corner.error), std::max(high.y, corner.place.y + corner.error)};
  }
  void hold(const Corner& corner, double forward) {
    hold(corner);
    farthest = std::max(farthest, forward);
  }
  [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
};

void CoverPiece::begin(const BeamPicture& picture) {
  picture_ = picture;
  slopes_x_.clear();
  slopes_y_.clear();
  for (int x = 0; x <= picture.width(); x += kTile) slopes_x_.push_back(picture.slope(x, 0).x);
  for (int y = 0; y <= picture.height(); y += kTile) slopes_y_.push_back(picture.slope(0, y).y);
}

/// What is drawn of a triangle: a convex loop.
struct CoverPiece::Outline {
  std::array<Corner, 4> corners;
  std::size_t count = 0;
  Extent extent;

  void hold(const Corner& corner, double forward) {
    corners[count++] = corner;
    extent.hold(corner, forward);
  }

  struct Range {
    double low, high;
  };
  /// From where to where across it reaches between two heights, or as near them as its corners are out; the low end is above
  /// the high one where it does not. A place on an edge rounds as in mark_border().
  [[nodiscard]] Range between(double low, double high) const {
    Range range{kInfinity, -kInfinity};
    for (std::size_t i = 0; i < count; ++i) {
      const Corner &p = corners[i], &q = corners[i + 1 < count ? i + 1 : 0];
      const Place &a = p.place.y <= q.place.y ? p.place : q.place, &b = p.place.y <= q.place.y ? q.place : p.place;
      const double error = std::max(p.error, q.error);
      if (a.y > high + error || b.y < low - error) continue;
      const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
      const double first = a.y >= low - error ? a.x : a.x + (low - error - a.y) * slope;
      const double last = b.y <= high + error ? b.x : a.x + (high + error - a.y) * slope;
      const double wide = error + 0x1p-50 * (std::fabs(a.x) + std::fabs(b.x));
      range = {std::min({range.low, first - wide, last - wide}), std::max({range.high, first + wide, last + wide})};
    }
    return range;
  }
};

CoverPiece::Outline CoverPiece::outline(const CoverMesh::Triangle& triangle) const {
  Outline outline;
  if (!is_cut_) {
    for (const std::uint32_t i : triangle) outline.hold(corners_[i], seen_[i].forward);
  } else {
    const Part left = part(triangle);
    for (std::size_t i = 0; i < left.count; ++i) outline.hold(corner(left.corners[i]), left.corners[i].forward);
  }
  return outline;
}

bool CoverPiece::draw(const PixelRectangle& tiles) {
  rectangle_ = {tiles.x0 * kTile, tiles.y0 * kTile, tiles.x1 * kTile, tiles.y1 * kTile};
  work_ = static_cast<std::size_t>(tiles.x1 - tiles.x0) * static_cast<std::size_t>(tiles.y1 - tiles.y0);
  if (!take()) return false;
  clear();
  for (const CoverMesh::Edge& edge : mesh_.edges) {
    if (const int count = degree(edge); count != 0) draw_edge(edge, count);
  }
  for (std::size_t t = 0; t < signs_.size(); ++t) {
    if (signs_[t] == 0) continue;
    if (is_cut_) draw_cut(mesh_.triangles[t], signs_[t]);
    lay_depth(mesh_.triangles[t]);
  }
  close();
  return true;
}

CoverPiece::Corner CoverPiece::corner(const Seen& seen) const {
  const Place place = picture_.place(seen);
  return {place, picture_.place_error(place, seen.forward)};
}

void CoverPiece::see() {
  const std::size_t count = mesh_.vertices.size();
  seen_.resize(count);
  corners_.resize(count);
  is_cut_ = false;
  for (std::size_t i = 0; i < count; ++i) {
    seen_[i] = picture_.see(mesh_.vertices[i]);
    is_cut_ = is_cut_ || seen_[i].forward < picture_.near();
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_cut_ || !is_before(i)) corners_[i] = corner(seen_[i]);
  }
}

Seen CoverPiece::cut(std::uint32_t a, std::uint32_t b) const {
  const auto [from, to] = std::minmax(a, b);
  return picture_.cut(seen_[from], seen_[to]);
}

CoverPiece::Part CoverPiece::part(const CoverMesh::Triangle& triangle) const {
  Part part;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (!is_before(a)) part.corners[part.count++] = seen_[a];
    if (is_before(a) != is_before(b)) part.corners[part.count++] = cut(a, b);
  }
  return part;
}

bool CoverPiece::find(const CoverMesh& mesh) {
  mesh_ = mesh;
  see();
  Extent all;
  double nearest = kInfinity;
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    if (is_cut_ && is_before(i)) continue;
    all.hold(corners_[i]);
    nearest = std::min(nearest, seen_[i].forward);
  }
  if (is_cut_) {
    nearest = picture_.near();
    for (const CoverMesh::Edge& edge : mesh_.edges) {
      if (is_before(edge.from) != is_before(edge.to)) all.hold(corner(cut(edge.from, edge.to)));
    }
  }
  if (all.is_empty()) return false;
  const PixelRectangle r = picture_.clipped(picture_.pixels(all.low, all.high, 0));
  if (r.x1 - r.x0 < kLeastSide || r.y1 - r.y0 < kLeastSide) return false;
  found_ = {r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  nearest_ = rounded_up(picture_.nearness(nearest));
  return true;
}

int CoverPiece::sign(const CoverMesh::Triangle& triangle, bool is_closed) const {
  const Seen &a = seen_[triangle[0]], &b = seen_[triangle[1]], &c = seen_[triangle[2]];
  const double side = picture_.is_perspective()
                          ? a.forward * (b.right * c.up - b.up * c.right) + b.forward * (c.right * a.up - c.up * a.right) +
                                c.forward * (a.right * b.up - a.up * b.right)
                          : (b.right - a.right) * (c.up - a.up) - (b.up - a.up) * (c.right - a.right);
  return side > 0 ? 1 : side < 0 && !is_closed ? -1 : 0;
}

/// Of closed surfaces what is turned to the eye, of others all.
bool CoverPiece::take() {
  signs_.resize(mesh_.triangles.size());
  bool is_any = false;
  for (std::size_t t = 0; t < signs_.size(); ++t) {
    signs_[t] = static_cast<std::int8_t>(sign(mesh_.triangles[t], mesh_.is_closed[t] != 0));
    is_any = is_any || signs_[t] != 0;
  }
  return is_any;
}

int CoverPiece::degree(const CoverMesh::Edge& edge) const {
  int sum = 0;
  for (std::uint32_t u = edge.first_use; u < edge.end_use; ++u) {
    const CoverMesh::Use use = mesh_.uses[u];
    sum += use.ascends ? signs_[use.triangle] : -signs_[use.triangle];
  }
  return sum;
}

void CoverPiece::clear() {
  const auto width = static_cast<std::size_t>(picture_.width()), height = static_cast<std::size_t>(picture_.height());
  tiles_across_ = picture_.width() / kTile;
  turns_.resize(width * height);
  border_.resize(width * height + sizeof(std::uint64_t));  // mark() writes eight at a time
  degrees_.resize(width);
  tiles_.resize(width * height / (kTile * kTile));
  const PixelRectangle& r = rectangle_;
  const auto across = static_cast<std::size_t>(r.x1 - r.x0);
  for (int y = r.y0; y < r.y1; ++y) {
    std::memset(&turns_[at(r.x0, y)], 0, across);
    std::memset(&border_[at(r.x0, y)], 0, across);
  }
  std::memset(&degrees_[static_cast<std::size_t>(r.x0)], 0, across);
  for (int y = r.y0 / kTile; y < r.y1 / kTile; ++y) {
    const auto row = tiles_.begin() + std::ptrdiff_t{y} * tiles_across_;
    std::fill(row + r.x0 / kTile, row + r.x1 / kTile, std::numeric_limits<float>::infinity());
  }
}

void CoverPiece::draw_edge(const CoverMesh::Edge& edge, int degree) {
  if (!is_cut_) return draw_border(corners_[edge.from], corners_[edge.to], degree);
  if (is_before(edge.from) && is_before(edge.to)) return;
  const auto end = [&](std::uint32_t vertex) {
    return is_before(vertex) ? corner(cut(edge.from, edge.to)) : corners_[vertex];
  };
  draw_border(end(edge.from), end(edge.to), degree);
}

/// Where a triangle is cut is border: it goes back there from where the loop leaves what is drawn to where it returns.
void CoverPiece::draw_cut(const CoverMesh::Triangle& triangle, int degree) {
  Corner leaves{}, returns{};
  bool is_cut = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (is_before(a) == is_before(b)) continue;
    is_cut = true;
    (is_before(b) ? leaves : returns) = corner(cut(a, b));
  }
  if (is_cut) draw_border(leaves, returns, degree);
}

void CoverPiece::draw_border(const Corner& from, const Corner& to, int degree) {
  mark_border(from, to);
  if (from.place.x <= to.place.x) {
    turn_degree(from.place, to.place, degree);
  } else {
    turn_degree(to.place, from.place, -degree);
  }
}

/// Marks all pixels that come so near the edge as its ends are out.
void CoverPiece::mark_border(const Corner& p, const Corner& q) {
  const Place &a = p.place.y <= q.place.y ? p.place : q.place, &b = p.place.y <= q.place.y ? q.place : p.place;
  const double error = std::max(p.error, q.error);
  const double rise = b.y - a.y, slope = rise > 0 ? (b.x - a.x) / rise : 0;
  // A place on the edge rounds four times more.
  const double wide = error + 0x1p-50 * (std::fabs(a.x) + std::fabs(b.x));
  const PixelRectangle& r = rectangle_;
  const PixelRectangle rows = picture_.pixels({0, a.y}, {0, b.y}, error);
  const double low_x = std::min(a.x, b.x), high_x = std::max(a.x, b.x);
  for (int row = std::max(rows.y0, r.y0); row < std::min(rows.y1, r.y1); ++row) {
    // Within the row, or as near it as the error.
    const auto at_y = [&](double y) { return y <= a.y ? a.x : y >= b.y ? b.x : a.x + (y - a.y) * slope; };
    double from = low_x, to = high_x;
    if (rise > 0) {
      from = at_y(row - error);
      to = at_y(row + 1 + error);
      if (to < from) std::swap(from, to);
    }
    const PixelRectangle marked = picture_.pixels({from, 0}, {to, 0}, wide);
    mark(&border_[at(0, row)], std::max(marked.x0, r.x0), std::min(marked.x1, r.x1));
  }
}

/// Changes the degree of all pixels whose middle is above the edge, which goes from a to the right to b.
void CoverPiece::turn_degree(const Place& a, const Place& b, int degree) {
  const double run = b.x - a.x;
  if (!(run > 0)) return;
  const double slope = (b.y - a.y) / run;
  const PixelRectangle& r = rectangle_;
  // Columns whose middle is beyond a.x and not beyond b.x.
  const auto first_from = [&](double x) { return std::clamp(first_middle(x, picture_.width()), r.x0, r.x1); };
  const int end = first_from(b.x);
  for (int x = first_from(a.x); x < end; ++x) {
    const double y = a.y + (x + 0.5 - a.x) * slope;
    const int row = std::max(first_middle(y, picture_.height()), r.y0);
    if (row < r.y1) turns_[at(x, row)] = static_cast<std::uint8_t>(turns_[at(x, row)] + degree);
  }
}

std::optional<PlaceRectangle> CoverPiece::places(const CoverMesh::Triangle& triangle) const {
  const Outline outline = this->outline(triangle);
  if (outline.count == 0) return std::nullopt;
  return PlaceRectangle{outline.extent.low, outline.extent.high};
}

/// A triangle is nowhere farther than its farthest corner, nor, within a tile, than its plane.
void CoverPiece::lay_depth(const CoverMesh::Triangle& triangle) {
  const Outline outline = this->outline(triangle);
  if (outline.count == 0) return;
  const PixelRectangle touched = picture_.pixels(outline.extent.low, outline.extent.high, 0);
  const PixelRectangle r{std::max(touched.x0, rectangle_.x0), std::max(touched.y0, rectangle_.y0),
                         std::min(touched.x1, rectangle_.x1), std::min(touched.y1, rectangle_.y1)};
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return;
  const double farthest = outline.extent.farthest;
  const float at_corners = rounded_down(picture_.nearness(farthest) - picture_.nearness_error(farthest));
  const PixelRectangle tiles{r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  if (tiles.x1 - tiles.x0 == 1 && tiles.y1 - tiles.y0 == 1) {
    lay(tiles.x0, tiles.y0, at_corners);
    return;
  }
  const bool is_perspective = picture_.is_perspective();
  const auto& [a, b, c] = triangle;
  const SeenPlane plane(seen_[a], seen_[b], seen_[c], picture_.error(), picture_.rounding());
  const bool is_known = plane.is_known(is_perspective);
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    const auto [low_x, high_x] = outline.between(y * kTile, (y + 1) * kTile);
    if (low_x > high_x) continue;
    const int x0 = std::max(pixel_at(low_x, picture_.width()) / kTile, tiles.x0);
    const int x1 = std::min(pixel_at(high_x, picture_.width()) / kTile + 1, tiles.x1);
    work_ += static_cast<std::size_t>(std::max(x1 - x0, 0));
    for (int x = x0; x < x1; ++x) {
      float nearness = at_corners;
      if (is_known) {
        const Place low{slope_x(x), slope_y(y)}, high{slope_x(x + 1), slope_y(y + 1)};
        const double of_plane =
            is_perspective ? plane.least_nearness(low, high) : picture_.nearness(plane.most_forward(low, high));
        nearness = std::max(nearness, rounded_down(of_plane));
      }
      lay(x, y, nearness);
    }
  }
}

void CoverPiece::lay(int tile_x, int tile_y, float nearness) {
  float& tile = tiles_[static_cast<std::size_t>(tile_y * tiles_across_ + tile_x)];
  tile = std::min(tile, nearness);
}

/// From turns and border to what is closed.
void CoverPiece::close() {
  const PixelRectangle& r = rectangle_;
  const auto across = static_cast<std::size_t>(r.x1 - r.x0);
  std::uint8_t* const degrees = &degrees_[static_cast<std::size_t>(r.x0)];
  for (int y = r.y0; y < r.y1; ++y) {
    const std::uint8_t* const turns = &turns_[at(r.x0, y)];
    std::uint8_t* const border = &border_[at(r.x0, y)];
    for (std::size_t i = 0; i < across; ++i) {
      degrees[i] = static_cast<std::uint8_t>(degrees[i] + turns[i]);
      border[i] = degrees[i] != 0 && border[i] == 0 ? 1 : 0;
    }
  }
}

}  // namespace occlude::culler
