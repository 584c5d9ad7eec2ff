// SPDX-License-Identifier: MIT
#include "occlude/culler/polygon_soup.h"

#include <algorithm>

#include "bounds.h"

namespace occlude::culler {

std::vector<bool> polygons_of(std::span<const PolygonRange> ranges, std::size_t count) {
  std::vector<bool> result(count);
  for (const auto [first, length] : ranges) std::fill_n(result.begin() + std::ptrdiff_t{first}, length, true);
  return result;
}

kernel::Aabb PolygonSoup::box(std::size_t p) const {
  kernel::Aabb box = empty_box();
  for (const std::uint32_t index : loop(p)) grow(box, to_kernel(vertices[index]));
  return box;
}

}  // namespace occlude::culler
