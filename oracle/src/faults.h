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

/// A number is not finite, one other than the near plane's is out of range, or min > max.
[[nodiscard]] std::string number_fault(const Viewpoint& view, std::span<const Point> vertices, const Near& near,
                                       const Box& box);

/// The direction of view is zero.
[[nodiscard]] std::string view_fault(const Viewpoint& view);

/// A given near plane is not sound for an occluder with these vertices.
[[nodiscard]] std::string plane_fault(const Viewpoint& view, std::span<const Point> vertices, const Near& near);

}  // namespace occlude::oracle
