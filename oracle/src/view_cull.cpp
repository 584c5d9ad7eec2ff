// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "box.h"
#include "faults.h"

namespace occlude::oracle {

std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box) {
  const RoundUpward rounding;
  if (!std::ranges::all_of(plane, [](double value) { return std::isfinite(value); })) return "a number is not finite";
  if (std::string fault = box_fault(box); !fault.empty()) return fault;
  const Point normal{plane[0], plane[1], plane[2]};
  for (unsigned c = 0; c < kCorners; ++c) {
    const auto height = [&]<class N>() { return N(vector_of<N>(normal) * vector_of<N>(Corner{box, c}) + N(plane[3])); };
    if (sign_of(height) != CGAL::NEGATIVE) return "the box reaches the plane";
  }
  return "";
}

}  // namespace occlude::oracle
