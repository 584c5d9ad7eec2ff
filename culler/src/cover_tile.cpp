// SPDX-License-Identifier: MIT
// Compiled once for every instruction set, chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover_tile.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h goes first.
#include <hwy/highway.h>

#include "cover_tile.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight pixels at most, a row of a tile.
using Floats = hn::CappedTag<float, kTile>;

std::uint64_t nearer_pixels(const float* pixels, float most) {
  const Floats d;
  const auto limit = hn::Set(d, most);
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(d)) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(hn::LoadU(d, pixels + i), limit), bits);
    result |= std::uint64_t{bits[0]} << i;
  }
  return result;
}

float bring_nearer(float* pixels, std::uint64_t mask, float nearness) {
  const Floats d;
  const auto near = hn::Set(d, nearness);
  auto least = hn::Set(d, hwy::HighestValue<float>());
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(d)) {
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(mask >> i)};
    const auto old = hn::LoadU(d, pixels + i);
    const auto now = hn::IfThenElse(hn::LoadMaskBits(d, bits), hn::Max(old, near), old);
    hn::StoreU(now, d, pixels + i);
    least = hn::Min(least, now);
  }
  return hn::GetLane(hn::MinOfLanes(d, least));
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::culler {
namespace {
HWY_EXPORT(nearer_pixels);
HWY_EXPORT(bring_nearer);
}  // namespace

std::uint64_t nearer_pixels(const float* pixels, float most) { return HWY_DYNAMIC_DISPATCH(nearer_pixels)(pixels, most); }

float bring_nearer(float* pixels, std::uint64_t mask, float nearness) {
  return HWY_DYNAMIC_DISPATCH(bring_nearer)(pixels, mask, nearness);
}

}  // namespace occlude::culler
#endif
