// SPDX-License-Identifier: MIT
#include "sight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace occlude::harness {
namespace {

using culler::Camera;
using culler::SoupView;
using glm::dvec3;

// The share of the numbers involved that counts as rounding. A few roundings make 2^-50, which is far less.
constexpr double kMargin = 1e-9;

/// Whether the point is, or may be, outside of the near plane, the far plane or the sides of the picture.
bool may_be_out_of_picture(const dvec3& point, const Camera& camera) {
  const auto [right, up, forward] = camera.axes();
  const dvec3 way = point - camera.eye;
  const double depth = glm::dot(way, forward);
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double half = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) * depth : camera.height / 2;
  const double slack = kMargin * (glm::length(camera.eye) + glm::length(point));
  const auto is_within = [&](double across, double limit) { return std::fabs(across) + slack < limit * (1 - kMargin); };
  return !(depth > camera.near_plane + slack && depth + slack < camera.far_plane && is_within(glm::dot(way, up), half) &&
           is_within(glm::dot(way, right), half * camera.aspect));
}

double volume(const dvec3& a, const dvec3& b, const dvec3& c) { return glm::dot(glm::cross(a, b), c); }

/// Whether the triangle meets the segment or comes near it. It may not when the segment certainly stays on one side of its
/// plane, or when the line of the segment certainly passes outside of an edge.
bool may_meet(const dvec3& from, const dvec3& to, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 p = a - from, q = b - from, r = c - from, way = to - from;
  const double size = glm::length(way) + glm::length(p) + glm::length(q) + glm::length(r);
  const double slack = kMargin * size * size * size;
  const double u = volume(p, q, way), v = volume(q, r, way), w = volume(r, p, way);
  if (std::max({u, v, w}) > slack && std::min({u, v, w}) < -slack) return false;
  const double start = volume(p, q, r), end = volume(a - to, b - to, c - to);
  const bool same_side = std::min(start, end) > slack || std::max(start, end) < -slack;
  return !same_side;
}

}  // namespace

bool is_surely_visible(SoupView soup, std::size_t polygon, const Camera& camera) {
  const dvec3 forward = camera.axes().forward;
  const auto sees = [&](const dvec3& point) {
    if (may_be_out_of_picture(point, camera)) return false;
    const bool perspective = camera.projection == culler::Projection::perspective;
    const dvec3 from = perspective ? camera.eye : point - glm::dot(point - camera.eye, forward) * forward;
    for (std::size_t p = 0; p < soup.size(); ++p) {
      if (p == polygon) continue;
      const auto loop = soup.loop(p);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        if (may_meet(from, point, soup.vertices[loop[0]], soup.vertices[loop[i]], soup.vertices[loop[i + 1]])) return false;
      }
    }
    return true;
  };
  const auto loop = soup.loop(polygon);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    if (sees((soup.vertices[loop[0]] + soup.vertices[loop[i]] + soup.vertices[loop[i + 1]]) / 3.0)) return true;
  }
  return false;
}

}  // namespace occlude::harness
