// SPDX-License-Identifier: MIT
// This file is compiled once for every instruction set; the one that runs is chosen at run time. Floats answer first,
// twice as many boxes in a vector; doubles answer where floats cannot.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow_block.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "error_bounds.h"
#include "least_extremes-inl.h"
#include "occlude/kernel/box_block.h"
#include "stored_frustum.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {
namespace {

static_assert(kMaxLanes <= BoxBlock::kBoxes, "a vector of boxes is read from one block");

/// What is known about one question: the boxes that are outside, inside, and neither known nor straddling.
struct Answers {
  unsigned outside = 0, inside = 0, unknown = 0;
};

HWY_INLINE LaneVector load(const std::array<BoxBlock::Row, 3>& rows, std::size_t first) {
  return {Lanes::load(&rows[0][first]), Lanes::load(&rows[1][first]), Lanes::load(&rows[2][first])};
}

/// The answers of the filter in doubles.
HWY_NOINLINE Answers answers_in_doubles(const StoredFrustum& frustum, const BoxBlock& block) {
  const auto origin = constants<LaneArithmetic>(frustum.origin);
  const unsigned all = (1U << hn::Lanes(Doubles())) - 1;
  Answers answers;
  for (std::size_t first = 0; first < BoxBlock::kBoxes; first += hn::Lanes(Doubles())) {
    const Frame frame(load(block.min, first) - origin, load(block.max, first) - origin);
    Least least;
    for (const FilterPlane& plane : frustum.own_planes()) least.include(frame.extremes(plane));
    const Known known = classify(least, frame.error(frustum.filter_bound));
    const unsigned outside = bits(Doubles(), known.outside), unknown = bits(Doubles(), known.unknown);
    answers.outside |= outside << first;
    answers.unknown |= unknown << first;
    answers.inside |= (all & ~(outside | unknown | bits(Doubles(), known.straddling))) << first;
  }
  return answers;
}

using Floats = hn::CappedTag<float, BoxBlock::kBoxes>;
using FloatVector = hn::Vec<Floats>;

/// Coordinates relative to an origin, in floats. `Wide` is the longest vector of doubles, which may have half as many lanes.
template <class Wide>
HWY_INLINE FloatVector relative(Wide wide, const double* x, double origin) {
  const hn::Rebind<float, Wide> part;
  const auto difference = [&](const double* from)
                              HWY_ATTR { return hn::DemoteTo(part, hn::Sub(hn::Load(wide, from), hn::Set(wide, origin))); };
  if constexpr (hn::MaxLanes(part) == hn::MaxLanes(Floats())) {
    return difference(x);
#if HWY_TARGET != HWY_SCALAR  // which has one lane of either
  } else {
    return hn::Combine(Floats(), difference(x + hn::MaxLanes(part)), difference(x));
#endif
  }
}

/// As AabbFrame, in floats, of the boxes in the lanes from `first` on.
class CoarseFrame {
 public:
  HWY_INLINE CoarseFrame(const BoxBlock& block, const Vec3& origin, std::size_t first) {
    const Floats d;
    FloatVector reach = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = origin[static_cast<int>(k)];
      const FloatVector min = relative(Doubles(), &block.min[k][first], at),
                        max = relative(Doubles(), &block.max[k][first], at);
      sum_[k] = hn::Add(max, min);
      extent_[k] = hn::Sub(max, min);
      reach = hn::Max(reach, hn::Add(hn::Abs(sum_[k]), extent_[k]));
    }
    const auto is_near = hn::Lt(reach, hn::Set(d, static_cast<float>(2 * kCoarseReach)));
    twice_reach_ = hn::IfThenElse(is_near, reach, hn::Inf(d));
  }

