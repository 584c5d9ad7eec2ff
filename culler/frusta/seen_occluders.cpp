// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. The best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frusta/seen_occluders.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include "frusta/seen_occluders.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One occluder per lane. Nothing is fused, so the results do not depend on the number of lanes.
using DoubleTag = hn::CappedTag<double, 8>;
using Lanes = hn::Vec<DoubleTag>;
using Mask = hn::Mask<DoubleTag>;

constexpr DoubleTag kD;

struct Vectors {
  Lanes x, y, z;
};

HWY_INLINE Vectors load(const std::array<SeenOccluders::Doubles, 3>& of_axes, std::size_t i) {
  return {hn::Load(kD, &of_axes[0][i]), hn::Load(kD, &of_axes[1][i]), hn::Load(kD, &of_axes[2][i])};
}
HWY_INLINE Vectors set(const glm::dvec3& v) { return {hn::Set(kD, v.x), hn::Set(kD, v.y), hn::Set(kD, v.z)}; }
HWY_INLINE Lanes dot(const Vectors& a, const Vectors& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(kD, mask, bits);
  return bits[0];
}

/// Does what PotentialOccluder::area_angle() does.
HWY_INLINE Lanes area_angle(const Vectors& centre, const Vectors& normal, Lanes round_area, const Vectors& eye) {
  const Vectors v{hn::Sub(centre.x, eye.x), hn::Sub(centre.y, eye.y), hn::Sub(centre.z, eye.z)};
  const Lanes squared = dot(v, v), distance = hn::Sqrt(squared);
  const Lanes area = hn::Add(hn::Abs(dot(normal, v)), hn::Mul(round_area, distance));
  return hn::IfThenZeroElse(hn::Eq(squared, hn::Zero(kD)), hn::Div(area, hn::Mul(squared, distance)));
}

void see(const glm::dvec3& eye, std::span<const HalfSpace> view, SeenOccluders& occluders) {
  const Vectors from = set(eye);
  occluders.in_view = 0;
  for (std::size_t i = 0; i < occluders.size; i += hn::Lanes(kD)) {
    const Vectors centre = load(occluders.centre, i), normal = load(occluders.normal, i);
    const Lanes least = hn::Neg(hn::Load(kD, &occluders.radius[i]));
    Mask is_beyond = hn::Lt(hn::Zero(kD), hn::Zero(kD));
    for (const HalfSpace& h : view) {
      const Lanes height = hn::Add(dot(set(h.normal), centre), hn::Set(kD, h.offset));
      is_beyond = hn::Or(is_beyond, hn::Lt(height, least));
    }
    occluders.in_view |= bits_of(hn::Not(is_beyond)) << i;
    hn::Store(area_angle(centre, normal, hn::Load(kD, &occluders.round_area[i]), from), kD, &occluders.angle[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::culler {
namespace {
HWY_EXPORT(see);
}  // namespace

void SeenOccluders::add(const PotentialOccluder& occluder) {
  for (int axis = 0; axis < 3; ++axis) {
    centre[static_cast<std::size_t>(axis)][size] = occluder.centre[axis];
    normal[static_cast<std::size_t>(axis)][size] = occluder.area_normal[axis];
  }
  radius[size] = occluder.radius;
  round_area[size] = occluder.round_area;
  ++size;
}

void SeenOccluders::see(const glm::dvec3& eye, std::span<const HalfSpace> view) {
  HWY_DYNAMIC_DISPATCH(see)(eye, view, *this);
  in_view &= static_cast<std::uint32_t>((std::uint64_t{1} << size) - 1);
}

}  // namespace occlude::culler
#endif
