// SPDX-License-Identifier: MIT
#include "cover_face.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "certain_sign.h"

namespace occlude::kernel {
namespace {

template <class Number>
Vector3<Number> opposite(const Vector3<Number>& v) {
  return {-v.x, -v.y, -v.z};
}

template <class Number>
PlaneForm<Number> plane_of(const Face<Number>& face) {
  return triangle_forms<Number>({face[0], face[1], face[2]}).plane;
}

/// Whether all of these points are certainly on the negative side of the line.
bool is_beyond(const Vector3<RunningError>& line, std::span<const RayPoint<RunningError>> points) {
  return std::ranges::all_of(points, [&](const auto& p) { return certain_sign(dot(line, p.ray)) < 0; });
}

}  // namespace

CoverFace::CoverFace(const CoverParts& parts, ExactCover& cover, const Face<RunningError>& face,
                     const Face<BigInteger>& exact_face)
    : parts_(parts), cover_(cover), face_(face), exact_face_(exact_face), plane_(plane_of(face)) {
  for (std::uint32_t i = 0; i < 4; ++i) {
    lines_.push_back({Kind::face_side, 0, i, cross(face[i].ray, face[(i + 1) % 4].ray), {}});
  }
  for (std::uint32_t i = 0; i < parts.triangles.size(); ++i) {
    if (!is_apart(parts.triangles[i])) add_triangle(i);
  }
}

/// Most triangles neither hide any of the face nor touch it, and one line shows it.
bool CoverFace::is_apart(const CoverTriangle& triangle) const {
  const auto is_before_none = [&](const Vector3<RunningError>& line) { return is_beyond(line, face_); };
  if (std::ranges::any_of(triangle.forms.sides, is_before_none)) return true;
  if (parts_.drawn && is_before_none(triangle.drawn)) return true;
  if (is_before_none(nearer(triangle.forms.plane, plane_))) return true;
  return std::any_of(lines_.begin(), lines_.begin() + 4,
                     [&](const Line& side) { return is_beyond(side.rounded, triangle.forms.corners); });
}

void CoverFace::add_triangle(std::uint32_t i) {
  const CoverTriangle& triangle = parts_.triangles[i];
  std::vector<Side>& sides = of_triangle_.emplace_back();
  const auto add = [&](Kind kind, std::uint32_t corner, const Vector3<RunningError>& line) {
    sides.push_back({static_cast<std::uint32_t>(lines_.size()), false});
    lines_.push_back({kind, i, corner, line, {}});
  };
  for (std::uint32_t k = 0; k < 3; ++k) add(Kind::side, k, triangle.forms.sides[k]);
  if (parts_.drawn) add(Kind::drawn, 0, triangle.drawn);
  add(Kind::nearer, 0, nearer(triangle.forms.plane, plane_));
  triangles_.push_back(i);
}

Vector3<RunningError> CoverFace::rounded(const Side& side) const {
  const Vector3<RunningError>& line = lines_[side.line].rounded;
  return side.is_opposite ? opposite(line) : line;
}

ExactRay CoverFace::exact(const Line& line) {
  switch (line.kind) {
    case Kind::face_side:
      return cross(exact_face_[line.corner].ray, exact_face_[(line.corner + 1) % 4].ray);
    case Kind::side:
      return cover_.triangle(line.triangle).sides[line.corner];
    case Kind::drawn:
      return cover_.drawn(line.triangle);
    case Kind::nearer:
      break;
  }
  if (!exact_plane_) exact_plane_ = plane_of(exact_face_);
  return nearer(cover_.triangle(line.triangle).plane, *exact_plane_);
}

ExactRay CoverFace::exact(const Side& side) {
  was_exact_ = true;
  Line& line = lines_[side.line];
  if (!line.exact) line.exact = exact(line);
  return side.is_opposite ? opposite(*line.exact) : *line.exact;
}

std::vector<int> CoverFace::signs(const Piece& piece, const Side& side) {
  const Vector3<RunningError> line = rounded(side);
  std::vector<int> result(piece.sides.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = certain_sign(dot(piece.corners[i], line));
    if (result[i] != 0) continue;
    const Side &before = piece.sides[i], &after = piece.sides[(i + 1) % piece.sides.size()];
    if (before.line == side.line || after.line == side.line) continue;  // the corner is on the line
    result[i] = dot(cross(exact(before), exact(after)), exact(side)).sign();
  }
  return result;
}

CoverFace::Piece CoverFace::part(const Piece& piece, const Side& side, const std::vector<int>& signs) const {
  Piece result;
  const std::size_t count = piece.sides.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int from = signs[(i + count - 1) % count], to = signs[i];
    if (from > 0 || to > 0) result.sides.push_back(piece.sides[i]);
    if (from > 0 && to <= 0) result.sides.push_back(side);
  }
  for (std::size_t i = 0; i < result.sides.size(); ++i) {
    result.corners.push_back(cross(rounded(result.sides[i]), rounded(result.sides[(i + 1) % result.sides.size()])));
  }
  return result;
}

