// SPDX-License-Identifier: MIT
#include "spread.h"

#include <algorithm>

namespace occlude::experiments {

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
  };
  return {at(0.5), at(0.99), values.back()};
}

std::vector<render::Column> spread_columns(const std::string& head) {
  return {{head}, {"median"}, {"99th percentile"}, {"maximum"}};
}

std::vector<render::Cell> row_of(const std::string& name, const Spread& spread, int digits) {
  const auto number = [&](double x) { return render::rounded(x, digits); };
  return {name, number(spread.median), number(spread.most_of_99), number(spread.most)};
}

nlohmann::ordered_json json_of(const Spread& spread) {
  return {{"median", spread.median}, {"percentile_99", spread.most_of_99}, {"maximum", spread.most}};
}

}  // namespace occlude::experiments
