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

HWY_INLINE unsigned bits(hn::Mask<Doubles> mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(Doubles(), mask, stored);
  return stored[0];
}

HWY_INLINE LaneVector load(const std::array<BoxBlock::Row, 3>& rows, std::size_t first) {
  return {Lanes::load(&rows[0][first]), Lanes::load(&rows[1][first]), Lanes::load(&rows[2][first])};
}

/// The boxes in the lanes from `first` on, against each frustum that is asked about.
HWY_INLINE void ask(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, std::size_t first,
                    BlockQuestions& questions) {
  const LaneVector box_min = load(block.min, first), box_max = load(block.max, first);
  const auto frame_at = [&](const Vec3& point) HWY_ATTR {
    const auto origin = constants<LaneArithmetic>(point);
    return Frame(box_min - origin, box_max - origin);
  };
  Vec3 origin;
  Frame frame = frame_at(origin);
  for (std::size_t k = 0; k < questions.count; ++k) {
    const StoredFrustum* const frustum = stored(*frusta[questions.frustum[k]]);
    if (!frustum) [[unlikely]]
      continue;
    if (frustum->origin != origin) {  // shadows of one eye have one origin
      origin = frustum->origin;
      frame = frame_at(origin);
    }
    Least least;
    for (const FilterPlane& plane : frustum->own_planes()) least.include(frame.extremes(plane));
    const Known known = classify(least, frame.error(frustum->filter_bound));
    const BoxBytes all = (1U << hn::Lanes(Doubles())) - 1;
    const BoxBytes outside = bits(known.outside), straddling = bits(known.straddling), unknown = bits(known.unknown);
    const std::size_t shift = 8 * k + first;
    questions.outside |= outside << shift;
    questions.inside |= (all & ~(outside | straddling | unknown)) << shift;
    questions.unknown |= unknown << shift;
  }
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
