// SPDX-License-Identifier: MIT
#include <algorithm>

#include "box.h"
#include "faults.h"
#include "half_spaces.h"

namespace occlude::oracle {

std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box, double margin) {
  const RoundUpward rounding;
  if (std::string fault = plane_fault(plane); !fault.empty()) return fault;
  if (std::string fault = box_fault(box); !fault.empty()) return fault;
  Plane definition(CoefficientPlane{plane});
  const auto is_beyond = [](CGAL::Sign side) { return side == CGAL::NEGATIVE; };
  if (!std::ranges::all_of(corner_sides(definition, box), is_beyond)) return "the box reaches the plane";
  return keeps_distance(definition, box, margin) ? "" : "the box is nearer to the plane than its margin";
}

}  // namespace occlude::oracle
