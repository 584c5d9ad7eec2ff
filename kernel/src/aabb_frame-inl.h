// SPDX-License-Identifier: MIT
// An axis-aligned box as the filter sees it: relative to the origin of a frustum. One template for all who ask: a box in
// doubles, many boxes or many frusta in the lanes of vectors, and arithmetics that count or trace. Included by box_frame.h
// for the machine that everything is compiled for, by lanes-inl.h for every instruction set; they name the namespace.

namespace occlude::kernel {
namespace OCCLUDE_FRAME_NAMESPACE {

/// The type that the numbers of an arithmetic are rounded to. It is the number type itself, unless the numbers count
/// operations.
template <class A>
using Real = decltype(A::rounded(std::declval<typename A::Number>()));

template <class A>
[[nodiscard]] HWY_INLINE Real<A> product(const Real<A>& a, const Real<A>& b) {
  return A::rounded(A::constant(a) * A::constant(b));
}

/// The values of a plane over a box: the value at the centre, and the most that it changes from there to a vertex.
template <class Real>
struct Extremes {
  Real middle, spread;
  [[nodiscard]] HWY_INLINE Real low() const { return middle - spread; }
  [[nodiscard]] HWY_INLINE Real high() const { return middle + spread; }
};

/// Stores sums and differences of the bounds of an axis-aligned box, relative to the origin of a frustum. They are twice its
/// centre and twice its half extents. With them, both extremal vertices of every plane are found by the same formula,
/// without a question about signs. Values and errors are twice those of the planes. `A` is an arithmetic of which no sign is
/// asked (arithmetic.h).
template <class A>
class AabbFrame {
 public:
  using Vector = Vector3<typename A::Number>;

  /// The bounds are relative to the origin.
  HWY_INLINE AabbFrame(const Vector& min, const Vector& max) { set(min, max); }
  HWY_INLINE AabbFrame(const Aabb& box, const Vec3& origin) {
    const auto min = difference<A>(box.min, origin), max = difference<A>(box.max, origin);
    set(min, max);
  }

  [[nodiscard]] HWY_INLINE Extremes<Real<A>> extremes(const Vector& normal, const Vector& magnitudes,
                                                      const Real<A>& twice_offset) const {
    return {A::rounded(dot(normal, sum_, A::constant(twice_offset))), A::rounded(dot(magnitudes, extent_))};
  }
  [[nodiscard]] HWY_INLINE Extremes<Real<A>> extremes(const FilterPlane& p) const {
    return extremes(constants<A>(p.normal), constants<A>(p.magnitudes), p.offset + p.offset);
  }
  /// The rounding error of the values of planes with this bound is at most this, for this box and for every box within it.
  template <class Bound>
  [[nodiscard]] HWY_INLINE Real<A> error(const Bound& bound) const {
    return product<A>(bound.slope, twice_reach_) + (bound.base + bound.base);
  }
  [[nodiscard]] HWY_INLINE Real<A> reach() const { return 0.5 * twice_reach_; }

 private:
  HWY_INLINE void set(const Vector& min, const Vector& max) {
    sum_ = max + min;
    extent_ = max - min;
    twice_reach_ = farthest();
  }
  HWY_INLINE Real<A> farthest() const {
    using std::max;
    return max(max(farthest(sum_.x, extent_.x), farthest(sum_.y, extent_.y)), farthest(sum_.z, extent_.z));
  }
  HWY_INLINE static Real<A> farthest(const typename A::Number& sum, const typename A::Number& extent) {
    return A::rounded(A::magnitude(sum)) + A::rounded(extent);
  }

  Vector sum_, extent_;
  Real<A> twice_reach_;
};

}  // namespace OCCLUDE_FRAME_NAMESPACE
}  // namespace occlude::kernel
