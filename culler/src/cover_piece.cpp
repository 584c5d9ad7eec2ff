// SPDX-License-Identifier: MIT
#include "cover_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rounded_float.h"
#include "seen_edge.h"
#include "seen_plane.h"

namespace occlude::culler {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// A sheet that is narrower than this, in pixels, closes at most a few of them.
constexpr int kLeastSide = 4;

}  // namespace

struct CoverPiece::Outline {
  /// The smallest upright rectangle around positions and their errors.
  struct Extent {
    Place low{kNoBound, kNoBound}, high{-kNoBound, -kNoBound};

    void hold(const Corner& corner) {
      low = {std::min(low.x, corner.place.x - corner.error), std::min(low.y, corner.place.y - corner.error)};
      high = {std::max(high.x, corner.place.x + corner.error), std::max(high.y, corner.place.y + corner.error)};
    }
    void hold(const Extent& other) {
      low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
      high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
  };

  std::array<Corner, 4> corners;
  std::size_t count = 0;
  Extent extent;
  float nearness = std::numeric_limits<float>::infinity();  ///< no corner has less

  void hold(const Vertex& vertex) {
    corners[count++] = vertex.corner;
    extent.hold(vertex.corner);
    nearness = std::min(nearness, vertex.nearness);
  }
};

void CoverPiece::begin(const BeamPicture& picture) {
  picture_ = picture;
  slopes_x_.clear();
  slopes_y_.clear();
  for (int x = 0; x <= picture.width(); x += kTile) slopes_x_.push_back(picture.slope(x, 0).x);
  for (int y = 0; y <= picture.height(); y += kTile) slopes_y_.push_back(picture.slope(0, y).y);
  reach_ = std::max(std::fabs(slopes_x_.front()), std::fabs(slopes_x_.back())) +
           std::max(std::fabs(slopes_y_.front()), std::fabs(slopes_y_.back()));
}

void CoverPiece::reserve(std::size_t triangles) {
  seen_.reserve(3 * triangles);
  vertices_.reserve(3 * triangles);
  signs_.reserve(triangles);
  taken_.reserve(triangles);
  sheets_.reserve(triangles);
}

void CoverPiece::see(const CoverMesh& mesh) {
  mesh_ = mesh;
  const std::size_t count = mesh_.vertices.size();
  seen_.resize(count);
  vertices_.resize(count);
  is_cut_ = false;
  for (std::size_t i = 0; i < count; ++i) {
    seen_[i] = picture_.see(mesh_.vertices[i]);
    is_cut_ = is_cut_ || seen_[i].forward < picture_.near();
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_cut_ || !is_before(i)) vertices_[i] = vertex(seen_[i]);
  }
  signs_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < signs_.size(); ++t) {
    const int sign = this->sign(mesh_.triangles[t]);
    signs_[t] = static_cast<std::int8_t>(static_cast<int>(mesh.front) * sign < 0 ? 0 : sign);
  }
  sheets_.part(mesh_, signs_);
  taken_.assign(signs_.size(), 0);
  piece_ = 0;
}