  [[nodiscard]] HWY_INLINE Answers answers(const StoredFrustum& frustum) const {
    const Floats d;
    FloatVector low = hn::Inf(d), high = low;
    const auto include = [&](const CoarsePlane& plane) HWY_ATTR {
      const FloatVector x = hn::Set(d, plane.x), y = hn::Set(d, plane.y), z = hn::Set(d, plane.z);
      const FloatVector middle =
          hn::MulAdd(x, sum_[0], hn::MulAdd(y, sum_[1], hn::MulAdd(z, sum_[2], hn::Set(d, plane.twice_offset))));
      const FloatVector spread =
          hn::MulAdd(hn::Abs(x), extent_[0], hn::MulAdd(hn::Abs(y), extent_[1], hn::Mul(hn::Abs(z), extent_[2])));
      low = hn::Min(low, hn::Sub(middle, spread));
      high = hn::Min(high, hn::Add(middle, spread));
    };
    for (std::size_t i = 0; i < frustum.coarse_planes.size(); i += kCoarseWidth) {
      for (std::size_t k = 0; k < kCoarseWidth; ++k) include(frustum.coarse_planes[i + k]);
    }
    // Where the error is infinite, or a value is not a number, nothing is known.
    const FloatVector error =
        hn::MulAdd(hn::Set(d, frustum.coarse_bound.slope), twice_reach_, hn::Set(d, frustum.coarse_bound.twice_base));
    const auto outside = hn::Lt(high, hn::Neg(error)), inside = hn::Gt(low, error);
    const auto straddling = hn::And(hn::Lt(low, hn::Neg(error)), hn::Gt(high, error));
    return {bits(d, outside), bits(d, inside), bits(d, hn::Not(hn::Or(hn::Or(outside, inside), straddling)))};
  }

 private:
  FloatVector sum_[3], extent_[3], twice_reach_;
};

/// What is known about all questions. It is gathered in registers: what has just been stored can be loaded only after a
/// delay.
struct AllAnswers {
  BoxBytes outside = 0, inside = 0, unknown = 0;
};

/// Answers the questions about the boxes in the lanes from `first` on.
HWY_INLINE void ask_in_floats(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, std::size_t first,
                              const BlockQuestions& questions, AllAnswers& all) {
  const auto frustum = [&](std::size_t k) { return stored(*frusta[questions.frustum[k]]); };
  for (std::size_t k = 0; k < questions.count;) {
    if (!frustum(k)) [[unlikely]] {
      ++k;
      continue;
    }
    const Vec3 origin = frustum(k)->origin;
    const CoarseFrame frame(block, origin, first);
    do {
      const Answers answers = frame.answers(*frustum(k));
      const std::size_t shift = 8 * k + first;
      all.outside |= BoxBytes{answers.outside} << shift;
      all.inside |= BoxBytes{answers.inside} << shift;
      all.unknown |= BoxBytes{answers.unknown} << shift;
      ++k;
    } while (k < questions.count && frustum(k) && frustum(k)->origin == origin);  // one eye has one origin
  }
}

HWY_INLINE void ask_in_doubles(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, std::size_t k,
                               BlockQuestions& questions) {
  const Answers answers = answers_in_doubles(*stored(*frusta[questions.frustum[k]]), block);
  const std::size_t shift = 8 * k;
  const BoxBytes others = ~(BoxBytes{0xFF} << shift);
  questions.outside = (questions.outside & others) | BoxBytes{answers.outside} << shift;
  questions.inside = (questions.inside & others) | BoxBytes{answers.inside} << shift;
  questions.unknown = (questions.unknown & others) | BoxBytes{answers.unknown} << shift;
}

HWY_ATTR void conservative_filter(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block,
                                  BlockQuestions& questions) {
  AllAnswers all;
  for (std::size_t first = 0; first < BoxBlock::kBoxes; first += hn::Lanes(Floats())) {
    ask_in_floats(frusta, block, first, questions, all);
  }
  questions.outside = all.outside;
  questions.inside = all.inside;
  questions.unknown = all.unknown;
  for (BoxBytes left = all.unknown; left != 0;) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left)) / 8;
    ask_in_doubles(frusta, block, k, questions);
    left &= ~(BoxBytes{0xFF} << 8 * k);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::kernel {
namespace {
HWY_EXPORT(conservative_filter);
}  // namespace

void conservative_filter(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, BlockQuestions& questions) {
  HWY_DYNAMIC_DISPATCH(conservative_filter)(frusta, block, questions);
}

}  // namespace occlude::kernel
#endif
