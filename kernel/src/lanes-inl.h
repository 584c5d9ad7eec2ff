// SPDX-License-Identifier: MIT
// As many doubles as a vector has lanes, as one number of an arithmetic (arithmetic.h). This file is compiled for every
// instruction set of the files that include it.
#if defined(OCCLUDE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCCLUDE_LANES_INL_H
#undef OCCLUDE_LANES_INL_H
#else
#define OCCLUDE_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "planes.h"
#include "vector3.h"

#ifndef OCCLUDE_MAX_LANES
#define OCCLUDE_MAX_LANES
namespace occlude::kernel {

/// Longer vectors are not used, so that reads and writes beyond the end of an array are bounded.
inline constexpr std::size_t kMaxLanes = 8;

}  // namespace occlude::kernel
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, kMaxLanes>;

/// A bit for each lane.
template <class D>
HWY_INLINE unsigned bits(D d, hn::Mask<D> mask) {
  static_assert(hn::MaxLanes(D()) <= 8, "the bits of a mask are one byte");
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(d, mask, stored);
  return stored[0];
}

struct Lanes {
  hn::Vec<Doubles> v;

  Lanes() = default;
  HWY_INLINE Lanes(hn::Vec<Doubles> vector) : v(vector) {}  // NOLINT(google-explicit-constructor): it is this number
  HWY_INLINE Lanes(double x) : v(hn::Set(Doubles(), x)) {}  // NOLINT(google-explicit-constructor): in every lane
  HWY_INLINE static Lanes load(const double* from) { return hn::LoadU(Doubles(), from); }
};

// These stand outside of the class. GCC compiles a friend that is defined in a class for the instruction set of the whole
// library, and passes vectors to it in another way: without optimisation the answers were wrong.
HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
/// a * b + c.
HWY_INLINE Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return hn::MulAdd(a.v, b.v, c.v); }
HWY_INLINE Lanes min(Lanes a, Lanes b) { return hn::Min(a.v, b.v); }
HWY_INLINE Lanes max(Lanes a, Lanes b) { return hn::Max(a.v, b.v); }

HWY_INLINE Vector3<Lanes> operator+(const Vector3<Lanes>& a, const Vector3<Lanes>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vector3<Lanes> operator-(const Vector3<Lanes>& a, const Vector3<Lanes>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Sums the products in an order in which each can be fused with the addition that follows it, which rounds less often.
/// `Number` is Lanes or a number that traces its roundings.
template <class Number>
HWY_INLINE Number fused_dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}
template <class Number>
HWY_INLINE Number fused_dot(const Vector3<Number>& a, const Vector3<Number>& b, const Number& plus) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, multiply_add(a.z, b.z, plus)));
}
HWY_INLINE Lanes dot(const Vector3<Lanes>& a, const Vector3<Lanes>& b) { return fused_dot(a, b); }
HWY_INLINE Lanes dot(const Vector3<Lanes>& a, const Vector3<Lanes>& b, const Lanes& plus) { return fused_dot(a, b, plus); }
HWY_INLINE Vector3<Lanes> magnitudes(const Vector3<Lanes>& a) { return {hn::Abs(a.x.v), hn::Abs(a.y.v), hn::Abs(a.z.v)}; }

struct LaneArithmetic {
  using Number = Lanes;
  HWY_INLINE static Lanes constant(Lanes x) { return x; }
  HWY_INLINE static Lanes difference(Lanes a, Lanes b) { return a - b; }
  HWY_INLINE static Lanes magnitude(Lanes x) { return hn::Abs(x.v); }
  HWY_INLINE static Lanes rounded(Lanes x) { return x; }
};

}  // namespace HWY_NAMESPACE

// The functions of vector3.h would be compiled for the instruction set of the whole library instead.
template <>
[[nodiscard]] HWY_INLINE Vector3<HWY_NAMESPACE::Lanes> constants<HWY_NAMESPACE::LaneArithmetic>(const Vec3& v) {
  return {v.x, v.y, v.z};
}
template <>
[[nodiscard]] HWY_INLINE Vector3<HWY_NAMESPACE::Lanes> difference<HWY_NAMESPACE::LaneArithmetic>(const Vec3& to,
                                                                                                 const Vec3& from) {
  return constants<HWY_NAMESPACE::LaneArithmetic>(to) - constants<HWY_NAMESPACE::LaneArithmetic>(from);
}

}  // namespace occlude::kernel
#define OCCLUDE_FRAME_NAMESPACE HWY_NAMESPACE
#include "aabb_frame-inl.h"
#undef OCCLUDE_FRAME_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
