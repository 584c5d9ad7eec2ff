// SPDX-License-Identifier: MIT
#include "culled_sets.h"

#include <algorithm>

namespace occlude::cli {

std::vector<Fate> fates_of(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled) {
  const std::size_t polygons = hierarchy.soup().size();
  std::vector<Fate> of_triangle(hierarchy.first_triangle(polygons), Fate::drawn);
  for (const CulledRun& run : culled) {
    const Fate fate = run.by_view ? Fate::out_of_view : Fate::in_shadow;
    std::fill_n(of_triangle.begin() + static_cast<std::ptrdiff_t>(run.first), run.count, fate);
  }
  std::vector<Fate> fates;
  fates.reserve(polygons);
  for (std::size_t p = 0; p < polygons; ++p) {
    const auto begin = of_triangle.begin() + static_cast<std::ptrdiff_t>(hierarchy.first_triangle(p));
    const auto end = of_triangle.begin() + static_cast<std::ptrdiff_t>(hierarchy.first_triangle(p + 1));
    const auto has = [&](Fate fate) { return std::find(begin, end, fate) != end; };
    fates.push_back(has(Fate::drawn) ? Fate::drawn : has(Fate::out_of_view) ? Fate::out_of_view : Fate::in_shadow);
  }
  return fates;
}

std::size_t witness_of(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled, std::size_t p) {
  const std::size_t first = hierarchy.first_triangle(p), end = hierarchy.first_triangle(p + 1);
  const auto run =
      std::ranges::find_if(culled, [&](const CulledRun& r) { return r.first < end && first < r.first + r.count; });
  return run == culled.end() ? 0 : run->witness;
}

}  // namespace occlude::cli
