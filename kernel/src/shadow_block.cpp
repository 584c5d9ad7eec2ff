// SPDX-License-Identifier: MIT
// This file is compiled once for every instruction set; the one that runs is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow_block.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "least_extremes-inl.h"
#include "occlude/kernel/box_block.h"
#include "stored_frustum.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {
namespace {

static_assert(kMaxLanes <= BoxBlock::kBoxes, "a vector of boxes is read from one block");

HWY_INLINE LaneVector load(const std::array<BoxBlock::Row, 3>& rows, std::size_t first) {
  return {Lanes::load(&rows[0][first]), Lanes::load(&rows[1][first]), Lanes::load(&rows[2][first])};
}

/// The boxes in the lanes from `first` on.
class LaneBoxes {
 public:
  HWY_INLINE LaneBoxes(const BoxBlock& block, std::size_t first)
      : min_(load(block.min, first)), max_(load(block.max, first)), frame_(min_, max_) {}

  HWY_INLINE void see_from(const Vec3& point) {
    if (point == origin_) return;  // shadows of one eye have one origin
    origin_ = point;
    const auto origin = constants<LaneArithmetic>(point);
    frame_ = Frame(min_ - origin, max_ - origin);
  }

  [[nodiscard]] HWY_INLINE Known classified(const StoredFrustum& frustum) const {
    Least least;
    for (const FilterPlane& plane : frustum.own_planes()) least.include(frame_.extremes(plane));
    return classify(least, frame_.error(frustum.filter_bound));
  }

 private:
  LaneVector min_, max_;
  Vec3 origin_;
  Frame frame_;
};

/// The boxes in the lanes from `first` on, against each frustum that is asked about. The answers are gathered in registers:
/// bytes that have just been stored can be loaded as words only after a delay.
HWY_INLINE void ask(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, std::size_t first,
                    BlockQuestions& questions) {
  const BoxBytes all = (BoxBytes{1} << hn::Lanes(Doubles())) - 1;
  LaneBoxes boxes(block, first);
  BoxBytes outside = 0, inside = 0, unknown = 0;
  for (std::size_t k = 0; k < questions.count; ++k) {
    const StoredFrustum* const frustum = stored(*frusta[questions.frustum[k]]);
    if (!frustum) [[unlikely]]
      continue;
    boxes.see_from(frustum->origin);
    const Known known = boxes.classified(*frustum);
    const BoxBytes is_outside = bits(known.outside), is_straddling = bits(known.straddling),
                   is_unknown = bits(known.unknown);
    const std::size_t shift = 8 * k + first;
    outside |= is_outside << shift;
    inside |= (all & ~(is_outside | is_straddling | is_unknown)) << shift;
    unknown |= is_unknown << shift;
  }
  questions.outside |= outside;
  questions.inside |= inside;
  questions.unknown |= unknown;
}

HWY_ATTR void conservative_filter(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block,
                                  BlockQuestions& questions) {
  questions.outside = questions.inside = questions.unknown = 0;
  for (std::size_t first = 0; first < BoxBlock::kBoxes; first += hn::Lanes(Doubles())) ask(frusta, block, first, questions);
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
