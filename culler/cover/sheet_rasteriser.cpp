// SPDX-License-Identifier: MIT
#include "cover/sheet_rasteriser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/rounded_float.h"
#include "cover/projected_edge.h"
#include "cover/projected_plane.h"
#include "cover/worth_drawing.h"

namespace occlude::culler {
namespace {

/// A triangle in at most so many tiles across and up is taken to be as far as its farthest corner. Its plane would be nearer
/// by little: without it frames draw 0.1 to 0.3 % more.
constexpr int kOfCorners = 2;
/// A triangle in at most so many tiles across or up is drawn in all tiles of its rows: to find where it begins and ends in
/// each takes longer. Beside the triangle, its plane may be too far, so frames draw up to 0.1 % more.
constexpr int kOfWholeRows = 6;

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// About how many pixels of a grid are inside of a shape of this area and extent: in the mean over all places of the grid,
/// exactly so many if the shape is an upright rectangle with sides of a pixel or more, and about so many if it is convex.
/// Fewer if it is not.
double pixels_inside(double area, const CoverOutline::Extent& extent) {
  return area - (extent.high.x - extent.low.x) - (extent.high.y - extent.low.y) + 1;
}

/// An edge as wide as what moves its ends.
ProjectedEdge moved_edge(const MovedPosition& a, const MovedPosition& b) {
  const auto wide = [](const MovedPosition& p) {
    return p.error + std::max({p.place.x - p.low.x, p.place.y - p.low.y, p.high.x - p.place.x, p.high.y - p.place.y});
  };
  return {a, b, std::max(wide(a), wide(b))};
}

}  // namespace

void SheetRasteriser::begin(const ConservativeViewport& picture) {
  picture_ = picture;
  slopes_x_.clear();
  slopes_y_.clear();
  for (int x = 0; x <= picture.width(); x += kTile) slopes_x_.push_back(picture.slope(x, 0).x);
  for (int y = 0; y <= picture.height(); y += kTile) slopes_y_.push_back(picture.slope(0, y).y);
  reach_ = std::max(std::fabs(slopes_x_.front()), std::fabs(slopes_x_.back())) +
           std::max(std::fabs(slopes_y_.front()), std::fabs(slopes_y_.back()));
  slopes_x_.resize(slopes_x_.size() + kTile);  // which lower() may read
}

void SheetRasteriser::reserve(std::size_t triangles) {
  seen_.reserve(3 * triangles);
  vertices_.reserve(3 * triangles);
  signs_.reserve(triangles);
  sheet_of_.reserve(triangles);
  outlines_.reserve(triangles);
  sheets_.reserve(triangles);
}

void SheetRasteriser::project(const CoverMesh& mesh) {
  mesh_ = mesh;
  const std::size_t count = mesh_.vertices.size();
  seen_.resize(count);
  vertices_.resize(count);
  nearest_of_mesh_ = kNoBound;
  farthest_of_mesh_ = -kNoBound;
  for (std::size_t i = 0; i < count; ++i) {
    seen_[i] = picture_.eye_point(mesh_.vertices[i]);
    nearest_of_mesh_ = std::min(nearest_of_mesh_, seen_[i].forward);
    farthest_of_mesh_ = std::max(farthest_of_mesh_, seen_[i].forward);
  }
  is_cut_ = nearest_of_mesh_ < picture_.near();
  if (picture_.is_of_region()) {
    move();
  } else {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!is_cut_ || !is_before(i)) vertices_[i] = vertex(seen_[i]);
    }
  }
  signs_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < signs_.size(); ++t) {
    const int sign = this->sign(mesh_.triangles[t]);
    signs_[t] = static_cast<std::int8_t>(static_cast<int>(mesh.front) * sign < 0 ? 0 : sign);
  }
  sheets_.part(mesh_, signs_);
  sheet_of_.assign(signs_.size(), 0);
  sheet_number_ = 0;
}

