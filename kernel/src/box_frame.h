// SPDX-License-Identifier: MIT
// A box as the filter sees it: in doubles, relative to the origin of a frustum.
#pragma once

#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "occlude/kernel/types.h"
#include "planes.h"
#include "vector3.h"

#define OCCLUDE_FRAME_NAMESPACE one_box
#include "aabb_frame-inl.h"
#undef OCCLUDE_FRAME_NAMESPACE

namespace occlude::kernel {

using one_box::AabbFrame;
using one_box::Extremes;
using one_box::product;
using one_box::Real;

/// The centre of an oriented box relative to the origin, rounded once, its half edges, and an upper bound on its reach.
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

  /// An oriented box takes three more dot products per plane (section 5.3).
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
