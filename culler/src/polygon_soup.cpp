// SPDX-License-Identifier: MIT
#include "occlude/culler/polygon_soup.h"

#include <algorithm>
#include <array>

#include "bounds.h"

namespace occlude::culler {

std::vector<bool> polygons_of(std::span<const PolygonRange> ranges, std::size_t count) {
  std::vector<bool> result(count);
  for (const auto [first, length] : ranges) {
    std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(first), length, true);
  }
  return result;
}

kernel::Aabb SoupView::box(std::size_t p) const {
  kernel::Aabb box = empty_box();
  for (const std::uint32_t index : loop(p)) grow(box, to_kernel(vertices[index]));
  return box;
}

void PolygonSoup::add_box(const glm::dvec3& low, const glm::dvec3& high) {
  std::array<std::uint32_t, 8> corner{};
  for (std::uint32_t i = 0; i < 8; ++i) {
    corner[i] = add_vertex({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  }
  using Face = std::array<std::size_t, 4>;
  for (const auto& [a, b, c, d] : {Face{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    add_polygon(std::array{corner[a], corner[b], corner[c], corner[d]});
  }
}

}  // namespace occlude::culler
