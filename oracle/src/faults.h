// SPDX-License-Identifier: MIT
// Faults of the numbers, the viewpoint or the near plane of a question. Every check is exact. Each function returns the
// fault in one line, or an empty string.
#pragma once

#include <span>
#include <string>

#include "numbers.h"

namespace occlude::oracle {

/// Checks that all numbers of the box are finite and that min <= max.
[[nodiscard]] std::string box_fault(const Box& box);

/// Checks the same as box_fault(), and that all coordinates are in range.
[[nodiscard]] std::string strict_box_fault(const Box& box);

/// Checks that all coordinates are finite and in range.
[[nodiscard]] std::string range_fault(std::span<const Point> points);

/// Checks that all numbers of the viewpoint and of the vertices are finite and in range.
[[nodiscard]] std::string number_fault(const Viewpoint& view, std::span<const Point> vertices);

/// Checks that all numbers of the near plane are finite and that a direction of view is not zero.
[[nodiscard]] std::string setting_fault(const Viewpoint& view, const Near& near);

/// Checks that all coefficients of a plane are finite and in the range of coordinates.
[[nodiscard]] std::string plane_fault(const std::array<double, 4>& coefficients);

/// Checks that a given near plane is sound for an occluder with these vertices.
[[nodiscard]] std::string plane_fault(const Viewpoint& view, std::span<const Point> vertices, const Near& near);

}  // namespace occlude::oracle
