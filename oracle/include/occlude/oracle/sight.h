// SPDX-License-Identifier: MIT
// Single lines of sight, decided exactly. A segment that is clear refutes any cull of its end, whatever proves it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"
#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

/// What hides: triangles, from both sides and with their borders, as far as they are in a half-space, if there is one.
class Sight {
 public:
  /// REQUIRES: all numbers are finite.
  explicit Sight(std::span<const Triangle> triangles, const std::optional<HalfSpaceCoefficients>& drawn = {});

  /// Whether the segment meets no triangle at a point strictly between its ends. One in whose plane the segment lies counts
  /// as met. Not for several threads at once. REQUIRES: all numbers are finite.
  [[nodiscard]] bool is_clear(const Point& eye, const Point& end);

 private:
  std::vector<Triangle> triangles_;  ///< with an area
  std::optional<HalfSpaceCoefficients> drawn_;
  std::size_t last_ = 0;  ///< met by the segment before: the next one is likely to meet it, too
};

}  // namespace occlude::oracle
