// SPDX-License-Identifier: MIT
// Pseudo-random integers. The distributions of the standard library differ between implementations, so we have our own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "units.h"

namespace occlude::render::city {

/// SplitMix64. Every object of the model (a house, a tree) has its own generator, keyed by its kind and index, so that
/// leaving out the details of one does not change the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// A generator for the object (kind, index) of the model made from `seed`.
  Random(std::uint64_t seed, std::uint64_t kind, std::uint64_t index)
      : state_(mix(mix(mix(seed + kGamma) ^ kind) + index * kGamma)) {}

  std::uint64_t next() { return mix(state_ += kGamma); }
  /// A number from 0 to n - 1. The bias of the remainder, below n / 2^64, does not matter for scenery.
  Length below(Length n) { return static_cast<Length>(next() % static_cast<std::uint64_t>(n)); }
  /// A number from lo to hi, both included.
  Length between(Length lo, Length hi) { return lo + below(hi - lo + 1); }
  /// True in `percent` of 100 cases.
  bool chance(Length percent) { return below(100) < percent; }

 private:
  static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ULL;  // 2^64 over the golden ratio, odd
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// The numbers 0 .. n - 1 in an order that depends on `random` alone.
inline std::vector<std::size_t> shuffled(std::size_t n, Random random) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<Length>(i)))]);
  return order;
}

}  // namespace occlude::render::city