/// Finds what the eyes do to the vertices. What they do to edges and planes is found when it is first asked.
void SheetRasteriser::move() {
  moving_.resize(seen_.size());
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    if (is_cut_ && is_before(i)) continue;
    moving_[i] = picture_.moving(seen_[i]);
    vertices_[i].nearness = least_nearness(seen_[i]);
  }
  edges_.assign(3 * mesh_.triangles.size(), std::nullopt);
  planes_.assign(mesh_.triangles.size(), std::nullopt);
}

void SheetRasteriser::focus(double focus) {
  focus_ = focus;
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    if (!is_cut_ || !is_before(i)) vertices_[i].corner = moving_[i].at(focus);
  }
}

/// Whether what the eyes move its border by leaves hardly anything of a sheet. Most sheets are consumed where what is far
/// nearer or farther is in focus. A sheet is taken to be as good as a rectangle of its area and extent, and its border to
/// move by as much as its vertices in the mean.
bool SheetRasteriser::is_consumed() const {
  if (!picture_.is_of_region() || is_cut_) return false;
  PixelPosition low{kNoBound, kNoBound}, high{-kNoBound, -kNoBound}, wide{};
  double area = 0;
  for (const std::uint32_t t : sheet_) {
    const auto& [a, b, c] = mesh_.triangles[t];
    for (const std::uint32_t v : {a, b, c}) {
      const MovedPosition& corner = vertices_[v].corner;
      low = {std::min(low.x, corner.place.x), std::min(low.y, corner.place.y)};
      high = {std::max(high.x, corner.place.x), std::max(high.y, corner.place.y)};
      wide = {wide.x + corner.high.x - corner.low.x, wide.y + corner.high.y - corner.low.y};
    }
    area += CoverOutline(vertices_[a], vertices_[b], vertices_[c]).area;
  }
  const double corners = 3 * static_cast<double>(sheet_.size());
  const double width = high.x - low.x, height = high.y - low.y, right = width - wide.x / corners,
               up = height - wide.y / corners;
  return !(right > 1 && up > 1) || area * (right / width) * (up / height) - right - up + 1 < kWorthPixels;
}

/// How near something is that begins so far along the line of sight, or at the near plane if that is farther.
float SheetRasteriser::nearness_from(double forward) const {
  return rounded_up(picture_.nearness(picture_.is_perspective() ? std::max(forward, picture_.near()) : forward));
}

bool SheetRasteriser::find(std::size_t sheet) {
  sheet_ = sheets_[sheet];
  if (sheet_.front() >= mesh_.new_triangles || is_consumed()) return false;
  outlines_.clear();
  CoverOutline::Extent all;
  double area = 0, nearest = kNoBound;
  for (const std::uint32_t t : sheet_) {
    const CoverOutline& outline = outlines_.emplace_back(this->outline(mesh_.triangles[t]));
    all.hold(outline.extent);
    area += outline.area;
    for (const std::uint32_t v : mesh_.triangles[t]) nearest = std::min(nearest, seen_[v].forward);
  }
  if (all.is_empty() || pixels_inside(area, all) < kWorthPixels) return false;
  const PixelRectangle r = picture_.clipped(picture_.pixels(all.low, all.high, 0));
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return false;
  found_ = {r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  nearest_ = nearness_from(nearest);
  return true;
}

void SheetRasteriser::rasterise_depth(const PixelRectangle& tiles) {
  window_ = {tiles.x0 * kTile, tiles.y0 * kTile, tiles.x1 * kTile, tiles.y1 * kTile};
  work_ = 0;
  clear(tiles);
  ++sheet_number_;
  for (std::size_t i = 0; i < sheet_.size(); ++i) {
    sheet_of_[sheet_[i]] = sheet_number_;
    if (outlines_[i].extent.may_meet(window_)) rasterise_depth(sheet_[i], outlines_[i]);
  }
}

void SheetRasteriser::draw(const PixelRectangle& tiles) {
  border_.begin(picture_, tiles);
  for (const std::uint32_t t : sheet_) draw_sides(t);
  border_.find_closed(closed_);
}

float SheetRasteriser::least_nearness(const EyePoint& seen) const {
  return rounded_down(picture_.least_nearness(seen.forward));
}

CoverVertex SheetRasteriser::vertex(const EyePoint& seen) const {
  const float nearness = least_nearness(seen);
  if (picture_.is_of_region()) return {picture_.moving(seen).at(focus_), nearness};
  const BoundedPosition corner = picture_.corner(seen);
  return {{corner, corner.place, corner.place}, nearness};
}

CoverVertex SheetRasteriser::cut(std::uint32_t a, std::uint32_t b) const {
  const auto [from, to] = std::minmax(a, b);
  return vertex(picture_.cut(seen_[from], seen_[to]));
}

CoverLoop SheetRasteriser::loop(const CoverMesh::Triangle& triangle) const {
  CoverLoop loop;
  if (!is_cut_) {
    for (const std::uint32_t i : triangle) loop.add(vertices_[i]);
    return loop;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (!is_before(a)) loop.add(vertices_[a]);
    if (is_before(a) != is_before(b)) loop.add(cut(a, b));
  }
  return loop;
}

std::optional<PixelBounds> SheetRasteriser::places(std::size_t triangle) const {
  if (signs_[triangle] == 0) return std::nullopt;
  const CoverOutline outline = this->outline(mesh_.triangles[triangle]);
  return PixelBounds{outline.extent.low, outline.extent.high};
}

void SheetRasteriser::clear(const PixelRectangle& tiles) {
  tiles_across_ = picture_.width() / kTile;
  const std::size_t count = static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(picture_.height() / kTile);
  closed_.resize(count);
  nearness_.resize(count + kTile);  // of which the last are not used
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    const auto row = nearness_.begin() + std::ptrdiff_t{y} * tiles_across_;
    std::fill(row + tiles.x0, row + tiles.x1, std::numeric_limits<float>::infinity());
  }
}

