// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

#include "occlude/culler/parallel.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// A share of the occluders and how many of them each region lists.
struct Share {
  std::size_t first, end;
  std::vector<std::uint64_t> counts;
};

/// Beyond this counting them would take all memory.
constexpr double kMostRegions = 0x1p30;
/// So many that all processors have work to the end, so few that their counts fit in a cache.
constexpr std::size_t kShares = 16;

}  // namespace

/// The set of viewpoints with area-angle above the threshold lies within distance sqrt(a / threshold) of the centre. Within
/// a region |N . V| is at most its value at the region's middle plus what half the diagonal adds along N, and |V| at least
/// the distance to the region.
template <class Visit>
void OccluderGrid::for_each_region(const PotentialOccluder& occluder, double threshold, Visit&& visit) const {
  const double area = occluder.area();
  const double reach = std::sqrt(area / threshold);
  if (!(reach > 0) || !std::isfinite(reach)) return;
  const auto low = cell_of(occluder.centre - reach), high = cell_of(occluder.centre + reach);
  const glm::dvec3 n = glm::abs(occluder.area_normal);
  const double slack = (n.x + n.y + n.z) * edge_ / 2;
  for (std::size_t z = low[2]; z <= high[2]; ++z) {
    for (std::size_t y = low[1]; y <= high[1]; ++y) {
      for (std::size_t x = low[0]; x <= high[0]; ++x) {
        const glm::dvec3 middle = origin_ + edge_ * (glm::dvec3(x, y, z) + 0.5);
        const glm::dvec3 to_middle = occluder.centre - middle;
        const glm::dvec3 gap = glm::max(glm::abs(to_middle) - edge_ / 2, 0.0);
        const double nearest = glm::length(gap);
        const double projected = std::fabs(glm::dot(occluder.area_normal, to_middle)) + slack;
        const double round = occluder.round_area * (nearest + std::sqrt(3.0) * edge_);
        if (nearest <= reach && projected + round >= threshold * nearest * nearest * nearest) visit(index(x, y, z));
      }
    }
  }
}

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

OccluderGrid OccluderGrid::build(const PotentialOccluders& occluders, const kernel::Aabb& model, const Config& config) {
  OccluderGrid grid(model, config);
  std::vector<Share> shares;
  for (std::size_t i = 0; i < kShares; ++i) {
    shares.push_back({occluders.size() * i / kShares, occluders.size() * (i + 1) / kShares, {}});
  }
  const auto for_each_entry = [&](const Share& share, auto&& visit) {
    for (std::size_t i = share.first; i < share.end; ++i) {
      grid.for_each_region(occluders[i], config.threshold, [&](std::size_t region) { visit(region, i); });
    }
  };
  parallel_for(kShares, [&](std::size_t s) {
    shares[s].counts.assign(grid.regions(), 0);
    for_each_entry(shares[s], [&](std::size_t region, std::size_t) { ++shares[s].counts[region]; });
  });
  // From counts to places: within a region the shares follow one another, so that lists ascend.
  std::vector<std::uint64_t>& first = grid.lists_.first;
  first.assign(grid.regions() + 1, 0);
  std::uint64_t total = 0;
  for (std::size_t region = 0; region < grid.regions(); ++region) {
    for (Share& share : shares) total += std::exchange(share.counts[region], total);
    first[region + 1] = total;
  }
  grid.lists_.occluders.resize(total);
  parallel_for(kShares, [&](std::size_t s) {
    for_each_entry(shares[s], [&](std::size_t region, std::size_t i) {
      grid.lists_.occluders[shares[s].counts[region]++] = static_cast<std::uint32_t>(i);
    });
  });
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
  grid.lists_ = std::move(lists);
  return grid;
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
