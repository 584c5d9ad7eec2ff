// SPDX-License-Identifier: MIT
// A segment clipped by half-spaces in the manner of Cyrus and Beck, without a division.
#pragma once

namespace occlude::kernel {

/// The part of a closed segment P Q that half-spaces leave. A half-space is given by its (affine) values at P and Q, >= 0
/// inside. Q may lie at infinity, in a direction: its value is then that of the linear part there. Clip parameters are
/// quotients gP / (gP - gQ). They are compared by cross-multiplication.
template <class A>
class SegmentClip {
 public:
  using Number = typename A::Number;

  explicit SegmentClip(A& arithmetic) : arithmetic_(arithmetic) {}

  void clip(const Number& at_p, const Number& at_q) {
    const int p = arithmetic_.sign(at_p), q = arithmetic_.sign(at_q);
    if (p < 0 && q < 0) {
      empty_ = true;
    } else if (p < 0) {
      if (!entered_ || later(enter_, {at_p, at_q})) enter_ = {at_p, at_q};
      entered_ = true;
    } else if (q < 0) {
      if (!left_ || later({at_p, at_q}, leave_)) leave_ = {at_p, at_q};
      left_ = true;
    }
  }

  /// Whether nothing is left, not even a point.
  [[nodiscard]] bool empty() const {
    return empty_ || (entered_ && left_ && arithmetic_.sign(leave_.p * enter_.q - enter_.p * leave_.q) < 0);
  }

 private:
  struct Crossing {
    Number p, q;
  };

  /// Whether t_b > t_a for two crossings that enter, with parameters t = p / (p - q). For two crossings that leave, the
  /// denominators have the other sign, and the question is the same: t_a.p t_b.q > t_b.p t_a.q.
  [[nodiscard]] bool later(const Crossing& a, const Crossing& b) const {
    return arithmetic_.sign(a.p * b.q - b.p * a.q) > 0;
  }

  A& arithmetic_;
  Crossing enter_{}, leave_{};  ///< the latest entering and the earliest leaving crossing, once there is one
  bool entered_ = false, left_ = false, empty_ = false;
};

}  // namespace occlude::kernel
