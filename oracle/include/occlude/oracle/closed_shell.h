// SPDX-License-Identifier: MIT
// What is inside of a closed surface, asked of many triangles.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

/// A surface of triangles, prepared for many questions. Any number of threads may ask at once.
class ClosedShell {
 public:
  /// REQUIRES: finite numbers.
  explicit ClosedShell(std::span<const Triangle> triangles);
  ~ClosedShell();
  ClosedShell(ClosedShell&& other) noexcept;
  ClosedShell& operator=(ClosedShell&& other) noexcept;

  /// Empty when each edge runs along an even number of sides, else what is wrong.
  [[nodiscard]] const std::string& fault() const;

  /// Proves that no triangle of the surface has a point in common with this one, and that a ray from a point of this one
  /// crosses an odd number of them. So each way from it to anywhere beyond the surface meets the surface strictly between.
  /// If it `may_touch`, its borders do not count, and all of this is of its points without them. It may have no area.
  /// Returns an empty string when all of this holds, else what failed. REQUIRES: no fault; finite numbers.
  [[nodiscard]] std::string refute_inside(const Triangle& triangle, bool may_touch) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace occlude::oracle
