// SPDX-License-Identifier: MIT
#include "workloads.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "occlude/fuzz/random.h"
#include "touching.h"
#include "vector_math.h"

namespace occlude::bench {
namespace {

using fuzz::Random;
using kernel::Aabb;

using Loop = std::array<Vec3, 4>;

/// With the edges `u` and `v` at `corner`.
Loop parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
  return {corner, corner + u, corner + u + v, corner + v};
}

kernel::ShadowFrustum shadow_of(const Vec3& eye, const Loop& loop) {
  auto result = kernel::ShadowFrustum::make(kernel::Viewpoint::eye(eye), loop, kernel::Near::surface);
  if (!result.frustum || result.frustum->support_plane()) throw std::logic_error("the benchmark's occluder is not plane");
  return *std::move(result.frustum);
}

/// Moves each coordinate by up to `distance`, then rounds it to a multiple of 2^-20. Sums of such vectors are exact, so a
/// parallelogram made of them is exactly coplanar.
Vec3 jittered(Vec3 v, double distance, Random& random) {
  for (int axis = 0; axis < 3; ++axis) v[axis] = std::round((v[axis] + random.real(-distance, distance)) * 0x1p20) * 0x1p-20;
  return v;
}

/// The frustum of an occluder 2 units wide, 5 units in front of an eye whose coordinates use all their bits.
kernel::ShadowFrustum generic_frustum(Random& random) {
  const Vec3 eye{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  constexpr double kJitter = 0.1;
  const Vec3 corner = jittered(eye + Vec3{5, -1, -1}, kJitter, random);
  const Vec3 u = jittered({0.3, 2, 0.1}, kJitter, random), v = jittered({-0.2, 0.15, 2}, kJitter, random);
  return shadow_of(eye, parallelogram(corner, u, v));
}

/// An eye before a wall, in whole numbers.
constexpr Vec3 kWholeEye{1, 2, 3};
Loop whole_wall() { return parallelogram({7, -2, 1}, {4, 8, 0}, {0, 0, 4}); }

/// A hundredth of each number, rounded: what is read from a file that is written in centimetres and with a point.
Vec3 hundredth(const Vec3& v) { return {v.x / 100, v.y / 100, v.z / 100}; }

/// The wall stands upright, so its corners stay exactly coplanar.
kernel::ShadowFrustum decimal_frustum() {
  Loop wall = whole_wall();
  for (Vec3& corner : wall) corner = hundredth(corner);
  return shadow_of(hundredth(kWholeEye), wall);
}

/// A box near the shadow, up to five times as far from the eye as the occluder. All orders of magnitude of its size are
/// equally likely.
Aabb random_box(const Vec3& eye, Random& random) {
  const Vec3 middle = eye + Vec3{random.real(4, 25), random.real(-5, 5), random.real(-5, 5)};
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = std::ldexp(random.real(1, 2), random.integer(-4, 0));
  return {middle - half, middle + half};
}

template <class Make>
Workload workload(const char* name, const char* about, kernel::ShadowFrustum frustum, std::size_t count, Make&& make) {
  Workload made{name, about, std::move(frustum), {}};
  made.boxes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) made.boxes.push_back(make(made.frustum));
  return made;
}

}  // namespace

std::vector<Workload> make_workloads(std::size_t boxes, std::uint64_t seed) {
  Random random(seed);
  const kernel::ShadowFrustum generic = generic_frustum(random), whole = shadow_of(kWholeEye, whole_wall());
  return {
      workload("random", "boxes of 1/8 to 4 units strewn about the shadow of an occluder of 2 units", generic, boxes,
               [&](const auto& frustum) { return random_box(frustum.viewpoint().value, random); }),
      workload("integer_touching", "whole coordinates, each box touches a plane, an edge or a vertex exactly", whole, boxes,
               [&](const auto& frustum) { return touching_box(frustum, Numbers::whole, random); }),
      workload("ulp_touching", "each box touches up to rounding and is moved by -2 to 2 ulps", generic, boxes,
               [&](const auto& frustum) { return nudged(touching_box(frustum, Numbers::real, random), random); }),
      workload("decimal", "hundredths of whole coordinates, each box touches up to their rounding", decimal_frustum(), boxes,
               [&](const auto&) {
                 const Aabb box = touching_box(whole, Numbers::whole, random);
                 return Aabb{hundredth(box.min), hundredth(box.max)};
               }),
  };
}

}  // namespace occlude::bench
