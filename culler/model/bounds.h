// SPDX-License-Identifier: MIT
// Small computations on boxes and loops, and conversions between GLM and the kernel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <span>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

[[nodiscard]] inline kernel::Vec3 to_kernel(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline glm::dvec3 to_glm(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

/// The empty box. Growing it by a point makes it that point.
[[nodiscard]] inline kernel::Aabb empty_box() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

inline void grow(kernel::Aabb& box, const kernel::Aabb& other) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::min(box.min[axis], other.min[axis]);
    box.max[axis] = std::max(box.max[axis], other.max[axis]);
  }
}

inline void grow(kernel::Aabb& box, const kernel::Vec3& point) { grow(box, kernel::Aabb{point, point}); }

/// The middle between two points, rounded.
[[nodiscard]] inline kernel::Vec3 middle(const kernel::Vec3& a, const kernel::Vec3& b) {
  return {std::midpoint(a.x, b.x), std::midpoint(a.y, b.y), std::midpoint(a.z, b.z)};
}
[[nodiscard]] inline kernel::Vec3 middle(const kernel::Aabb& box) { return middle(box.min, box.max); }

/// Corner i of 8: where bit k of i is set, coordinate k is the larger.
[[nodiscard]] inline kernel::Vec3 corner(const kernel::Aabb& box, unsigned i) {
  return {i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y, i & 4U ? box.max.z : box.min.z};
}

/// The largest distance of a point of the box from the eye, as the sum over the axes.
[[nodiscard]] inline double depth(const kernel::Aabb& box, const glm::dvec3& eye) {
  glm::dvec3 farthest{};
  for (int axis = 0; axis < 3; ++axis) {
    farthest[axis] = std::max(std::fabs(box.min[axis] - eye[axis]), std::fabs(box.max[axis] - eye[axis]));
  }
  return farthest.x + farthest.y + farthest.z;
}

/// The longest edge of a non-empty box.
[[nodiscard]] inline double length_of(const kernel::Aabb& box) {
  return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
}

/// Between the points of two boxes that are nearest to each other.
[[nodiscard]] inline double distance(const kernel::Aabb& a, const kernel::Aabb& b) {
  glm::dvec3 apart{};
  for (int axis = 0; axis < 3; ++axis) apart[axis] = std::max({0.0, a.min[axis] - b.max[axis], b.min[axis] - a.max[axis]});
  return glm::length(apart);
}

/// Half the surface of a non-empty box.
[[nodiscard]] inline double half_area(const kernel::Aabb& box) {
  const double x = box.max.x - box.min.x, y = box.max.y - box.min.y, z = box.max.z - box.min.z;
  return x * y + y * z + z * x;
}

/// The sum of the three edges of a non-empty box. Random planes meet convex bodies in proportion to their mean width, which
/// for a box is half of this (Cauchy, Crofton).
[[nodiscard]] inline double total_width(const kernel::Aabb& box) {
  return (box.max.x - box.min.x) + (box.max.y - box.min.y) + (box.max.z - box.min.z);
}

/// Twice the area of a loop of vertices, along its mean normal, up to rounding.
[[nodiscard]] inline glm::dvec3 doubled_area(SoupView soup, std::span<const std::uint32_t> loop) {
  const glm::dvec3& base = soup.vertices[loop[0]];
  glm::dvec3 sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += glm::cross(soup.vertices[loop[i]] - base, soup.vertices[loop[i + 1]] - base);
  }
  return sum;
}

/// The least of normal . (x - origin) over the points x of a box, up to rounding.
[[nodiscard]] inline double least(const glm::dvec3& normal, const kernel::Vec3& origin, const kernel::Aabb& box) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += std::min(normal[axis] * (box.min[axis] - origin[axis]), normal[axis] * (box.max[axis] - origin[axis]));
  }
  return sum;
}

[[nodiscard]] inline double least(const glm::dvec3& normal, const kernel::Vec3& origin, const kernel::Obb& box) {
  double sum = glm::dot(normal, to_glm(box.center) - to_glm(origin));
  for (const kernel::Vec3& edge : box.half_edges) sum -= std::fabs(glm::dot(normal, to_glm(edge)));
  return sum;
}

/// Whether the half-space, relative to the origin, contains the box, up to rounding.
template <class AnyBox>
[[nodiscard]] bool holds(const kernel::HalfSpace& half_space, const kernel::Vec3& origin, const AnyBox& box) {
  return least(to_glm(half_space.normal), origin, box) >= -half_space.offset;
}

}  // namespace occlude::culler