std::optional<std::vector<CoverFace::Piece>> CoverFace::less(const Piece& piece, std::span<const Side> triangle) {
  std::vector<Piece> left;
  Piece rest = piece;
  for (const Side& side : triangle) {
    std::vector<int> at = signs(rest, side);
    const bool is_some_inside = std::ranges::any_of(at, [](int sign) { return sign > 0; });
    const bool is_some_outside = std::ranges::any_of(at, [](int sign) { return sign < 0; });
    // Without a line the form is zero everywhere. Either the triangle lies in the plane up to which it is drawn, and is
    // drawn; or it lies in the plane of the face, and hides nothing.
    const bool is_line = is_some_inside || is_some_outside;
    if (!is_some_inside && (is_line || lines_[side.line].kind == Kind::nearer)) return std::nullopt;
    if (!is_some_outside) continue;
    Piece inner = part(rest, side, at);
    for (int& sign : at) sign = -sign;
    left.push_back(part(rest, {side.line, !side.is_opposite}, at));
    rest = std::move(inner);
  }
  return left;
}

bool CoverFace::holds(const std::vector<Side>& sides, std::span<const Vector3<RunningError>> rays) const {
  return std::ranges::all_of(sides, [&](const Side& side) {
    const Vector3<RunningError> line = rounded(side);
    return std::ranges::all_of(rays, [&](const auto& ray) { return certain_sign(dot(line, ray)) > 0; });
  });
}

std::optional<std::vector<CoverFace::Piece>> CoverFace::less_one(const Piece& piece) {
  // The best triangle hides the whole piece. The next best hides its middle, as far as rounded numbers can tell.
  const auto holds_all = [&](const std::vector<Side>& sides) { return holds(sides, piece.corners); };
  if (std::ranges::any_of(of_triangle_, holds_all)) return std::vector<Piece>{};
  Vector3<RunningError> middle = piece.corners[0];
  for (std::size_t i = 1; i < piece.corners.size(); ++i) middle = middle + piece.corners[i];
  const auto holds_middle = [&](const std::vector<Side>& sides) {
    return std::ranges::all_of(sides, [&](const Side& side) { return dot(rounded(side), middle).value > 0; });
  };
  const auto best = std::ranges::find_if(of_triangle_, holds_middle);
  if (best != of_triangle_.end()) {
    if (auto left = less(piece, *best)) return left;
  }
  for (const std::vector<Side>& sides : of_triangle_) {
    if (auto left = less(piece, sides)) return left;
  }
  return std::nullopt;
}

bool CoverFace::is_inside_hidden() {
  Piece whole{{{0, false}, {1, false}, {2, false}, {3, false}}, {}};
  for (std::size_t i = 0; i < 4; ++i) whole.corners.push_back(cross(lines_[i].rounded, lines_[(i + 1) % 4].rounded));
  std::vector<Piece> pieces;
  pieces.push_back(std::move(whole));
  while (!pieces.empty()) {
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    auto left = less_one(piece);
    if (!left) return false;
    std::ranges::move(*left, std::back_inserter(pieces));
  }
  return true;
}

/// Whether a triangle may be as near as the face at some ray that meets both.
bool CoverFace::may_touch(std::uint32_t triangle, const Vector3<RunningError>& nearer) const {
  const auto is_before_all = [&](std::span<const RayPoint<RunningError>> points) {
    return is_beyond(opposite(nearer), points);
  };
  return !is_before_all(face_) && !is_before_all(parts_.triangles[triangle].forms.corners) &&
         !is_beyond(nearer, parts_.triangles[triangle].forms.corners);
}

/// Assume that the inside of the face is hidden and that some point of the face is not. Around this point each piece is
/// hidden by a triangle that comes as near as the face at the point. So the point is on a line where a triangle and the face
/// are equally near, and only such lines are tested.
bool CoverFace::is_border_hidden() {
  cover_.consider(triangles_);
  const auto is_held = [&](std::span<const RayPoint<RunningError>> points) {
    std::vector<Vector3<RunningError>> rays;
    for (const auto& point : points) rays.push_back(point.ray);
    return std::ranges::any_of(of_triangle_, [&](const std::vector<Side>& sides) { return holds(sides, rays); });
  };
  if (is_held(face_)) return true;
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const Side& nearer = of_triangle_[k].back();
    if (!may_touch(triangles_[k], rounded(nearer)) || is_held(parts_.triangles[triangles_[k]].forms.corners)) continue;
    const ExactRay line = exact(nearer);
    if (is_zero(line)) continue;  // the triangle is in the plane of the face
    std::vector<ExactRay> sides;
    for (std::uint32_t i = 0; i < 4; ++i) sides.push_back(exact(Side{i, false}));
    for (std::size_t i = 0; i + 1 < of_triangle_[k].size(); ++i) sides.push_back(exact(of_triangle_[k][i]));
    if (!exact_plane_) exact_plane_ = plane_of(exact_face_);
    if (!cover_.hides_all(line, sides, *exact_plane_)) return false;
  }
  return true;
}

bool CoverFace::is_hidden() { return is_inside_hidden() && is_border_hidden(); }

}  // namespace occlude::kernel
