// SPDX-License-Identifier: MIT
// Small sets of whole numbers, a bit for each.
#pragma once

#include <bit>
#include <cstdint>

namespace occlude::culler {

/// Calls visit(i) for each bit, in ascending order.
template <class Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

}  // namespace occlude::culler
