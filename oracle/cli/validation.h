// SPDX-License-Identifier: MIT
// The result of a validation, as text and as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "occlude/render/missed_report.h"
#include "visibility_check.h"

namespace occlude::cli {

struct Validation {
  std::size_t proved = 0, failed = 0;  ///< witnesses
  bool is_exact = false;               ///< by exact visibility, else by item buffers
  std::size_t sizes = 0;               ///< number of sizes of the item buffers
  Visibility visibility;
  std::optional<render::MissedCounts> missed;  ///< only when the frames were culled anew
};

[[nodiscard]] bool passed(const Validation& validation);

[[nodiscard]] std::string to_text(const Validation& validation);
[[nodiscard]] std::string to_json(const Validation& validation);

}  // namespace occlude::cli
