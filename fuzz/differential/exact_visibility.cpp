// SPDX-License-Identifier: MIT
#include "differential/exact_visibility.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>

#include "occlude/oracle/visibility.h"

namespace occlude::fuzz {
namespace {

oracle::Point point(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Along the line of sight in parallel light: the direction that the culler has, whose numbers are exact for both.
oracle::Viewpoint viewpoint(const culler::Camera& camera) {
  if (camera.projection == culler::Projection::perspective) return {point(camera.eye)};
  return {point(camera.axes().forward), true};
}

}  // namespace

std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera) {
  std::vector<oracle::Triangle> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      triangles.push_back({point(soup.vertices[loop[0]]), point(soup.vertices[loop[i]]), point(soup.vertices[loop[i + 1]])});
    }
  }
  double reach = 0;
  for (const glm::dvec3& v : soup.vertices) {
    const glm::dvec3 away = glm::abs(v - camera.eye);
    reach = std::max({reach, away.x, away.y, away.z});
  }
  // No deeper than the culler's, whose planes then lie outside of these.
  std::vector<culler::HalfSpace> view;
  culler::append_view_frustum(camera, reach, view);
  constexpr std::size_t kSides = 4;  // left, right, bottom and top come first
  oracle::Picture picture;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const culler::HalfSpace& h = view[i];
    (i < kSides ? picture.sides : picture.depth).push_back({h.normal.x, h.normal.y, h.normal.z, h.offset});
  }
  return oracle::visible_triangles(viewpoint(camera), triangles, picture);
}

}  // namespace occlude::fuzz
