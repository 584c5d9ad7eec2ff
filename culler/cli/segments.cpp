// SPDX-License-Identifier: MIT
#include "segments.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace occlude::cli {
namespace {

/// Of a segment, what is nearer to its ends than this share is not asked: a polygon that touches the point does not hide it.
constexpr double kEnd = 0x1p-30;

}  // namespace

bool Segments::blocks(std::uint32_t p, const glm::dvec3& eye, const glm::dvec3& along) const {
  if (!tree_.soup().is_opaque(p)) return false;
  const auto loop = tree_.soup().loop(p);
  const auto& v = tree_.soup().vertices;
  const glm::dvec3 a = v[loop[0]], to = eye - a;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const glm::dvec3 e = v[loop[i]] - a, f = v[loop[i + 1]] - a, across = glm::cross(along, f), turned = glm::cross(to, e);
    const double determinant = glm::dot(e, across), u = glm::dot(to, across) / determinant,
                 w = glm::dot(along, turned) / determinant, t = glm::dot(f, turned) / determinant;
    if (u >= 0 && w >= 0 && u + w <= 1 && t > kEnd && t < 1 - kEnd) return true;
  }
  return false;
}

bool Segments::is_blocked(const glm::dvec3& eye, const glm::dvec3& point, std::uint32_t own, std::uint32_t& hider) const {
  const glm::dvec3 along = point - eye, inverse = 1.0 / along;
  if (hider != own && blocks(hider, eye, along)) return true;
  const auto nodes = tree_.nodes();
  const auto meets = [&](const culler::HierarchyNode& node) {
    double first = 0, last = 1;
    for (int i = 0; i < 3; ++i) {
      const double low = (node.box.min[i] - eye[i]) * inverse[i], high = (node.box.max[i] - eye[i]) * inverse[i];
      first = std::max(first, std::min(low, high));
      last = std::min(last, std::max(low, high));
    }
    return !(first > last);
  };
  std::array<std::uint32_t, culler::kMostLevels + 1> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t n = waiting[--count];
    const culler::HierarchyNode& node = nodes[n];
    if (!meets(node)) continue;
    if (!node.is_leaf()) {
      waiting[count++] = node.right;
      waiting[count++] = n + 1;
      continue;
    }
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      if (p == own || !blocks(p, eye, along)) continue;
      hider = p;
      return true;
    }
  }
  return false;
}

}  // namespace occlude::cli
