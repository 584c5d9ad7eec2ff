// SPDX-License-Identifier: MIT
// How a figure is spread over the frames of a walk.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace occlude::render {

/// The value below which `share` of the values lie, interpolated between its neighbours. REQUIRES: `ascending` has a value
/// and is sorted; `share` is from 0 to 1.
[[nodiscard]] double quantile(const std::vector<double>& ascending, double share);

struct Interval {
  double low = 0, high = 0;
};

/// Where the median of more such values is, with 95 % confidence: the number of values below it is binomial, so it lies
/// between those 0.98 sqrt(n) places from the middle. Nothing for fewer than six. REQUIRES: sorted values.
[[nodiscard]] std::optional<Interval> median_interval(const std::vector<double>& ascending);

/// A figure of one frame.
struct FrameValue {
  std::size_t frame = 0;
  double value = 0;
};

enum class Worst { least, most };

struct Spread {
  double median = 0, percentile_5 = 0, percentile_95 = 0;
  FrameValue worst;
};

/// Values that are not finite, such as the ratio of two times of zero, are left out. Nothing if none is left.
[[nodiscard]] std::optional<Spread> spread_of(std::vector<FrameValue> values, Worst worst);

}  // namespace occlude::render
