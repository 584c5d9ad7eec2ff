// SPDX-License-Identifier: MIT
#include "occlude/culler/polygon_soup.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "model/bounds.h"
#include "model/legal_soup.h"

namespace occlude::culler {

std::vector<bool> polygons_of(std::span<const PolygonRange> ranges, std::size_t count) {
  std::vector<bool> result(count);
  for (const auto [first, length] : ranges) {
    std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(first), length, true);
  }
  return result;
}

kernel::Aabb SoupView::box(std::size_t p) const {
  kernel::Aabb box = empty_box();
  for (const std::uint32_t index : loop(p)) grow(box, to_kernel(vertices[index]));
  return box;
}

bool is_well_formed(SoupView soup, const Checkpoint& checkpoint) {
  const auto is_vertex = [&](std::size_t i) { return soup.indices[i] < soup.vertices.size(); };
  const auto has_corners = [&](std::size_t p) {
    return std::uint64_t{soup.first[p]} + 3 <= soup.first[p + 1] && soup.first[p + 1] <= soup.indices.size();
  };
  return !soup.first.empty() && soup.first.front() == 0 && soup.first.back() == soup.indices.size() &&
         are_faces(soup.faces, soup.size()) && are_marks(soup.see_through, soup.size()) &&
         are_all(soup.size(), has_corners, checkpoint) && are_all(soup.indices.size(), is_vertex, checkpoint);
}

std::uint32_t PolygonSoup::narrowed(std::size_t number) {
  if (number > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("more than 2^32 vertices or corners");
  return static_cast<std::uint32_t>(number);
}

FaceShape PolygonSoup::add_large_face(std::span<const std::uint32_t> loop) {
  if (fan_is_face(vertices, loop)) {
    add_polygon(loop);
    return FaceShape::fan;
  }
  auto triangles = triangles_of_face(vertices, loop);
  if (!triangles) {
    add_polygon(loop);
    see_through_from(size() - 1);
    return FaceShape::crossing;
  }
  if (triangles->empty()) triangles->push_back({loop[0], loop[0], loop[0]});  // so that the face has its number
  static_cast<void>(narrowed(indices.size() + 3 * triangles->size()));
  const auto face = static_cast<std::uint32_t>(face_count());
  if (faces.empty()) {
    faces.resize(size());
    std::iota(faces.begin(), faces.end(), 0U);
  }
  for (const FaceTriangle& triangle : *triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
    first.push_back(static_cast<std::uint32_t>(indices.size()));
  }
  faces.resize(size(), face);
  if (!see_through.empty()) see_through.resize(size());
  return FaceShape::pieces;
}

void PolygonSoup::see_through_from(std::size_t p) {
  see_through.resize(p, 0);
  see_through.resize(size(), 1);
}

void PolygonSoup::add_box(const glm::dvec3& low, const glm::dvec3& high) {
  std::array<std::uint32_t, 8> corner{};
  for (std::uint32_t i = 0; i < 8; ++i) {
    corner[i] = add_vertex({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  }
  using Face = std::array<std::size_t, 4>;
  for (const auto& [a, b, c, d] : {Face{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    add_polygon(std::array{corner[a], corner[b], corner[c], corner[d]});
  }
}

}  // namespace occlude::culler
