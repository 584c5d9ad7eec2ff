// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/radix_sort.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {
namespace {

/// Whether the two are one range.
bool are_one(const MaterialRange& range, const MaterialRange& next) {
  return range.material == next.material && range.first + range.count == next.first;
}

}  // namespace

DrawOrder::DrawOrder(const Hierarchy& hierarchy, std::span<const std::uint32_t> materials) {
  if (materials.size() != hierarchy.face_count()) {
    throw std::invalid_argument(std::to_string(materials.size()) + " materials for " +
                                std::to_string(hierarchy.face_count()) + " faces");
  }
  const auto material_of = [&](std::uint32_t p) { return materials[hierarchy.face(p)]; };
  std::vector<std::uint32_t> order(hierarchy.soup().size()), room;
  std::iota(order.begin(), order.end(), 0U);
  radix_sort(order, room, std::uint64_t{std::ranges::max(materials)} + 1, material_of);

  std::vector<std::uint32_t>& places = room;  // of each polygon of the tree, in this order
  first_triangle_.push_back(0);
  for (const std::uint32_t p : order) {
    const auto place = static_cast<std::uint32_t>(polygons_.size());
    places[p] = place;
    polygons_.push_back(hierarchy.original(p));
    first_triangle_.push_back(first_triangle_.back() + static_cast<std::uint32_t>(hierarchy.soup().triangles(p)));
    const MaterialRange here{material_of(p), place, 1};
    if (materials_.empty() || !are_one(materials_.back(), here)) materials_.push_back({here.material, place, 0});
    ++materials_.back().count;
  }
  for (std::uint32_t p = 0; p < order.size(); ++p) {
    if (p == 0 || runs_.back().material != material_of(p)) runs_.push_back({p, places[p], material_of(p)});
  }
}

void DrawOrder::find_ranges(std::span<const PolygonRange> drawn, std::vector<MaterialRange>& ranges) const {
  ranges.clear();
  for (const auto& [first, count] : drawn) {
    const std::uint32_t end = first + count;
    auto run = std::prev(std::ranges::upper_bound(runs_, first, {}, &Run::in_tree));
    for (std::uint32_t begin = first; begin < end; ++run) {
      const auto next = std::next(run);
      const std::uint32_t stop = next == runs_.end() ? end : std::min(end, next->in_tree);
      ranges.push_back({run->material, run->first + (begin - run->in_tree), stop - begin});
      begin = stop;
    }
  }
  std::ranges::sort(ranges, {}, &MaterialRange::first);
  std::size_t kept = 0;
  for (const MaterialRange range : ranges) {
    if (kept > 0 && are_one(ranges[kept - 1], range)) {
      ranges[kept - 1].count += range.count;
    } else {
      ranges[kept++] = range;
    }
  }
  ranges.resize(kept);
}

}  // namespace occlude::culler
