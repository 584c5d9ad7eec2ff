// SPDX-License-Identifier: MIT
// What makes the numbers, the viewpoint or the near plane of a question unusable. Every check is decided exactly; a reason
// is one line, empty when there is nothing wrong.
#pragma once

#include <span>
#include <string>

#include "numbers.h"

namespace occlude::oracle {

/// A number of the box is not finite, or min > max.
[[nodiscard]] std::string box_fault(const Box& box);

/// As box_fault, or a coordinate is out of range.
[[nodiscard]] std::string strict_box_fault(const Box& box);

/// A coordinate is not finite or out of range.
[[nodiscard]] std::string range_fault(std::span<const Point> points);

/// A number of the viewpoint or of the vertices is not finite or out of range.
[[nodiscard]] std::string number_fault(const Viewpoint& view, std::span<const Point> vertices);

/// A number of the near plane is not finite, or the direction of view is zero.
[[nodiscard]] std::string setting_fault(const Viewpoint& view, const Near& near);

/// A coefficient of a plane is not finite or out of the range of coordinates.
[[nodiscard]] std::string plane_fault(const std::array<double, 4>& coefficients);

/// A given near plane is not sound for an occluder with these vertices.
[[nodiscard]] std::string plane_fault(const Viewpoint& view, std::span<const Point> vertices, const Near& near);

}  // namespace occlude::oracle
