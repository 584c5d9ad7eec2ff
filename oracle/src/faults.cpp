// SPDX-License-Identifier: MIT
#include "faults.h"

#include <algorithm>
#include <cmath>

#include "half_spaces.h"

namespace occlude::oracle {
namespace {

constexpr double kSmallest = 0x1p-100, kLargest = 0x1p100;

bool is_in_range(double value) { return value == 0 || (std::abs(value) >= kSmallest && std::abs(value) <= kLargest); }

bool are_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool is_finite(const Point& p) { return are_finite(p); }

std::string range_fault(const Point& p) {
  if (!is_finite(p)) return "a number is not finite";
  return std::ranges::all_of(p, is_in_range) ? "" : "a coordinate is out of range";
}

/// The points and vectors that define the box.
std::vector<Point> points_of(const Box& box) {
  if (const Aabb* aabb = std::get_if<Aabb>(&box)) return {aabb->min, aabb->max};
  const auto& [center, half_edges] = std::get<Obb>(box);
  return {center, half_edges[0], half_edges[1], half_edges[2]};
}

bool is_in_order(const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) return false;
  }
  return true;
}

/// Whether the viewpoint lies strictly on the near side of the given plane.
bool is_before(const Viewpoint& view, const Near& near) {
  const auto ahead = [&]<class N>() -> N {
    const Vector<N> eye = vector_of<N>(view.value);
    return vector_of<N>(near.normal) * (view.at_infinity ? eye : vector_of<N>(near.point) - eye);
  };
  return sign_of(ahead) == CGAL::POSITIVE;
}

}  // namespace

std::string box_fault(const Box& box) {
  if (!std::ranges::all_of(points_of(box), is_finite)) return "a number is not finite";
  const Aabb* aabb = std::get_if<Aabb>(&box);
  return !aabb || is_in_order(*aabb) ? "" : "the box has min > max";
}

std::string range_fault(std::span<const Point> points) {
  for (const Point& point : points) {
    if (std::string fault = range_fault(point); !fault.empty()) return fault;
  }
  return "";
}

std::string strict_box_fault(const Box& box) {
  const std::string fault = range_fault(points_of(box));
  return fault.empty() ? box_fault(box) : fault;
}

std::string number_fault(const Viewpoint& view, std::span<const Point> vertices) {
  const std::string fault = range_fault(view.value);
  return fault.empty() ? range_fault(vertices) : fault;
}

std::string setting_fault(const Viewpoint& view, const Near& near) {
  if (!is_finite(near.normal) || !is_finite(near.point)) return "a number is not finite";
  return view.at_infinity && view.value == Point{} ? "the direction of view is zero" : "";
}

std::string plane_fault(const std::array<double, 4>& coefficients) {
  if (!are_finite(coefficients)) return "a number is not finite";
  return std::ranges::all_of(coefficients, is_in_range) ? "" : "a number of the plane is out of range";
}

std::string plane_fault(const Viewpoint& view, std::span<const Point> vertices, const Near& near) {
  Plane plane(GivenPlane{near.normal, near.point});
  const auto covers = [&](const Point& vertex) { return plane.side(vertex) != CGAL::POSITIVE; };
  if (!std::ranges::all_of(vertices, covers)) return "part of the occluder lies behind the near plane";
  return is_before(view, near) ? "" : "the near plane does not face the eye";
}

}  // namespace occlude::oracle
