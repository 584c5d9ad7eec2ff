// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

#include "occlude/kernel/validity.h"
#include "region_lists.h"

namespace occlude::culler {
namespace {

/// Beyond this counting them would take all memory.
constexpr double kMostRegions = 0x1p30;

}  // namespace

OccluderGrid::OccluderGrid(const kernel::Aabb& box, const Config& config) : origin_{box.min.x, box.min.y, box.min.z} {
  if (!(config.threshold > 0)) throw std::invalid_argument("the threshold of the grid must be above 0");
  if (!(config.regions >= 1 && config.regions <= kMostRegions)) {
    throw std::invalid_argument("the number of regions must be from 1 to 2^30");
  }
  const glm::dvec3 extent{box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z};
  // Cubes of one edge e with about `regions` of them in the box; a flat box counts as at least 1/1000 thick so that e stays
  // in proportion to the model.
  const double largest = std::max({extent.x, extent.y, extent.z, kernel::kMinMagnitude});
  const glm::dvec3 solid = glm::max(extent, largest / 1000);
  edge_ = largest * std::cbrt(solid.x / largest * (solid.y / largest) * (solid.z / largest) / config.regions);
  for (int axis = 0; axis < 3; ++axis) {
    size_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(extent[axis] / edge_) + 1;
  }
}

OccluderGrid OccluderGrid::build(const PotentialOccluders& occluders, const kernel::Aabb& model, const Config& config,
                                 const Checkpoint& checkpoint) {
  OccluderGrid grid(model, config);
  grid.take(list_occluders(grid, occluders, config, checkpoint));
  return grid;
}

OccluderGrid OccluderGrid::restore(const PotentialOccluders& occluders, const kernel::Aabb& model, const Config& config,
                                   Lists lists) {
  OccluderGrid grid(model, config);
  const auto ascend = [&] {
    const auto& [first, listed, hidden] = lists;
    for (std::size_t region = 0; region < grid.regions(); ++region) {
      const auto list = std::span(listed).subspan(first[region], first[region + 1] - first[region]);
      if (std::ranges::adjacent_find(list, std::ranges::greater_equal()) != list.end()) return false;
    }
    return true;
  };
  const auto is_sound = [&] {
    const auto& [first, listed, hidden] = lists;
    return first.size() == grid.regions() + 1 && first.front() == 0 && std::ranges::is_sorted(first) &&
           first.back() == listed.size() && (hidden.empty() || hidden.size() == listed.size()) &&
           std::ranges::all_of(listed, [&](std::uint32_t i) { return i < occluders.size(); }) && ascend() &&
           std::ranges::all_of(hidden, [](float h) { return h >= 0 && std::isfinite(h); });
  };
  if (!is_sound()) throw std::invalid_argument("the lists of occluders are not of this model");
  grid.take(std::move(lists));
  return grid;
}

void OccluderGrid::take(Lists lists) {
  lists_ = std::move(lists);
  for (std::size_t region = 0; region < regions(); ++region) {
    longest_ = std::max(longest_, list(region).occluders.size());
  }
}

std::array<std::size_t, 3> OccluderGrid::cell_of(const glm::dvec3& point) const {
  std::array<std::size_t, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double position = (point[axis] - origin_[axis]) / edge_;
    cell[a] = static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(size_[a] - 1)));
  }
  return cell;
}

std::size_t OccluderGrid::region_at(const glm::dvec3& point) const {
  const auto [x, y, z] = cell_of(point);
  return index(x, y, z);
}

glm::dvec3 OccluderGrid::corner(std::size_t region) const {
  const std::size_t x = region % size_[0], y = region / size_[0] % size_[1], z = region / size_[0] / size_[1];
  return origin_ + edge_ * glm::dvec3(x, y, z);
}

OccluderGrid::List OccluderGrid::list(std::size_t region) const {
  const std::size_t first = lists_.first[region], count = lists_.first[region + 1] - first;
  List list{std::span(lists_.occluders).subspan(first, count), {}};
  if (!lists_.hidden.empty()) list.hidden = std::span(lists_.hidden).subspan(first, count);
  return list;
}

}  // namespace occlude::culler
