// SPDX-License-Identifier: MIT
#include "rivals.h"

#include <variant>

#include "paper/plain_overlap.h"

namespace occlude::fuzz {
namespace {

using kernel::PlainArithmetic;

struct Float32Arithmetic {
  using Number = Float32;
  static Float32 constant(double x) { return Float32::rounded(x); }
  static Float32 difference(double a, double b) { return constant(a) - constant(b); }
  static Float32 magnitude(Float32 x) { return {std::fabs(x.value)}; }
  static double rounded(Float32 x) { return x.value; }
  static int sign(Float32 x) { return PlainArithmetic::sign(x.value); }
};

struct FusedArithmetic {
  using Number = Fused;
  static Fused constant(double x) { return {x}; }
  static Fused difference(double a, double b) { return {a - b}; }
  static Fused magnitude(Fused x) { return {std::fabs(x.value)}; }
  static double rounded(Fused x) { return x.value; }
  static int sign(Fused x) { return PlainArithmetic::sign(x.value); }
};

template <class A>
kernel::Relation overlap_in(const kernel::ShadowFrustum& frustum, const Box& box) {
  const auto ask = [&](const auto& kind) { return kernel::plain_overlap<A>(frustum, kind, kernel::NearBoundary::closed); };
  return std::visit(ask, box);
}

}  // namespace

kernel::Relation overlap_float32(const kernel::ShadowFrustum& frustum, const Box& box) {
  return overlap_in<Float32Arithmetic>(frustum, box);
}

kernel::Relation overlap_fused(const kernel::ShadowFrustum& frustum, const Box& box) {
  return overlap_in<FusedArithmetic>(frustum, box);
}

}  // namespace occlude::fuzz
