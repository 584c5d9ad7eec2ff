// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <algorithm>
#include <cstddef>

#include "plane_coefficients.h"

namespace occlude::kernel {

ExactPlane side_plane(const Viewpoint& viewpoint, const Vec3& from, const Vec3& to) {
  if (viewpoint.is_eye()) {
    const Vec3& eye = viewpoint.value;
    return {.direct = false, .a_to = from, .a_from = eye, .b_to = to, .b_from = eye, .origin = eye};
  }
  return {.direct = false, .a_to = viewpoint.value, .a_from = {}, .b_to = to, .b_from = from, .origin = from};
}

namespace {

using Loop = std::pmr::vector<Vec3>;

/// Sign of the dot product of the normals of two planes.
int normals_agree(const ExactPlane& p, const ExactPlane& q) {
  return certified([&]<class A>(A& arithmetic) { return arithmetic.sign(dot(normal<A>(p), normal<A>(q))); });
}

/// Which way the loop turns at `b` seen from the viewpoint.
enum class Turn { left, right, straight, back, none };

/// `none`: two of the three coincide seen from the viewpoint. `back`: the loop reverses its direction.
Turn turn(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b, const Vec3& c) {
  const ExactPlane incoming = side_plane(viewpoint, a, b);
  const int side = sign_at(incoming, c);
  if (side != 0) return side > 0 ? Turn::left : Turn::right;
  const int agreement = normals_agree(incoming, side_plane(viewpoint, b, c));
  return agreement > 0 ? Turn::straight : agreement < 0 ? Turn::back : Turn::none;
}

bool has_three_distinct(std::span<const Vec3> loop) {
  const auto other = std::find_if(loop.begin(), loop.end(), [&](const Vec3& v) { return v != loop[0]; });
  return std::any_of(other, loop.end(), [&](const Vec3& v) { return v != loop[0] && v != *other; });
}

/// Drops vertices at which the loop does not turn until it turns at each; counts what the remaining turns are.
struct Turning {
  Loop corners;
  std::size_t left = 0, right = 0, back = 0;
};

Turning drop_straight(const Viewpoint& viewpoint, std::span<const Vec3> loop, std::pmr::memory_resource& memory) {
  Turning result{.corners = Loop(loop.begin(), loop.end(), &memory)};
  Loop& corners = result.corners;
  for (bool changed = true; changed && corners.size() >= 3;) {
    changed = false;
    result.left = result.right = result.back = 0;
    for (std::size_t i = 0; i < corners.size() && corners.size() >= 3;) {
      const std::size_t n = corners.size();
      const Turn t = turn(viewpoint, corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
      if (t == Turn::straight || t == Turn::none) {
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
        continue;
      }
      ++(t == Turn::left ? result.left : t == Turn::right ? result.right : result.back);
      ++i;
    }
  }
  return result;
}

/// Whether every vertex of the loop is on the inner side of every side plane, and no corner but its own two on the border:
/// then the loop is the border of a convex cone and runs round it once.
bool is_convex(const Viewpoint& viewpoint, const Loop& corners, std::span<const Vec3> loop) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const ExactPlane side = side_plane(viewpoint, corners[i], corners[(i + 1) % n]);
    for (std::size_t j = 2; j < n; ++j) {
      if (sign_at(side, corners[(i + j) % n]) <= 0) return false;
    }
    for (const Vec3& vertex : loop) {
      if (sign_at(side, vertex) < 0) return false;
    }
  }
  return true;
}

}  // namespace

Silhouette silhouette(const Viewpoint& viewpoint, std::span<const Vec3> loop, std::pmr::memory_resource& memory) {
  if (!has_three_distinct(loop)) return {.corners = {}, .refusal = Refusal::too_few_vertices};
  if (viewpoint.is_eye() && std::find(loop.begin(), loop.end(), viewpoint.value) != loop.end()) {
    return {.corners = {}, .refusal = Refusal::eye_in_plane};
  }
  auto [corners, left, right, back] = drop_straight(viewpoint, loop, memory);
  if (left + right == 0) return {.corners = {}, .refusal = Refusal::eye_in_plane};
  if (corners.size() < 3 || back != 0 || (left != 0 && right != 0)) {
    return {.corners = {}, .refusal = Refusal::not_convex};
  }
  if (right != 0) std::reverse(corners.begin(), corners.end());
  if (!is_convex(viewpoint, corners, loop)) return {.corners = {}, .refusal = Refusal::not_convex};
  return {.corners = std::move(corners)};
}

}  // namespace occlude::kernel
