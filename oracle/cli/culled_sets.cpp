// SPDX-License-Identifier: MIT
#include "culled_sets.h"

#include <algorithm>

namespace occlude::cli {

std::vector<bool> drawn_polygons(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled) {
  const std::size_t polygons = hierarchy.soup().size();
  std::vector<bool> is_drawn(hierarchy.first_triangle(polygons), true);
  const auto at = [&](std::size_t triangle) { return is_drawn.begin() + static_cast<std::ptrdiff_t>(triangle); };
  for (const CulledRun& run : culled) std::fill(at(run.first), at(run.first + run.count), false);
  std::vector<bool> result(polygons);
  for (std::size_t p = 0; p < polygons; ++p) {
    const auto end = at(hierarchy.first_triangle(p + 1));
    result[p] = std::find(at(hierarchy.first_triangle(p)), end, true) != end;
  }
  return result;
}

std::size_t witness_of(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled, std::size_t p) {
  const std::size_t first = hierarchy.first_triangle(p), end = hierarchy.first_triangle(p + 1);
  const auto run =
      std::ranges::find_if(culled, [&](const CulledRun& r) { return r.first < end && first < r.first + r.count; });
  return run == culled.end() ? 0 : run->witness;
}

}  // namespace occlude::cli
