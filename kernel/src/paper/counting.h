// SPDX-License-Identifier: MIT
// Plain arithmetic that counts every operation in the units of Table 1.
#pragma once

#include "arithmetic.h"
#include "occlude/kernel/operations.h"
#include "vector3.h"

namespace occlude::kernel {

/// The operations of this thread since the counter was last reset.
inline thread_local Operations operation_counter;

struct Counted {
  double value = 0;

  Counted operator-() const { return {-value}; }
  friend Counted operator+(Counted a, Counted b) { return {a.value + b.value}; }
  friend Counted operator-(Counted a, Counted b) { return {a.value - b.value}; }
  friend Counted operator*(Counted a, Counted b) {
    ++operation_counter.scalar;
    return {a.value * b.value};
  }
};

inline Vector3<Counted> operator+(const Vector3<Counted>& a, const Vector3<Counted>& b) {
  ++operation_counter.vector;
  return {{a.x.value + b.x.value}, {a.y.value + b.y.value}, {a.z.value + b.z.value}};
}
inline Vector3<Counted> operator-(const Vector3<Counted>& a, const Vector3<Counted>& b) {
  ++operation_counter.vector;
  return {{a.x.value - b.x.value}, {a.y.value - b.y.value}, {a.z.value - b.z.value}};
}
[[nodiscard]] inline Counted dot(const Vector3<Counted>& a, const Vector3<Counted>& b) {
  ++operation_counter.dot;
  return {a.x.value * b.x.value + a.y.value * b.y.value + a.z.value * b.z.value};
}
[[nodiscard]] inline Vector3<Counted> cross(const Vector3<Counted>& a, const Vector3<Counted>& b) {
  ++operation_counter.cross;
  return {{a.y.value * b.z.value - a.z.value * b.y.value},
          {a.z.value * b.x.value - a.x.value * b.z.value},
          {a.x.value * b.y.value - a.y.value * b.x.value}};
}

struct CountingArithmetic {
  using Number = Counted;
  static Counted constant(double x) { return {x}; }
  static Counted difference(double a, double b) { return {a - b}; }
  static Counted magnitude(Counted x) { return {std::fabs(x.value)}; }
  static double rounded(Counted x) { return x.value; }
  static int sign(Counted x) { return PlainArithmetic::sign(x.value); }
};

template <>
[[nodiscard]] inline Vector3<Counted> difference<CountingArithmetic>(const Vec3& to, const Vec3& from) {
  ++operation_counter.vector;
  return {{to.x - from.x}, {to.y - from.y}, {to.z - from.z}};
}

}  // namespace occlude::kernel
