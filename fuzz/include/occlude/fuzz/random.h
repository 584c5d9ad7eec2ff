// SPDX-License-Identifier: MIT
// Random numbers by splitmix64. It is written out here so that a seed means the same everywhere.
#pragma once

#include <cstdint>

namespace occlude::fuzz {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// An integer in [low, high]. All are nearly equally likely.
  int integer(int low, int high) {
    const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(bits() % span));
  }

  /// An index in [0, count).
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(bits() % count); }

  /// A number in [low, high).
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }

  bool chance(double probability) { return real(0, 1) < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace occlude::fuzz
