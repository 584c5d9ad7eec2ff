// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "experiments.h"
#include "tables.h"

namespace occlude::experiments {

std::string report_text(const Result& result, const Options& options) {
  std::string text = fmt::format("{}: {} polygons; {} frames, {} to {}\n", result.model, result.polygons, result.frames,
                                 result.first_frame, result.last_frame);
  const auto add = [&](const std::string& part) { text += "\n" + part; };
  if (result.table2) add(text_of(*result.table2));
  if (result.figure4) add(text_of(figure4_table(*result.figure4)));
  if (result.sweeps) {
    add(text_of(regions_table(*result.sweeps)));
    add(text_of(threshold_table(*result.sweeps)));
  }
  if (result.sort) add(text_of(sort_table(*result.sort)));
  if (result.joined) {
    add(text_of(pictures_table(*result.joined)));
    add(text_of(leaves_table(*result.joined)));
    add(text_of(budgets_table(*result.joined)));
  }
  if (result.occluders) add(text_of(occluders_table(*result.occluders)));
  if (!result.threads.empty()) add(text_of(threads_table(result.threads)));
  if (result.growth) add(text_of(growth_table(*result.growth)));
  add(conditions(options) + "\n");
  return text;
}

}  // namespace occlude::experiments
