// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

PotentialOccluder potential_occluder(const PolygonSoup& soup, std::span<const std::uint32_t> loop) {
  const glm::dvec3 base = soup.vertices[loop[0]];
  glm::dvec3 sum{0, 0, 0};
  kernel::Aabb box = empty_box();
  for (const std::uint32_t i : loop) {
    sum += soup.vertices[i] - base;
    grow(box, to_kernel(soup.vertices[i]));
  }
  return {base + sum / static_cast<double>(loop.size()), doubled_area(soup, loop) / 2.0, box};
}

}  // namespace

double PotentialOccluder::area_angle(const glm::dvec3& eye) const {
  const glm::dvec3 v = centre - eye;
  const double squared = glm::dot(v, v);
  return squared == 0 ? 0 : std::fabs(glm::dot(area_normal, v)) / (squared * std::sqrt(squared));
}

/// The set of viewpoints with area-angle above the threshold lies within distance sqrt(a / threshold) of the centre. Within
/// a region |N . V| is at most its value at the region's middle plus what half the diagonal adds along N, and |V| at least
/// the distance to the region.
template <class Visit>
void OccluderGrid::for_each_region(const PotentialOccluder& occluder, double threshold, Visit&& visit) const {
  const double area = glm::length(occluder.area_normal);
  const double reach = std::sqrt(area / threshold);
  if (!(reach > 0) || !std::isfinite(reach)) return;
  const auto low = region_of(occluder.centre - reach), high = region_of(occluder.centre + reach);
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
        if (nearest <= reach && projected >= threshold * nearest * nearest * nearest) visit(index(x, y, z));
      }
    }
  }
}

OccluderGrid OccluderGrid::build(const PolygonSoup& soup, const ConvexRegions& occluders, const kernel::Aabb& box,
                                 const Config& config) {
  OccluderGrid grid;
  grid.origin_ = {box.min.x, box.min.y, box.min.z};
  const glm::dvec3 extent{box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z};
  // Cubes of one edge e with about `regions` of them in the box; a flat box counts as at least 1/1000 thick so that e stays
  // in proportion to the model.
  const double largest = std::max({extent.x, extent.y, extent.z, kernel::kMinMagnitude});
  const glm::dvec3 solid = glm::max(extent, largest / 1000);
  grid.edge_ = largest * std::cbrt(solid.x / largest * (solid.y / largest) * (solid.z / largest) / config.regions);
  for (int axis = 0; axis < 3; ++axis) {
    grid.size_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(extent[axis] / grid.edge_) + 1;
  }

  grid.occluders_.reserve(occluders.size());
  for (std::size_t i = 0; i < occluders.size(); ++i) {
    grid.occluders_.push_back(potential_occluder(soup, occluders.loop(i)));
  }

  std::vector<std::size_t>& first = grid.first_;
  first.assign(grid.size_[0] * grid.size_[1] * grid.size_[2] + 1, 0);
  for (const PotentialOccluder& o : grid.occluders_) {
    grid.for_each_region(o, config.threshold, [&](std::size_t region) { ++first[region + 1]; });
  }
  for (std::size_t r = 1; r < first.size(); ++r) first[r] += first[r - 1];
  grid.lists_.resize(first.back());
  std::vector<std::size_t> end(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < occluders.size(); ++i) {
    grid.for_each_region(grid.occluders_[i], config.threshold,
                         [&](std::size_t region) { grid.lists_[end[region]++] = static_cast<std::uint32_t>(i); });
  }
  return grid;
}

std::array<std::size_t, 3> OccluderGrid::region_of(const glm::dvec3& point) const {
  std::array<std::size_t, 3> region{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double position = (point[axis] - origin_[axis]) / edge_;
    region[a] = static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(size_[a] - 1)));
  }
  return region;
}

std::span<const std::uint32_t> OccluderGrid::list(const glm::dvec3& point) const {
  const auto [x, y, z] = region_of(point);
  const std::size_t region = index(x, y, z);
  return std::span(lists_).subspan(first_[region], first_[region + 1] - first_[region]);
}

}  // namespace occlude::culler
