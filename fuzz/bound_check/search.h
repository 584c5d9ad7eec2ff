// SPDX-License-Identifier: MIT
// Looks for cases with large errors: random ones, and those that become of them when the error is made larger step by step.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "occlude/fuzz/random.h"

namespace occlude::bound_check {

/// The choices that make a case, each a number in [0, 1). What is not chosen yet is random.
class Choices {
 public:
  Choices(std::vector<double>& chosen, fuzz::Random& random) : chosen_(chosen), random_(random) {}

  double real(double low, double high) {
    if (next_ == chosen_.size()) chosen_.push_back(random_.real(0, 1));
    return low + (high - low) * chosen_[next_++];
  }
  /// A power of two with an exponent in [low, high).
  double scale(double low, double high) { return std::exp2(real(low, high)); }
  bool chance(double probability) { return real(0, 1) < probability; }
  double sign() { return chance(0.5) ? 1 : -1; }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(real(0, static_cast<double>(count))); }
  /// A point of the cube from -1 to 1.
  glm::dvec3 point() {
    const double x = real(-1, 1), y = real(-1, 1), z = real(-1, 1);
    return {x, y, z};
  }

 private:
  std::vector<double>& chosen_;
  fuzz::Random& random_;
  std::size_t next_ = 0;
};

/// A bound, the file that states it, and the largest share of it that was reached in so many cases.
struct Measured {
  std::string bound, where;
  double largest = 0;
  int cases = 0;
};

/// The share of a bound that a case reaches; none if the case is not legal.
using Measure = std::function<std::optional<double>(Choices&)>;

[[nodiscard]] Measured search(const std::string& bound, const std::string& where, int cases, std::uint64_t seed,
                              const Measure& measure);

}  // namespace occlude::bound_check
