// SPDX-License-Identifier: MIT
// What makes a question unanswerable. Every check is decided exactly; a reason is one line, empty when there is nothing
// wrong.
#pragma once

#include <span>
#include <string>

#include "frustum.h"

namespace occlude::oracle {

/// Not finite, or min > max.
[[nodiscard]] std::string box_fault(const Box& box);

/// Not finite, or outside {0} and magnitudes in [2^-100, 2^100].
[[nodiscard]] std::string range_fault(std::span<const double> numbers);

/// Numbers of the scene and of the box: finite, in range, min <= max.
[[nodiscard]] std::string number_fault(const Scene& scene, const Box& box);

/// How the viewpoint sees the loop: what is wrong with it, or on which side of its edges it lies.
struct Seen {
  std::string fault;
  CGAL::Sign turn = CGAL::ZERO;  ///< sign of every edge's side plane on the inner side
};

/// Whether the loop is a convex polygon seen from the viewpoint, wound once, the viewpoint not in its plane nor in it.
[[nodiscard]] Seen see_loop(const Scene& scene);

/// Whether the near plane is defined and sound for a good loop.
[[nodiscard]] std::string near_fault(const Scene& scene);

}  // namespace occlude::oracle
