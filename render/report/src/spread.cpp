// SPDX-License-Identifier: MIT
#include "occlude/render/spread.h"

#include <algorithm>
#include <cmath>

namespace occlude::render {

double quantile(const std::vector<double>& ascending, double share) {
  const double place = share * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return std::lerp(ascending[below], ascending[above], place - static_cast<double>(below));
}

std::optional<Interval> median_interval(const std::vector<double>& ascending) {
  const auto n = static_cast<double>(ascending.size());
  const double place = std::floor(n / 2 - 0.98 * std::sqrt(n));
  if (ascending.size() < 6 || place < 0) return std::nullopt;
  const auto i = static_cast<std::size_t>(place);
  return Interval{ascending[i], ascending[ascending.size() - 1 - i]};
}

std::optional<Spread> spread_of(std::vector<FrameValue> values, Worst worst) {
  std::erase_if(values, [](const FrameValue& v) { return !std::isfinite(v.value); });
  if (values.empty()) return std::nullopt;
  std::ranges::stable_sort(values, {}, &FrameValue::value);
  std::vector<double> ascending;
  for (const FrameValue& v : values) ascending.push_back(v.value);
  return Spread{quantile(ascending, 0.5), quantile(ascending, 0.05), quantile(ascending, 0.95),
                worst == Worst::least ? values.front() : values.back()};
}

}  // namespace occlude::render
