// SPDX-License-Identifier: MIT
// Seeds of tests that try random cases.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace occlude {

/// OCCLUDE_SEED, or the one that this test has always had.
[[nodiscard]] inline std::uint32_t seed_of(std::uint32_t usual) {
  const char* const requested = std::getenv("OCCLUDE_SEED");
  return requested != nullptr ? static_cast<std::uint32_t>(std::strtoul(requested, nullptr, 10)) : usual;
}

}  // namespace occlude
