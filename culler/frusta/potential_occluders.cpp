// SPDX-License-Identifier: MIT
#include "frusta/potential_occluders.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/adjacency.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// The centre and the radius of a ball around some vertices.
PotentialOccluder ball(SoupView soup, std::span<const std::uint32_t> vertices) {
  const glm::dvec3 base = soup.vertices[vertices[0]];
  glm::dvec3 sum{0, 0, 0};
  for (const std::uint32_t i : vertices) sum += soup.vertices[i] - base;
  PotentialOccluder result{.centre = base + sum / static_cast<double>(vertices.size())};
  for (const std::uint32_t i : vertices) {
    result.radius = std::max(result.radius, glm::distance(soup.vertices[i], result.centre));
  }
  return result;
}

PotentialOccluder region(SoupView soup, std::span<const std::uint32_t> loop) {
  PotentialOccluder result = ball(soup, loop);
  result.area_normal = doubled_area(soup, loop) / 2.0;
  return result;
}

PotentialOccluder shell(SoupView soup, std::span<const std::uint32_t> polygons) {
  std::vector<std::uint32_t> vertices;
  double surface = 0;
  for (const std::uint32_t p : polygons) {
    const auto loop = soup.loop(p);
    vertices.insert(vertices.end(), loop.begin(), loop.end());
    surface += glm::length(doubled_area(soup, loop)) / 2;
  }
  PotentialOccluder result = ball(soup, vertices);
  result.round_area = surface / 4;
  return result;
}

}  // namespace

double PotentialOccluder::area_angle(const glm::dvec3& eye) const {
  const glm::dvec3 v = centre - eye;
  const double squared = glm::dot(v, v), distance = std::sqrt(squared);
  return squared == 0 ? 0 : (std::fabs(glm::dot(area_normal, v)) + round_area * distance) / (squared * distance);
}

double PotentialOccluder::area() const { return glm::length(area_normal) + round_area; }

PotentialOccluders PotentialOccluders::find(SharedSoup shared, const OccluderConfig& config, const Checkpoint& checkpoint) {
  const SoupView soup = shared.view;
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  const std::vector<SidePair> adjacency = find_adjacency(soup, weld, checkpoint);
  PotentialOccluders result;
  result.regions_ = ConvexRegions::find(soup, adjacency, checkpoint);
  if (config.shells) result.shells_ = ConvexShells::find(soup, adjacency, checkpoint);
  const ConvexRegions& regions = result.regions_;
  const std::vector<bool> is_repeated = find_repeated(soup, weld, checkpoint);
  const auto is_left_out = [&](std::uint32_t i) {
    if (regions.loop(i).empty() || regions.loop(i).size() > ConvexRegions::kMostSides) return true;
    // A repeated polygon that is a part of something larger stays, because it stands for that in a list.
    return i < soup.size() && is_repeated[i] && result.container(i) == i;
  };
  std::vector<PotentialOccluder> known(regions.size() + result.shells_.size());
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    checkpoint.at(i);
    if (!is_left_out(i)) known[i] = region(soup, regions.loop(i));
  }
  for (std::size_t i = 0; i < result.shells_.size(); ++i) {
    known[regions.size() + i] = shell(soup, result.shells_.parts(i));
  }
  result.known_ = std::move(known);
  result.soup_ = std::move(shared);
  return result;
}

void PotentialOccluders::vertices(std::size_t i, std::vector<kernel::Vec3>& vertices) const {
  vertices.clear();
  if (is_shell(i)) {
    const auto own = polytope(i).vertices();
    vertices.assign(own.begin(), own.end());
  } else {
    for (const std::uint32_t index : loop(i)) vertices.push_back(to_kernel(soup().vertices[index]));
  }
}

OccluderGeometry PotentialOccluders::geometry(std::size_t i) const {
  if (is_shell(i)) return polytope_of(soup(), parts(i));
  std::vector<kernel::Vec3> polygon;
  vertices(i, polygon);
  return polygon;
}

kernel::ShadowFrustumResult PotentialOccluders::shadow(std::size_t i, const kernel::Viewpoint& viewpoint,
                                                       kernel::Near near) const {
  if (is_shell(i)) return kernel::ShadowFrustum::make(viewpoint, polytope(i), near);
  return kernel::ShadowFrustum::make(viewpoint, std::get<std::vector<kernel::Vec3>>(geometry(i)), near);
}

std::uint32_t PotentialOccluders::container(std::uint32_t i) const {
  if (is_shell(i)) return i;
  const std::uint32_t polygon = regions_.parts(i)[0];
  if (i == polygon && regions_.whole(polygon) != polygon) return regions_.whole(polygon);
  const std::uint32_t shell = shells_.shell_of(polygon);
  return shell == ConvexShells::kNone ? i : static_cast<std::uint32_t>(regions_.size()) + shell;
}

}  // namespace occlude::culler
