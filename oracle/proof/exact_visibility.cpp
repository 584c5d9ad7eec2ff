// SPDX-License-Identifier: MIT
#include "exact_visibility.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "camera_picture.h"
#include "triangles.h"

namespace occlude::proof {
namespace {

/// The picture is smaller by this share of the depth of the model. This is far too little to be seen.
constexpr double kSmaller = 0x1p-40;

}  // namespace

std::vector<bool> visible_triangles(culler::SoupView soup, const culler::Camera& camera) {
  std::vector<oracle::Triangle> triangles;
  std::vector<bool> see_through;
  double depth = 0;
  for (const glm::dvec3& v : soup.vertices) depth = std::max(depth, glm::distance(v, camera.eye));
  for (std::size_t p = 0; p < soup.size(); ++p) {
    see_through.resize(see_through.size() + soup.triangles(p), !soup.is_opaque(p));
    for_each_triangle(soup, static_cast<std::uint32_t>(p), [&](const oracle::Triangle& t) { triangles.push_back(t); });
  }
  return oracle::visible_triangles(viewpoint_of(camera), triangles, picture_of(camera, -kSmaller * depth), see_through);
}

}  // namespace occlude::proof
