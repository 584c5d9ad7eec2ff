// SPDX-License-Identifier: MIT
// Operation counts of the tests, in the units of the paper's Table 1.
#pragma once

#include <cstdint>

namespace occlude::kernel {

/// Operations, and the number of box-frustum `tests` that they were spent on: `dot` and `cross` products of 3-vectors,
/// `vector` additions and subtractions of 3-vectors, `scalar` multiplications. Scalar additions and comparisons are not
/// counted, and none of the counted operations is a division.
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
