// SPDX-License-Identifier: MIT
// Ids as numbers: the generation in the higher 32 bits, the slot plus 1 in the lower ones, so that 0 is none.
#pragma once

#include <cstdint>

#include "occlude/culler/scene_id.h"

namespace occlude::c {

template <class Id>
[[nodiscard]] std::uint64_t packed(const Id& id) {
  return std::uint64_t{id.generation} << 32U | static_cast<std::uint32_t>(id.slot + 1U);
}

template <class Id>
[[nodiscard]] Id unpacked(std::uint64_t number) {
  return {static_cast<std::uint32_t>(number) - 1U, static_cast<std::uint32_t>(number >> 32U)};
}

}  // namespace occlude::c
