// SPDX-License-Identifier: MIT
#include "frames.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "lattice.h"

namespace occlude::fuzz {
namespace {

/// The integer vector in lowest terms.
Vec3 reduced(const Vec3& v) {
  const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
  const std::int64_t divisor = std::gcd(std::gcd(whole(v.x), whole(v.y)), whole(v.z));
  if (divisor < 2) return v;
  const auto d = static_cast<double>(divisor);
  return {v.x / d, v.y / d, v.z / d};
}

/// The columns of the rotation by the quaternion w + v, times its squared norm. For an integer quaternion they are integers.
Frame quaternion_frame(double w, const Vec3& v) {
  const double ww = w * w, xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
  return {{{ww + xx - yy - zz, 2 * (v.x * v.y + w * v.z), 2 * (v.x * v.z - w * v.y)},
           {2 * (v.x * v.y - w * v.z), ww - xx + yy - zz, 2 * (v.y * v.z + w * v.x)},
           {2 * (v.x * v.z + w * v.y), 2 * (v.y * v.z - w * v.x), ww - xx - yy + zz}}};
}

Frame axes_frame(Random& random) {
  const int shift = random.integer(0, 2);
  Frame frame{};
  for (int i = 0; i < 3; ++i) frame[static_cast<std::size_t>(i)][(i + shift) % 3] = random.chance(0.5) ? 1 : -1;
  if (random.chance(0.5)) std::swap(frame[0], frame[1]);
  return frame;
}

Frame rotated_frame(Random& random) {
  const double w = random.integer(1, 3);
  Frame frame = quaternion_frame(w, lattice_vector(random, 2));
  for (Vec3& e : frame) e = reduced(e);
  return frame;
}

Frame skew_frame(Random& random) {
  while (true) {
    const int reach = random.integer(1, 4);
    const Vec3 e = lattice_vector(random, reach), f = lattice_vector(random, reach), g = lattice_vector(random, reach);
    if (dot(cross(e, f), g) != 0) return {e, f, g};
  }
}

Frame dependent_frame(Random& random) {
  while (true) {
    const Vec3 e = lattice_vector(random, 3), f = lattice_vector(random, 3);
    if (cross(e, f) == Vec3{}) continue;
    const double a = random.integer(-2, 2), b = random.integer(1, 2);
    return {e, f, a * e + b * f};
  }
}

/// The direction of a ray, of an edge of the silhouette or of an edge of the near plane `farthest`, in lowest terms.
Vec3 frustum_edge(Random& random, const Scene& scene, const Loop& silhouette, std::size_t side, const Vec3& farthest) {
  const Vec3& a = scene.vertices[silhouette[side]];
  const Vec3& b = scene.vertices[silhouette[(side + 1) % silhouette.size()]];
  const int kind = random.integer(0, scene.near == Near::farthest ? 3 : 2);
  return reduced(kind == 0   ? sight(scene, a)
                 : kind == 1 ? sight(scene, b)
                 : kind == 2 ? b - a
                             : cross(cross(sight(scene, a), b - a), farthest));
}

Frame parallel_frame(Random& random, const Scene& scene, const Outline& outline) {
  const Vec3 farthest = sight(scene, scene.vertices[farthest_vertex(scene, outline)]);
  const std::size_t side = random.index(outline.silhouette.size());
  Frame frame = lattice_frame(random);
  const int along = random.integer(1, 3);
  for (int i = 0; i < along; ++i) {
    const std::size_t at = random.chance(0.7) ? side : random.index(outline.silhouette.size());
    frame[static_cast<std::size_t>(i)] = frustum_edge(random, scene, outline.silhouette, at, farthest);
  }
  return frame;
}

Frame large_frame(Random& random) {
  constexpr int kReach = 1 << 12;
  const Vec3 e = lattice_vector(random, kReach), f = lattice_vector(random, kReach), g = lattice_vector(random, kReach);
  return {e, f, g};
}

Frame real_frame(Random& random) {
  if (random.chance(0.5)) {
    const double w = random.real(-1, 1);
    return quaternion_frame(w, random_vector(random, 1));
  }
  const Vec3 e = random_vector(random, 1), f = random_vector(random, 1), g = random_vector(random, 1);
  return {e, f, g};
}

}  // namespace

Frame lattice_frame(Random& random) { return random.chance(0.5) ? rotated_frame(random) : skew_frame(random); }

Frame make_frame(Random& random, FrameKind kind, const Scene& scene, const Outline& outline) {
  switch (kind) {
    case FrameKind::axes:
      return axes_frame(random);
    case FrameKind::lattice:
      return lattice_frame(random);
    case FrameKind::dependent:
      return dependent_frame(random);
    case FrameKind::parallel:
      return parallel_frame(random, scene, outline);
    case FrameKind::large:
      return large_frame(random);
    case FrameKind::real:
      return real_frame(random);
  }
  return kUnitFrame;
}

}  // namespace occlude::fuzz
