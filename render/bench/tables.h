// SPDX-License-Identifier: MIT
// The results of the experiments as tables, and the conditions of the measurement.
#pragma once

#include <string>
#include <vector>

#include "figure4.h"
#include "growth.h"
#include "joined.h"
#include "methods.h"
#include "sorting.h"
#include "sweeps.h"

namespace occlude::experiments {

/// A table for a terminal or a page.
struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the head; the first cell names the row
  std::vector<std::string> notes;              ///< remarks, a line each
};

[[nodiscard]] std::string text_of(const Table& table);
/// Without the title.
[[nodiscard]] std::string html_of(const Table& table);

[[nodiscard]] Table methods_table(const Methods& methods);
[[nodiscard]] Table figure4_table(const Figure4& figure);
[[nodiscard]] Table regions_table(const Sweeps& sweeps);
[[nodiscard]] Table threshold_table(const Sweeps& sweeps);
[[nodiscard]] Table sort_table(const Sorting& sorting);
[[nodiscard]] Table pictures_table(const Joined& joined);
[[nodiscard]] Table leaves_table(const Joined& joined);
[[nodiscard]] Table budgets_table(const Joined& joined);
[[nodiscard]] Table growth_table(const Growth& growth);

/// What the times mean, and the machine.
[[nodiscard]] std::string conditions(const Options& options);

}  // namespace occlude::experiments
