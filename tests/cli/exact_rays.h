// SPDX-License-Identifier: MIT
// Whether anything is before a point of a model: exactly. For programs that try what commands claim.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/oracle/ray.h"
#include "occlude/render/tree_rays.h"
#include "triangles.h"

/// Whether the ray from an eye through a point meets the triangle, and no opaque polygon of the tree before.
inline bool is_clear(const occlude::culler::Hierarchy& tree, const occlude::render::TreeRays& rays, const glm::dvec3& eye,
                     const glm::dvec3& point, const occlude::oracle::Triangle& aim) {
  using occlude::oracle::Ray;
  const Ray ray({{eye.x, eye.y, eye.z}, false}, {point.x, point.y, point.z});
  if (!ray.enters(aim, {})) return false;
  constexpr double kEnd = 1.01;  // the point is on the triangle, but for its rounding
  return !rays.any_of(eye, point - eye, kEnd, [&](std::uint32_t p) {
    bool hides = false;
    occlude::proof::for_each_triangle(tree.soup(), p, [&](const occlude::oracle::Triangle& other) {
      hides = hides || ray.order(aim, other, {0, 0, 0, 1}) == Ray::Order::nearer;
    });
    return hides;
  });
}