bool CoverPiece::find(std::size_t sheet) {
  sheet_ = sheets_[sheet];
  Outline::Extent all;
  double nearest = kNoBound;
  for (const std::uint32_t t : sheet_) {
    const Outline outline = this->outline(mesh_.triangles[t]);
    all.hold(outline.extent);
    for (const std::uint32_t v : mesh_.triangles[t]) nearest = std::min(nearest, seen_[v].forward);
  }
  if (all.is_empty()) return false;
  const PixelRectangle r = picture_.clipped(picture_.pixels(all.low, all.high, 0));
  if (r.x1 - r.x0 < kLeastSide || r.y1 - r.y0 < kLeastSide) return false;
  found_ = {r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  nearest_ = rounded_up(picture_.nearness(picture_.is_perspective() ? std::max(nearest, picture_.near()) : nearest));
  return true;
}

void CoverPiece::draw(const PixelRectangle& tiles) {
  rectangle_ = {tiles.x0 * kTile, tiles.y0 * kTile, tiles.x1 * kTile, tiles.y1 * kTile};
  work_ = 0;
  clear(tiles);
  ++piece_;
  for (const std::uint32_t t : sheet_) take(t);
  for (const std::uint32_t t : sheet_) {
    if (is_taken(t)) draw_sides(t);
  }
  border_.find_closed(closed_);
}

CoverPiece::Vertex CoverPiece::vertex(const Seen& seen) const {
  return {picture_.corner(seen), rounded_down(picture_.nearness(seen.forward) - picture_.nearness_error(seen.forward))};
}

CoverPiece::Vertex CoverPiece::cut(std::uint32_t a, std::uint32_t b) const {
  const auto [from, to] = std::minmax(a, b);
  return vertex(picture_.cut(seen_[from], seen_[to]));
}

CoverPiece::Outline CoverPiece::outline(const CoverMesh::Triangle& triangle) const {
  Outline outline;
  if (!is_cut_) {
    for (const std::uint32_t i : triangle) outline.hold(vertices_[i]);
    return outline;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (!is_before(a)) outline.hold(vertices_[a]);
    if (is_before(a) != is_before(b)) outline.hold(cut(a, b));
  }
  return outline;
}

std::optional<PlaceRectangle> CoverPiece::places(std::size_t triangle) const {
  if (signs_[triangle] == 0) return std::nullopt;
  const Outline outline = this->outline(mesh_.triangles[triangle]);
  return PlaceRectangle{outline.extent.low, outline.extent.high};
}

void CoverPiece::clear(const PixelRectangle& tiles) {
  tiles_across_ = picture_.width() / kTile;
  const std::size_t count = static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(picture_.height() / kTile);
  border_.begin(picture_, tiles);
  closed_.resize(count);
  nearness_.resize(count);
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    const auto row = nearness_.begin() + std::ptrdiff_t{y} * tiles_across_;
    std::fill(row + tiles.x0, row + tiles.x1, std::numeric_limits<float>::infinity());
  }
}

/// Takes a triangle if any of it is in the pixels that are drawn.
void CoverPiece::take(std::uint32_t triangle) {
  const Outline outline = this->outline(mesh_.triangles[triangle]);
  const auto& [low, high] = outline.extent;
  const PixelRectangle& r = rectangle_;
  const bool is_in = high.x >= r.x0 && low.x <= r.x1 && high.y >= r.y0 && low.y <= r.y1;
  taken_[triangle] = is_in ? piece_ : 0;
  if (is_in) lay_depth(mesh_.triangles[triangle], outline);
}

/// 1 if the triangle looks counter-clockwise, -1 if clockwise, 0 if it is seen edge-on; up to rounding. Also 0 if it must
/// not hide.
int CoverPiece::sign(const CoverMesh::Triangle& triangle) const {
  if (picture_.is_oblique() && std::ranges::any_of(triangle, [&](auto v) { return picture_.may_clip(mesh_.vertices[v]); }))
    return 0;
  const Seen &a = seen_[triangle[0]], &b = seen_[triangle[1]], &c = seen_[triangle[2]];
  const double side = picture_.is_perspective()
                          ? a.forward * (b.right * c.up - b.up * c.right) + b.forward * (c.right * a.up - c.up * a.right) +
                                c.forward * (a.right * b.up - a.up * b.right)
                          : (b.right - a.right) * (c.up - a.up) - (b.up - a.up) * (c.right - a.right);
  return side > 0 ? 1 : side < 0 ? -1 : 0;
}

