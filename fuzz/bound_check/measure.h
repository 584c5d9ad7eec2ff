// SPDX-License-Identifier: MIT
// Measures how far off the filter's values are in cases of all families, as shares of their bounds.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "occlude/fuzz/cases.h"

namespace occlude::bound_check {

enum class Kind { frustum_plane, profile_plane, refined, half_space, running_error, double_double, floats };
inline constexpr std::array<std::string_view, 7> kKindNames{"planes",  "profile", "refined", "half-sp.",
                                                            "running", "double2", "floats"};

/// For every kind, the largest |value - true value| / bound.
struct Shares {
  std::array<double, kKindNames.size()> largest{};
  int legal_cases = 0;

  void note(Kind kind, double share);
  void include(const Shares& other);
};

/// Measures `cases` cases of a family. Those that are not legal are skipped.
[[nodiscard]] Shares measure(fuzz::Family family, int cases, std::uint64_t seed);

}  // namespace occlude::bound_check
