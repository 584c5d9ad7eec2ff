// SPDX-License-Identifier: MIT
// What a camera sees, by single rays and in numbers of another kind than the culler's.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <vector>

#include "occlude/culler/culler.h"
#include "scenes.h"

namespace occlude::culler {

/// Numbers with eleven bits more than those of the culler, for a judge that computes another way.
using Number = long double;
using Vector = glm::vec<3, Number>;

/// What a Camera shows from its eye, relative to the eye.
struct Picture {
  bool is_perspective;
  Vector eye, right, up, forward;
  Number width, height, near, far;

  explicit Picture(const Camera& c)
      : is_perspective(c.projection == Projection::perspective),
        eye(c.eye),
        right(0, 0, 0),
        up(0, 0, 0),
        forward(glm::normalize(Vector(c.target) - Vector(c.eye))),
        near(c.near_plane),
        far(c.far_plane) {
    right = glm::normalize(glm::cross(forward, Vector(c.up)));
    up = glm::cross(right, forward);
    const Number degree = std::acos(Number{-1}) / 180;
    height = is_perspective ? std::tan(degree * Number{c.fov_y_deg} / 2) : Number{c.height} / 2;
    width = height * Number{c.aspect};
  }
  /// Whether a point is in the view.
  [[nodiscard]] bool shows(const glm::dvec3& point) const {
    const Vector seen = Vector(point) - eye;
    const Number along = glm::dot(forward, seen);
    bool is_in = near <= along && along <= far;
    for (const auto& [normal, offset] : sides()) is_in = is_in && glm::dot(normal, seen) + offset >= 0;
    return is_in;
  }
  [[nodiscard]] Vector corner(unsigned i, Number distance) const {
    const Number size = is_perspective ? distance : 1;
    return distance * forward + (i & 1U ? size : -size) * (width * right) + (i & 2U ? size : -size) * (height * up);
  }
  /// The planes of its sides, with unit normals that point inwards: left, right, bottom, top.
  struct Side {
    Vector normal;
    Number offset;
  };
  [[nodiscard]] std::array<Side, 4> sides() const {
    const auto side = [&](const Vector& across, Number half) {
      if (!is_perspective) return Side{across, half};
      return Side{glm::normalize(half * forward + across), 0};
    };
    return {side(right, width), side(Number{-1} * right, width), side(up, height), side(Number{-1} * up, height)};
  }
};

/// Whether a segment from the eye passes the open polygon from the share `begin` of its way to before `end`, by more than
/// rounding can tell. REQUIRES: a triangle or a parallelogram.
inline bool blocks(const SoupView& soup, std::uint32_t p, const glm::dvec3& eye, const glm::dvec3& end, double begin) {
  const auto loop = soup.loop(p);
  const glm::dvec3 &a = soup.vertices[loop[0]], &b = soup.vertices[loop[1]], &c = soup.vertices[loop.back()];
  const glm::dvec3 way = end - eye, x = b - a, y = c - a;
  const double det = glm::dot(glm::cross(way, y), x);
  if (std::fabs(det) < 1e-12) return false;
  const glm::dvec3 s = eye - a, q = glm::cross(s, x);
  const double u = glm::dot(glm::cross(way, y), s) / det, v = glm::dot(way, q) / det, t = glm::dot(y, q) / det;
  const bool is_inside = u > 0 && v > 0 && (loop.size() == 3 ? u + v < 1 : u < 1 && v < 1);
  return is_inside && t > begin && t < 1 - 1e-9;
}

/// Whether no polygon but `of` is before a point that the camera shows, beyond its near plane. REQUIRES: rays from one eye.
inline bool is_clear(const SoupView& soup, const Picture& picture, const glm::dvec3& point,
                     std::uint32_t of = std::numeric_limits<std::uint32_t>::max()) {
  const glm::dvec3 eye(picture.eye);
  const double begin = static_cast<double>(picture.near / glm::dot(picture.forward, Vector(point) - picture.eye));
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    if (p != of && blocks(soup, p, eye, point, begin)) return false;
  }
  return true;
}

/// Any point of a polygon. REQUIRES: a triangle or a parallelogram.
inline glm::dvec3 some_point(const SoupView& soup, std::uint32_t p, std::mt19937& random) {
  const auto loop = soup.loop(p);
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1 - (loop.size() == 3 ? u : 0));
  const glm::dvec3 a = soup.vertices[loop[0]];
  return a + u * (soup.vertices[loop[1]] - a) + v * (soup.vertices[loop.back()] - a);
}

/// A point in each of the polygons of a culler that are not drawn, but for some that are left out, is not seen by the
/// camera. Returns how many of these points are in its view.
inline unsigned expect_hidden(const Culler& culler, const std::vector<bool>& drawn, const Camera& camera,
                              std::mt19937& random, unsigned one_of) {
  const SoupView soup = culler.hierarchy().soup();
  const Picture picture(camera);
  unsigned rays = 0;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    if (drawn[p] || random() % one_of != 0) continue;
    const glm::dvec3 point = some_point(soup, p, random);
    if (!picture.shows(point)) continue;
    ++rays;
    EXPECT_FALSE(is_clear(soup, picture, point, p)) << "polygon " << p;
  }
  return rays;
}

}  // namespace occlude::culler