/// 1 if the triangle looks counter-clockwise, -1 if clockwise, 0 if it is seen edge-on; up to rounding. Also 0 if it must
/// not hide.
int SheetRasteriser::sign(const CoverMesh::Triangle& triangle) const {
  if (picture_.is_oblique() && std::ranges::any_of(triangle, [&](auto v) { return picture_.may_clip(mesh_.vertices[v]); }))
    return 0;
  const EyePoint &a = seen_[triangle[0]], &b = seen_[triangle[1]], &c = seen_[triangle[2]];
  const double side = picture_.is_perspective()
                          ? a.forward * (b.right * c.up - b.up * c.right) + b.forward * (c.right * a.up - c.up * a.right) +
                                c.forward * (a.right * b.up - a.up * b.right)
                          : (b.right - a.right) * (c.up - a.up) - (b.up - a.up) * (c.right - a.right);
  return side > 0 ? 1 : side < 0 ? -1 : 0;
}

/// Lowers the nearness of the tiles that the triangle touches. The triangle is nowhere farther than its farthest corner,
/// nor, within a tile, than its plane.
void SheetRasteriser::rasterise_depth(std::uint32_t triangle, const CoverOutline& outline) {
  const PixelRectangle touched = picture_.pixels(outline.extent.low, outline.extent.high, 0);
  const PixelRectangle r{std::max(touched.x0, window_.x0), std::max(touched.y0, window_.y0),
                         std::min(touched.x1, window_.x1), std::min(touched.y1, window_.y1)};
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return;
  const PixelRectangle tiles{r.x0 / kTile, r.y0 / kTile, (r.x1 - 1) / kTile + 1, (r.y1 - 1) / kTile + 1};
  const int across = tiles.x1 - tiles.x0, up = tiles.y1 - tiles.y0;
  if (across <= kOfCorners && up <= kOfCorners) {
    work_ += static_cast<std::size_t>(across) * static_cast<std::size_t>(up);
    return lower(tiles, outline.nearness);
  }
  const ProjectedPlane plane = this->plane(triangle);
  const auto lower_to_plane = [&](const PixelRectangle& part) {
    work_ += static_cast<std::size_t>(part.x1 - part.x0) * static_cast<std::size_t>(part.y1 - part.y0);
    if (!plane.is_known()) return lower(part, outline.nearness);
    for (const PlaneBound& bound : plane.bounds(focus_)) {
      culler::lower({nearness_.data(), tiles_across_, slopes_x_.data(), slopes_y_.data()}, part, bound, outline.nearness);
    }
  };
  if (across <= kOfWholeRows || up <= kOfWholeRows) return lower_to_plane(tiles);
  std::array<ProjectedEdge, 4> edges;
  const CoverLoop loop = this->loop(mesh_.triangles[triangle]);
  for (std::size_t i = 0; i < loop.count; ++i) {
    edges[i] = moved_edge(loop.vertices[i].corner, loop.vertices[i + 1 < loop.count ? i + 1 : 0].corner);
  }
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    ProjectedEdge::Range range;
    for (std::size_t i = 0; i < loop.count; ++i) range.hold(edges[i].between(y * kTile, (y + 1) * kTile));
    const int x0 = std::max(pixel_at(range.low, picture_.width()) / kTile, tiles.x0);
    const int x1 = std::min(pixel_at(range.high, picture_.width()) / kTile + 1, tiles.x1);
    if (x0 < x1) lower_to_plane({x0, y, x1, y + 1});
  }
}

