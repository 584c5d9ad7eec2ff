// SPDX-License-Identifier: MIT
// What a validation found, as text and as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "occlude/culler/missed.h"
#include "visibility_check.h"

namespace occlude::cli {

/// Of the hidden polygons that some frames drew, how many for which reason.
struct MissedCounts {
  culler::Method method = culler::Method::frusta;
  std::size_t frames = 0;
  culler::MissedReasons::Counts counts;
};

struct Validation {
  std::size_t proved = 0, failed = 0;  ///< witnesses
  bool is_exact = false;               ///< what visibility was found by: exact arithmetic, or item buffers
  std::size_t sizes = 0;               ///< of item buffers
  Visibility visibility;
  std::optional<MissedCounts> missed;  ///< where the frames were culled anew
};

[[nodiscard]] bool passed(const Validation& validation);

[[nodiscard]] std::string to_text(const Validation& validation);
[[nodiscard]] std::string to_json(const Validation& validation);

}  // namespace occlude::cli
