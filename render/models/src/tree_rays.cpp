// SPDX-License-Identifier: MIT
#include "occlude/render/tree_rays.h"

#include <glm/geometric.hpp>

namespace occlude::render {
namespace {

double extent_of(const kernel::Aabb& box) {
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max({most, std::fabs(box.min[i]), std::fabs(box.max[i])});
  return most;
}

}  // namespace

TreeRays::TreeRays(const culler::Hierarchy& tree) : tree_(tree), extent_(extent_of(tree.nodes()[0].box)) {}

/// As Möller and Trumbore do it (1997), with each triangle of the fan.
double TreeRays::meeting(const glm::dvec3& from, const glm::dvec3& along, double first, std::uint32_t polygon) const {
  const auto loop = tree_.soup().loop(polygon);
  const auto& v = tree_.soup().vertices;
  const glm::dvec3 a = v[loop[0]], to = from - a;
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const glm::dvec3 e = v[loop[i]] - a, f = v[loop[i + 1]] - a, across = glm::cross(along, f), turned = glm::cross(to, e);
    const double determinant = glm::dot(e, across), u = glm::dot(to, across) / determinant,
                 w = glm::dot(along, turned) / determinant, share = glm::dot(f, turned) / determinant;
    if (u >= 0 && w >= 0 && u + w <= 1 && share >= first && !(share >= nearest)) nearest = share;
  }
  return nearest;
}

}  // namespace occlude::render