ProjectedPlane SheetRasteriser::plane(std::uint32_t triangle) {
  const auto find = [&] {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return ProjectedPlane(picture_, reach_, seen_[a], seen_[b], seen_[c]);
  };
  if (!picture_.is_of_region()) return find();
  std::optional<ProjectedPlane>& plane = planes_[triangle];
  if (!plane) plane = find();
  return *plane;
}

/// Lowers the nearness of these tiles.
void SheetRasteriser::lower(const PixelRectangle& tiles, float nearness) {
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) {
      float& tile = nearness_[tile_at(x, y)];
      tile = std::min(tile, nearness);
    }
  }
}

/// Draws the sides of a triangle that are border, and the cut at the near plane.
void SheetRasteriser::draw_sides(std::uint32_t triangle) {
  const CoverMesh::Triangle& corners = mesh_.triangles[triangle];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t side = 3 * triangle + i;
    if (!sheets_.is_inner(side) && is_border(side)) draw_edge(side, corners[i], corners[(i + 1) % 3]);
  }
  if (is_cut_) draw_cut(corners);
}

/// Whether an odd number of triangles of the sheet share the edge of a side, and the side is the first of theirs.
bool SheetRasteriser::is_border(std::uint32_t side) const {
  bool is_odd = true;
  for (std::uint32_t other = mesh_.next_of(side); other != side; other = mesh_.next_of(other)) {
    if (!is_in_sheet(other / 3)) continue;
    if (other < side) return false;
    is_odd = !is_odd;
  }
  return is_odd;
}

void SheetRasteriser::draw_edge(std::uint32_t side, std::uint32_t from, std::uint32_t to) {
  if (!is_cut_) {
    const MovedPosition &a = vertices_[from].corner, &b = vertices_[to].corner;
    if (!picture_.is_of_region()) return border_.draw(a, b);
    std::optional<MovingEdge>& edge = edges_[side];
    if (!edge) edge = picture_.moving(a, b);
    return border_.draw(a, b, picture_.swept(*edge, a, b, focus_));
  }
  if (is_before(from) && is_before(to)) return;
  const auto end = [&](std::uint32_t vertex) { return (is_before(vertex) ? cut(from, to) : vertices_[vertex]).corner; };
  draw_edge(end(from), end(to));
}

void SheetRasteriser::draw_edge(const MovedPosition& from, const MovedPosition& to) {
  if (!picture_.is_of_region()) return border_.draw(from, to);
  border_.draw(from, to, picture_.swept(picture_.moving(from, to), from, to, focus_));
}

/// The cut of a triangle is border: it leads from where the loop leaves the drawn part back to where the loop returns.
void SheetRasteriser::draw_cut(const CoverMesh::Triangle& triangle) {
  MovedPosition leaves{}, returns{};
  bool is_cut = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (is_before(a) == is_before(b)) continue;
    is_cut = true;
    (is_before(b) ? leaves : returns) = cut(a, b).corner;
  }
  if (is_cut) draw_edge(leaves, returns);
}

}  // namespace occlude::culler
