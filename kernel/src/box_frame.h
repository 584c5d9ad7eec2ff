// SPDX-License-Identifier: MIT
// A box as the filter sees it: in doubles, relative to the origin of a frustum.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "occlude/kernel/planes.h"
#include "occlude/kernel/types.h"
#include "vector3.h"

namespace occlude::kernel {

/// What the numbers of an arithmetic are rounded to: doubles, unless it is one that follows every rounding.
template <class A>
using Real = decltype(A::rounded(std::declval<typename A::Number>()));

template <class A>
[[nodiscard]] Real<A> product(const Real<A>& a, const Real<A>& b) {
  return A::rounded(A::constant(a) * A::constant(b));
}

/// Values of a plane over a box: at its centre, and what they gain from there to a vertex at most.
template <class Real>
struct Extremes {
  Real middle, spread;
  [[nodiscard]] Real low() const { return middle - spread; }
  [[nodiscard]] Real high() const { return middle + spread; }
};

/// Sums and differences of the bounds of an axis-aligned box relative to the origin of a frustum, twice its centre and half
/// extents: in them both extremal vertices of every plane are alike to find, without asking for signs. Values and errors are
/// twice those of the planes. `A` is PlainArithmetic or CountingArithmetic.
template <class A>
class AabbFrame {
 public:
  AabbFrame(const Aabb& box, const Vec3& origin) {
    const auto low = difference<A>(box.min, origin), high = difference<A>(box.max, origin);
    sum_ = high + low;
    extent_ = high - low;
    const auto largest = [](const auto& s, const auto& e) { return A::rounded(A::magnitude(s)) + A::rounded(e); };
    twice_reach_ = std::max(std::max(largest(sum_.x, extent_.x), largest(sum_.y, extent_.y)), largest(sum_.z, extent_.z));
  }

  [[nodiscard]] Extremes<Real<A>> extremes(const FilterPlane& p) const {
    return {A::rounded(dot(constants<A>(p.normal), sum_)) + (p.offset + p.offset),
            A::rounded(dot(constants<A>(p.magnitudes), extent_))};
  }
  /// What rounding can do to the values of planes with this bound.
  template <class Bound>
  [[nodiscard]] Real<A> error(const Bound& bound) const {
    return product<A>(bound.slope, twice_reach_) + (bound.base + bound.base);
  }
  [[nodiscard]] Real<A> reach() const { return 0.5 * twice_reach_; }

 private:
  Vector3<typename A::Number> sum_, extent_;
  Real<A> twice_reach_;
};

/// The centre of an oriented box, rounded once, its half edges, and how far it can reach.
template <class A>
class ObbFrame {
 public:
  ObbFrame(const Obb& box, const Vec3& origin) : center_(difference<A>(box.center, origin)), half_edges_(box.half_edges) {
    const auto largest = [](const auto& v) {
      const auto magnitude = [&](int k) { return A::rounded(A::magnitude(v[k])); };
      return std::max({magnitude(0), magnitude(1), magnitude(2)});
    };
    reach_ = largest(center_);
    for (const Vec3& half_edge : half_edges_) reach_ = reach_ + largest(constants<A>(half_edge));
  }

  /// Three more dot products per plane (section 5.3).
  [[nodiscard]] Extremes<Real<A>> extremes(const FilterPlane& p) const {
    const auto normal = constants<A>(p.normal);
    const auto spread_along = [&](int k) {
      return A::rounded(A::magnitude(dot(normal, constants<A>(half_edges_[static_cast<std::size_t>(k)]))));
    };
    return {A::rounded(dot(normal, center_)) + p.offset, spread_along(0) + spread_along(1) + spread_along(2)};
  }
  template <class Bound>
  [[nodiscard]] Real<A> error(const Bound& bound) const {
    return product<A>(bound.slope, reach_) + bound.base;
  }
  [[nodiscard]] Real<A> reach() const { return reach_; }

 private:
  Vector3<typename A::Number> center_;
  std::array<Vec3, 3> half_edges_;
  Real<A> reach_;
};

template <class A>
[[nodiscard]] AabbFrame<A> frame_of(const Aabb& box, const Vec3& origin) {
  return {box, origin};
}
template <class A>
[[nodiscard]] ObbFrame<A> frame_of(const Obb& box, const Vec3& origin) {
  return {box, origin};
}

}  // namespace occlude::kernel
