// SPDX-License-Identifier: MIT
#include "triangle_list.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <stdexcept>

namespace occlude::render {
namespace {

using culler::SoupView;
using glm::dvec3;

// Float coordinates up to here are not recentred: their spacing is at most 1/128, and exact values stay exact.
constexpr double kNearOrigin = 65536;

Extent extent_of(std::span<const dvec3> vertices) {
  if (vertices.empty()) return {};
  Extent extent{vertices[0], vertices[0]};
  for (const dvec3& v : vertices) extent = {glm::min(extent.min, v), glm::max(extent.max, v)};
  return extent;
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

bool stays_exact(const dvec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(v[axis]) > kNearOrigin || !is_float(v[axis])) return false;
  }
  return true;
}

/// The point subtracted before coordinates are converted to float. Zero if they are floats already; else the centre of the
/// model in whole units, which keeps the fractions of the coordinates.
dvec3 choose_centre(std::span<const dvec3> vertices, const Extent& extent) {
  if (std::ranges::all_of(vertices, stays_exact)) return {0, 0, 0};
  return glm::round(0.5 * extent.min + 0.5 * extent.max);
}

Corner corner(const dvec3& relative, std::size_t polygon) {
  return {{static_cast<float>(relative.x), static_cast<float>(relative.y), static_cast<float>(relative.z)},
          static_cast<std::uint32_t>(polygon)};
}

void add_fan(TriangleList& list, SoupView soup, std::size_t polygon) {
  const auto loop = soup.loop(polygon);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    for (const std::size_t at : {std::size_t{0}, i, i + 1})
      list.corners.push_back(corner(soup.vertices[loop[at]] - list.centre, polygon));
  }
  list.first.push_back(static_cast<std::uint32_t>(list.corners.size()));
}

}  // namespace

TriangleList make_triangle_list(SoupView soup) {
  // A polygon with n corners has n - 2 triangles.
  const std::size_t corners = 3 * (soup.indices.size() - 2 * soup.size());
  if (corners > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw std::runtime_error("the model has more triangles than OpenGL can number");
  TriangleList list;
  list.extent = extent_of(soup.vertices);
  list.centre = choose_centre(soup.vertices, list.extent);
  list.corners.reserve(corners);
  list.first.reserve(soup.size() + 1);
  for (std::size_t p = 0; p < soup.size(); ++p) add_fan(list, soup, p);
  return list;
}

}  // namespace occlude::render
