// SPDX-License-Identifier: MIT
// The results of the experiments as tables, and the conditions of the measurement.
#pragma once

#include <string>
#include <vector>

#include "figure4.h"
#include "growth.h"
#include "joined.h"
#include "occlude/render/table.h"
#include "occluders.h"
#include "sorting.h"
#include "sweeps.h"
#include "threads.h"

namespace occlude::experiments {

using render::Table;

[[nodiscard]] Table figure4_table(const Figure4& figure);
[[nodiscard]] Table regions_table(const Sweeps& sweeps);
[[nodiscard]] Table threshold_table(const Sweeps& sweeps);
[[nodiscard]] Table sort_table(const Sorting& sorting);
[[nodiscard]] Table pictures_table(const Joined& joined);
[[nodiscard]] Table leaves_table(const Joined& joined);
[[nodiscard]] Table budgets_table(const Joined& joined);
[[nodiscard]] Table occluders_table(const Occluders& occluders);
[[nodiscard]] Table threads_table(const std::vector<ThreadsPoint>& points);
[[nodiscard]] Table growth_table(const Growth& growth);

/// What the times mean, and the machine.
[[nodiscard]] std::string conditions(const Options& options);

}  // namespace occlude::experiments