/// Lowers the nearness of the tiles that the triangle touches. The triangle is nowhere farther than its farthest corner,
/// nor, within a tile, than its plane.
void CoverPiece::lay_depth(const CoverMesh::Triangle& triangle, const Outline& outline) {
  const PixelRectangle touched = picture_.pixels(outline.extent.low, outline.extent.high, 0);
  const PixelRectangle r{std::max(touched.x0, rectangle_.x0), std::max(touched.y0, rectangle_.y0),
                         std::min(touched.x1, rectangle_.x1), std::min(touched.y1, rectangle_.y1)};
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return;
  const PixelRectangle tiles{r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  if (tiles.x1 - tiles.x0 == 1 && tiles.y1 - tiles.y0 == 1) {
    lay(tiles.x0, tiles.y0, outline.nearness);
    return;
  }
  const auto& [a, b, c] = triangle;
  const SeenPlane plane(picture_, reach_, seen_[a], seen_[b], seen_[c]);
  const bool is_large = tiles.x1 - tiles.x0 > 2 && tiles.y1 - tiles.y0 > 2;
  std::array<SeenEdge, 4> edges;
  for (std::size_t i = 0; is_large && i < outline.count; ++i) {
    edges[i] = {outline.corners[i], outline.corners[i + 1 < outline.count ? i + 1 : 0]};
  }
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    int x0 = tiles.x0, x1 = tiles.x1;
    if (is_large) {
      SeenEdge::Range range;
      for (std::size_t i = 0; i < outline.count; ++i) range.hold(edges[i].between(y * kTile, (y + 1) * kTile));
      x0 = std::max(pixel_at(range.low, picture_.width()) / kTile, x0);
      x1 = std::min(pixel_at(range.high, picture_.width()) / kTile + 1, x1);
    }
    work_ += static_cast<std::size_t>(std::max(x1 - x0, 0));
    const double* const slopes = slopes_x_.data();
    const double of_rows = plane.of_rows(slopes_y_[static_cast<std::size_t>(y)], slopes_y_[static_cast<std::size_t>(y) + 1]);
    for (int x = x0; x < x1; ++x) {
      const double of_plane = plane.is_known() ? plane.least_nearness(of_rows, slopes[x], slopes[x + 1]) : -kNoBound;
      lay(x, y, of_plane > outline.nearness ? rounded_down(of_plane) : outline.nearness);
    }
  }
}

void CoverPiece::lay(int tile_x, int tile_y, float nearness) {
  float& tile = nearness_[tile_at(tile_x, tile_y)];
  tile = std::min(tile, nearness);
}

/// Draws the sides of a triangle that are border, each edge only with the first of its triangles, and the cut at the near
/// plane.
void CoverPiece::draw_sides(std::uint32_t triangle) {
  const CoverMesh::Triangle& corners = mesh_.triangles[triangle];
  const auto sign_of = [&](std::uint32_t t) { return is_taken(t) ? signs_[t] : 0; };
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t side = 3 * triangle + i;
    if (!is_first(side)) continue;
    if (const int count = degree(mesh_, side, sign_of); count != 0) draw_edge(corners[i], corners[(i + 1) % 3], count);
  }
  if (is_cut_) draw_cut(corners, signs_[triangle]);
}

/// Whether the side is the first of its ring among those of triangles that are taken.
bool CoverPiece::is_first(std::uint32_t side) const {
  for (std::uint32_t other = mesh_.next_of(side); other != side; other = mesh_.next_of(other)) {
    if (other < side && is_taken(other / 3)) return false;
  }
  return true;
}

void CoverPiece::draw_edge(std::uint32_t from, std::uint32_t to, int degree) {
  if (!is_cut_) return border_.draw(vertices_[from].corner, vertices_[to].corner, degree);
  if (is_before(from) && is_before(to)) return;
  const auto end = [&](std::uint32_t vertex) { return (is_before(vertex) ? cut(from, to) : vertices_[vertex]).corner; };
  border_.draw(end(from), end(to), degree);
}

/// The cut of a triangle is border: it leads from where the loop leaves the drawn part back to where the loop returns.
void CoverPiece::draw_cut(const CoverMesh::Triangle& triangle, int degree) {
  Corner leaves{}, returns{};
  bool is_cut = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (is_before(a) == is_before(b)) continue;
    is_cut = true;
    (is_before(b) ? leaves : returns) = cut(a, b).corner;
  }
  if (is_cut) border_.draw(leaves, returns, degree);
}

}  // namespace occlude::culler
