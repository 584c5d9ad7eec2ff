// SPDX-License-Identifier: MIT
// Counts of what the tests cost, in the units of the paper's Table 1.
#pragma once

#include <cstdint>

namespace occlude::kernel {

/// A dot product is one of 3-vectors; `scalar` are single multiplications and divisions, `vector` additions and
/// subtractions of 3-vectors, `cross` cross products. `tests` is the number of box-frustum tests they were spent on.
struct Operations {
  std::uint64_t tests = 0, dot = 0, scalar = 0, vector = 0, cross = 0;

  Operations& operator+=(const Operations& other) {
    tests += other.tests;
    dot += other.dot;
    scalar += other.scalar;
    vector += other.vector;
    cross += other.cross;
    return *this;
  }
};

}  // namespace occlude::kernel
