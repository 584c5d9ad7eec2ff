// SPDX-License-Identifier: MIT
#include "region_faults.h"

#include <array>

#include "faults.h"
#include "sheet.h"

namespace occlude::oracle {
namespace {

std::string fault_of(const Layer& layer);

std::string fault_of(const Focus& focus) {
  const std::array points{focus.point, focus.normal, focus.right};
  if (std::string reason = range_fault(points); !reason.empty()) return reason;
  const auto up = [&]<class N>() -> N {
    return CGAL::cross_product(vector_of<N>(focus.right), vector_of<N>(focus.normal)).squared_length();
  };
  return sign_of(up) == CGAL::ZERO ? "the focus plane has no axes" : "";
}

std::string fault_of(const Window& window) {
  const std::array points{Point{window.x0, window.y0, 0}, Point{window.x1, window.y1, 0}};
  if (std::string reason = range_fault(points); !reason.empty()) return reason;
  if (!(window.x0 < window.x1 && window.y0 < window.y1)) return "a window is empty";
  const Sheet* sheet = std::get_if<Sheet>(&window.to);
  return sheet ? sheet->prepared().fault : fault_of(std::get<Layer>(window.to));
}

std::string fault_of(const Layer& layer) {
  if (std::string reason = fault_of(layer.focus); !reason.empty()) return reason;
  for (const Window& window : layer.windows) {
    if (std::string reason = fault_of(window); !reason.empty()) return reason;
  }
  return "";
}

}  // namespace

std::string fault_of(const EyeRegion& eyes) {
  if (const Obb* box = std::get_if<Obb>(&eyes)) return strict_box_fault(*box);
  const auto& [center, radius] = std::get<Ball>(eyes);
  const std::array points{center, Point{radius, 0, 0}};
  return radius < 0 ? "the radius is negative" : range_fault(points);
}

std::string fault_of(const RegionWitness& witness) {
  const RoundUpward rounding;
  if (std::string reason = fault_of(witness.eyes); !reason.empty()) return reason;
  if (std::string reason = strict_box_fault(witness.box); !reason.empty()) return reason;
  return fault_of(witness.layer);
}

bool contains(const Ball& ball, const Point& point) {
  if (!fault_of(ball).empty()) return false;
  const RoundUpward rounding;
  const auto beyond = [&]<class N>() -> N {
    return difference<N>(ball.center, point).squared_length() - N(ball.radius) * N(ball.radius);
  };
  return sign_of(beyond) != CGAL::POSITIVE;
}

}  // namespace occlude::oracle
