// SPDX-License-Identifier: MIT
// Vectors over any number type of arithmetic.h.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Lexicographic order.
[[nodiscard]] inline bool precedes(const Vec3& a, const Vec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

template <class Number>
struct Vector3 {
  Number x, y, z;

  const Number& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

template <class Number>
[[nodiscard]] Vector3<Number> operator+(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> operator*(const Number& s, const Vector3<Number>& v) {
  return {s * v.x, s * v.y, s * v.z};
}

template <class Number>
[[nodiscard]] Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
[[nodiscard]] Number dot(const Vector3<Number>& a, const Vector3<Number>& b, const Number& plus) {
  return dot(a, b) + plus;
}

template <class Number>
[[nodiscard]] Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The cross product of vectors whose components are differences of given doubles.
template <class Number>
[[nodiscard]] Vector3<Number> cross_of_differences(const Vector3<Number>& a, const Vector3<Number>& b) {
  return cross(a, b);
}

/// v, in the numbers of arithmetic A.
template <class A>
[[nodiscard]] Vector3<typename A::Number> constants(const Vec3& v) {
  return {A::constant(v.x), A::constant(v.y), A::constant(v.z)};
}

/// to - from, in the numbers of arithmetic A.
template <class A>
[[nodiscard]] Vector3<typename A::Number> difference(const Vec3& to, const Vec3& from) {
  return {A::difference(to.x, from.x), A::difference(to.y, from.y), A::difference(to.z, from.z)};
}

}  // namespace occlude::kernel
