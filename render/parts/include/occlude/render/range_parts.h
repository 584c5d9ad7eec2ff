// SPDX-License-Identifier: MIT
// The parts of a stage that are ranges of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "occlude/render/packing.h"

namespace occlude::render {

class RangeParts {
 public:
  struct Range {
    std::size_t first, end;
  };

  /// Of the numbers below `count`, so many a part. REQUIRES: that is more than 0, or `count` is 0.
  RangeParts(std::size_t count, std::size_t of_part) : count_(count), of_part_(of_part) {}

  /// As Stage::next.
  [[nodiscard]] std::optional<std::string> next() {
    if (begun_ == count_) return std::nullopt;
    return Packer().put(std::exchange(begun_, from(begun_).end)).bytes();
  }
  /// For Stage::work: the range of an input. Throws PartError if there is none.
  [[nodiscard]] Range of(const std::string& input) const {
    const auto first = Unpacker(input).get<std::size_t>();
    require_part(first < count_, "a range that there is not");
    return from(first);
  }
  /// For Stage::take: the range of the result.
  [[nodiscard]] Range take() {
    const Range range = from(taken_);
    taken_ = range.end;
    return range;
  }

 private:
  [[nodiscard]] Range from(std::size_t first) const { return {first, std::min(first + of_part_, count_)}; }

  std::size_t count_, of_part_;
  std::size_t begun_ = 0, taken_ = 0;
};

}  // namespace occlude::render
