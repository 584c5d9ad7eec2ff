// SPDX-License-Identifier: MIT
#include "cover_hidden.h"

#include <algorithm>
#include <numeric>

namespace occlude::kernel {
namespace {

bool is_within(const ExactRay& ray, std::span<const ExactRay> sides) {
  return std::ranges::all_of(sides, [&](const ExactRay& side) { return dot(side, ray).sign() >= 0; });
}

bool is_same_ray(const ExactRay& a, const ExactRay& b) { return is_zero(cross(a, b)) && dot(a, b).sign() > 0; }

bool is_nearer(const PlaneForm<BigInteger>& first, const PlaneForm<BigInteger>& second, const ExactRay& ray) {
  return dot(nearer(first, second), ray).sign() > 0;
}

}  // namespace

PlaneForm<BigInteger> plane_across(const RayPoint<BigInteger>& point) {
  return {point.nearness * point.ray, dot(point.ray, point.ray)};
}

PlaneForm<BigInteger> plane_through(const RayPoint<BigInteger>& a, const RayPoint<BigInteger>& b, const ExactRay& line) {
  return {a.nearness * cross(b.ray, line) + b.nearness * cross(line, a.ray), dot(line, line)};
}

ExactCover::ExactCover(const CoverParts& parts, int shift)
    : parts_(parts), units_(shift), triangles_(parts.triangles.size()), considered_(parts.triangles.size()) {
  std::iota(considered_.begin(), considered_.end(), std::uint32_t{0});
}

const TriangleForms<BigInteger>& ExactCover::triangle(std::size_t i) {
  if (!triangles_[i]) triangles_[i] = triangle_forms(parts_.rays, units_, parts_.triangles[i].corners);
  return *triangles_[i];
}

ExactRay ExactCover::drawn(std::size_t i) { return side_of(triangle(i).plane, parts_.rays.form(units_, *parts_.drawn)); }

const std::vector<ExactCover::Arc>& ExactCover::arcs() {
  if (arcs_) return *arcs_;
  arcs_.emplace();
  for (const CoverArc& given : parts_.arcs) {
    Arc arc{parts_.rays.point(units_, given.from), parts_.rays.point(units_, given.to), {}, {}, given.is_at_viewpoint};
    arc.line = cross(arc.from.ray, arc.to.ray);
    if (!is_zero(arc.line)) arc.plane = plane_through(arc.from, arc.to, arc.line);
    arcs_->push_back(std::move(arc));
  }
  return *arcs_;
}

bool ExactCover::hides(std::size_t i, const ExactRay& ray, const PlaneForm<BigInteger>& plane) {
  const TriangleForms<BigInteger>& forms = triangle(i);
  return is_within(ray, forms.sides) && is_nearer(forms.plane, plane, ray) &&
         (!parts_.drawn || dot(drawn(i), ray).sign() >= 0);
}

bool ExactCover::hides(const Arc& arc, const ExactRay& ray, const PlaneForm<BigInteger>& plane) {
  if (is_zero(arc.line)) {
    const auto does = [&](const RayPoint<BigInteger>& end) {
      return is_same_ray(end.ray, ray) && (arc.is_at_viewpoint || is_nearer(plane_across(end), plane, ray));
    };
    return does(arc.from) || does(arc.to);
  }
  const bool is_on = dot(arc.line, ray).sign() == 0 && dot(cross(arc.from.ray, ray), arc.line).sign() >= 0 &&
                     dot(cross(ray, arc.to.ray), arc.line).sign() >= 0;
  return is_on && (arc.is_at_viewpoint || is_nearer(arc.plane, plane, ray));
}

bool ExactCover::hides(const ExactRay& ray, const PlaneForm<BigInteger>& plane) {
  if (std::ranges::any_of(considered_, [&](std::uint32_t i) { return hides(i, ray, plane); })) return true;
  return std::ranges::any_of(arcs(), [&](const Arc& arc) { return hides(arc, ray, plane); });
}

std::vector<ExactRay> ExactCover::lines(const PlaneForm<BigInteger>& plane) {
  std::vector<ExactRay> all;
  for (const std::uint32_t i : considered_) {
    const TriangleForms<BigInteger>& forms = triangle(i);
    all.insert(all.end(), forms.sides.begin(), forms.sides.end());
    all.push_back(nearer(forms.plane, plane));
    if (parts_.drawn) all.push_back(drawn(i));
  }
  for (const Arc& arc : arcs()) {
    if (is_zero(arc.line)) continue;
    // The line of the arc, the lines across it at its ends, and the line where it gets nearer than the plane.
    all.insert(all.end(), {arc.line, cross(arc.from.ray, arc.line), cross(arc.line, arc.to.ray)});
    all.push_back(nearer(arc.plane, plane));
  }
  return all;
}

bool ExactCover::hides_all(const ExactRay& line, std::span<const ExactRay> sides, const PlaneForm<BigInteger>& plane) {
  std::vector<ExactRay> rays;
  const auto add = [&](const ExactRay& ray) {
    if (!is_zero(ray) && dot(line, ray).sign() == 0 && is_within(ray, sides)) rays.push_back(ray);
  };
  const auto add_both = [&](const ExactRay& ray) {
    add(ray);
    add({-ray.x, -ray.y, -ray.z});
  };
  for (const ExactRay& side : sides) add_both(cross(line, side));
  if (rays.empty()) return true;
  for (const ExactRay& other : lines(plane)) add_both(cross(line, other));
  for (const Arc& arc : arcs()) {
    add(arc.from.ray);
    add(arc.to.ray);
  }
  std::ranges::sort(rays, [&](const ExactRay& a, const ExactRay& b) { return dot(cross(a, b), line).sign() > 0; });
  rays.erase(std::unique(rays.begin(), rays.end(), is_same_ray), rays.end());
  // The answer can change only at these rays, so it is enough to test each of them and one ray between each two.
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hides(rays[i], plane)) return false;
    if (i > 0 && !hides(rays[i - 1] + rays[i], plane)) return false;
  }
  return true;
}

}  // namespace occlude::kernel
