// SPDX-License-Identifier: MIT
// A box as the paper's box-plane stage sees it (section 5.3).
#pragma once

#include <array>
#include <cstddef>

#include "box_frame.h"

namespace occlude::kernel {

/// The bounds of an axis-aligned box. The normal of a plane picks two of its eight vertices.
template <class A>
class CornerFrame {
 public:
  CornerFrame(const Aabb& box, const Vec3& origin) {
    const auto low = difference<A>(box.min, origin), high = difference<A>(box.max, origin);
    bounds_ = {low.x, low.y, low.z, A::constant(0), high.x, high.y, high.z, A::constant(0)};
  }

  class PlainExtremes {
   public:
    PlainExtremes(const CornerFrame& frame, const FilterPlane& plane) : frame_(frame), plane_(plane) {}
    [[nodiscard]] double low() const { return frame_.at(plane_, 4); }
    [[nodiscard]] double high() const { return frame_.at(plane_, 0); }

   private:
    const CornerFrame& frame_;
    const FilterPlane& plane_;
  };
  /// The values at the two vertices, each computed when it is asked for.
  [[nodiscard]] PlainExtremes extremes(const FilterPlane& p) const { return {*this, p}; }

 private:
  [[nodiscard]] double at(const FilterPlane& p, std::size_t opposite) const {
    const Vector3<typename A::Number> vertex{bounds_[p.farther[0] ^ opposite], bounds_[p.farther[1] ^ opposite],
                                             bounds_[p.farther[2] ^ opposite]};
    return A::rounded(dot(constants<A>(p.normal), vertex)) + p.offset;
  }

  std::array<typename A::Number, 8> bounds_;
};

template <class A>
[[nodiscard]] CornerFrame<A> plain_frame_of(const Aabb& box, const Vec3& origin) {
  return {box, origin};
}
template <class A>
[[nodiscard]] ObbFrame<A> plain_frame_of(const Obb& box, const Vec3& origin) {
  return {box, origin};
}

}  // namespace occlude::kernel
