// SPDX-License-Identifier: MIT
#include "model/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "model/bounds.h"
#include "occlude/kernel/containment.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

constexpr BoxAxes kCoordinateAxes{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}};

/// Components of axes below this are dropped, because with the smallest half edges they would leave the kernel's legal
/// range. The box is widened by more than that tilts it.
constexpr double kNegligible = 0x1p-52;

/// The axes along the edge from `from` to `to`, as far as it lies in the plane with this normal; across it in the plane; and
/// along the normal. They are the coordinate axes if there is no such edge or plane.
BoxAxes axes_along(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& normal) {
  const double length = glm::length(normal);
  if (!(length > 0)) return kCoordinateAxes;
  const glm::dvec3 n = normal / length, edge = to - from, along = edge - glm::dot(edge, n) * n;
  // An edge that points more out of the plane than along it says nothing about the plane.
  if (!(2 * glm::dot(along, along) > glm::dot(edge, edge))) return kCoordinateAxes;
  BoxAxes axes{glm::normalize(along), glm::normalize(glm::cross(n, along)), n};
  for (glm::dvec3& axis : axes) {
    for (int k = 0; k < 3; ++k) {
      if (std::fabs(axis[k]) < kNegligible) axis[k] = 0;
    }
  }
  return axes;
}

std::size_t largest_polygon(SoupView soup, const PolygonRange& polygons) {
  std::size_t largest = polygons.first;
  double square = 0;
  for (std::size_t p = polygons.first; p < std::size_t{polygons.first} + polygons.count; ++p) {
    const glm::dvec3 area = doubled_area(soup, soup.loop(p));
    if (glm::dot(area, area) <= square) continue;
    square = glm::dot(area, area);
    largest = p;
  }
  return largest;
}

/// The vertices of all loops, one loop after another.
std::span<const std::uint32_t> vertices_of(SoupView soup, const PolygonRange& polygons) {
  const std::uint32_t begin = soup.first[polygons.first], end = soup.first[polygons.first + polygons.count];
  return std::span(soup.indices).subspan(begin, end - begin);
}

bool holds_all(const kernel::Obb& box, SoupView soup, const PolygonRange& polygons) {
  return std::ranges::all_of(vertices_of(soup, polygons),
                             [&](std::uint32_t i) { return kernel::contains(box, to_kernel(soup.vertices[i])); });
}

}  // namespace

Fit fit_along(const BoxAxes& axes, SoupView soup, const PolygonRange& polygons) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Fit fit{axes, glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
  for (const std::uint32_t i : vertices_of(soup, polygons)) {
    const glm::dvec3& v = soup.vertices[i];
    const glm::dvec3 along{glm::dot(axes[0], v), glm::dot(axes[1], v), glm::dot(axes[2], v)};
    fit.low = glm::min(fit.low, along);
    fit.high = glm::max(fit.high, along);
  }
  const glm::dvec3 extent = fit.high - fit.low;
  fit.half_area = extent.x * extent.y + extent.y * extent.z + extent.z * extent.x;
  return fit;
}

Fit fit_along_largest(SoupView soup, const PolygonRange& polygons) {
  // The edges of a triangle are the diagonal of a wall and two of its sides. Of many edges, later ones repeat the directions
  // of the first.
  constexpr std::size_t kMostEdges = 8;
  const std::size_t largest = largest_polygon(soup, polygons);
  const auto loop = soup.loop(largest);
  const glm::dvec3 normal = doubled_area(soup, loop);
  Fit best = fit_along(kCoordinateAxes, soup, polygons);
  for (std::size_t i = 0; i < std::min(loop.size(), kMostEdges); ++i) {
    const glm::dvec3 &from = soup.vertices[loop[i]], &to = soup.vertices[loop[(i + 1) % loop.size()]];
    const Fit fit = fit_along(axes_along(from, to, normal), soup, polygons);
    if (fit.half_area < best.half_area) best = fit;
  }
  return best;
}

std::optional<kernel::Obb> enclosing_box(const Fit& fit, SoupView soup, const PolygonRange& polygons) {
  const glm::dvec3 middle = fit.low / 2.0 + fit.high / 2.0, half = fit.high / 2.0 - fit.low / 2.0;
  kernel::Obb box{to_kernel(middle.x * fit.axes[0] + middle.y * fit.axes[1] + middle.z * fit.axes[2]), {}};
  // Extents along the axes, and the centre made from them, are off by a few roundings of the largest coordinate. Axes that
  // are not quite orthogonal tilt the faces by a few roundings of the extent. 2^-50 of the largest coordinate is about both
  // together. The least slack keeps a flat box thick enough to have a volume, and its numbers legal.
  const double size = std::max({std::fabs(fit.low.x), std::fabs(fit.low.y), std::fabs(fit.low.z), std::fabs(fit.high.x),
                                std::fabs(fit.high.y), std::fabs(fit.high.z)});
  constexpr int kMostTries = 6;  // up to a slack of 2^-40, far below single precision (2^-24)
  double slack = std::max(0x1p-50 * size, 4 * kernel::kMinMagnitude);
  for (int i = 0; i < kMostTries; ++i, slack *= 4) {
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      box.half_edges[axis] = to_kernel((half[k] + slack) * fit.axes[axis]);
    }
    if (kernel::check(box) != kernel::Refusal::none) return std::nullopt;
    if (holds_all(box, soup, polygons)) return box;
  }
  return std::nullopt;
}

}  // namespace occlude::culler
