// SPDX-License-Identifier: MIT
// Figure 4 of the paper: share of the polygons culled against the number of occluders, for each criterion and mix.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

/// The numbers of occluders tried: dense where the paper sees the optimum, about eight.
inline constexpr std::array<std::size_t, 11> kOccluders{1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64};

struct Curve {
  std::string name, about;
  std::array<double, kOccluders.size()> share{};  ///< of the polygons in view that were culled
  std::size_t knee = 0;                           ///< the smallest number of occluders that culls 90 % of what 64 cull
};

struct Figure4 {
  std::size_t regions = 0;
  std::vector<Curve> curves;
  std::optional<double> sampling_s;  ///< time of the preprocess that samples depth complexity, seconds
};

/// The share of a curve at `occluders`; empty if the curve was left out. REQUIRES: one of kOccluders.
[[nodiscard]] std::optional<double> share_at(const Figure4& figure, std::string_view curve, std::size_t occluders);

[[nodiscard]] Figure4 measure_figure4(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
