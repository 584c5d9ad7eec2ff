// SPDX-License-Identifier: MIT
#include "place.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace occlude::render {
namespace {

using glm::dvec3;

struct Bounds {
  dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

Bounds bounds(culler::SoupView soup, const std::vector<dvec3>& points) {
  Bounds all;
  for (const std::uint32_t index : soup.indices) {
    all.low = glm::min(all.low, points[index]);
    all.high = glm::max(all.high, points[index]);
  }
  return all;
}

/// x, y and z of the place. For an up of +z they are those of the model, and for other axes a permutation of them.
std::array<dvec3, 3> axes_with(const dvec3& up) {
  const dvec3 size = glm::abs(up);
  const dvec3 across = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                       : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                            : dvec3(0, 0, 1);
  const dvec3 y = glm::normalize(glm::cross(up, across));
  return {glm::cross(y, up), y, up};
}

/// The eye of a person where a model of this size can be one for persons, from a cupboard to a county in metres. Others are
/// taken for a house of 85 m.
double eye_height(double size) {
  constexpr double kPerson = 1.7, kLeast = 3, kMost = 1e5, kHouse = 50;
  return size >= kLeast && size <= kMost ? kPerson : size / kHouse;
}

}  // namespace

Place::Place(culler::SoupView model, const dvec3& up) : soup(model), axes(axes_with(up)) {
  points.assign(soup.vertices.begin(), soup.vertices.end());
  const Bounds in_model = bounds(soup, points);
  for (int axis = 0; axis < 3; ++axis) origin[axis] = std::midpoint(in_model.low[axis], in_model.high[axis]);
  for (dvec3& p : points) {
    p -= origin;
    p = dvec3(glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2]));
  }
  const Bounds all = bounds(soup, points);
  low = all.low;
  high = all.high;
  // Nothing smaller than a large multiple of the rounding of coordinates has a shape. A point at the origin is as good as
  // any.
  constexpr double kDetail = 0x1p-36;
  const double detail = kDetail * glm::length(origin), diagonal = glm::length(size());
  radius = std::max(diagonal / 2, 8 * detail);
  if (radius == 0) radius = 1;
  eye_height = std::max(render::eye_height(std::max({size().x, size().y, size().z})), detail);
  if (eye_height == 0) eye_height = radius;
}

}  // namespace occlude::render
