// SPDX-License-Identifier: MIT
// Small models for the culler's tests.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

inline void add(PolygonSoup& soup, const std::vector<glm::dvec3>& polygon) {
  std::vector<std::uint32_t> loop;
  for (const glm::dvec3& v : polygon) loop.push_back(soup.add_vertex(v));
  soup.add_polygon(loop);
}

/// Uniform in [low, high), the same on every machine.
inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

/// The rectangle at this x, from (y0, z0) to (y1, z1).
inline void add_wall(PolygonSoup& soup, double x, double y0, double y1, double z0, double z1) {
  add(soup, {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}});
}

/// Walls perpendicular to both horizontal axes, and small triangles strewn among them, within [-50, 50]^2 x [0, 10].
inline PolygonSoup random_town(std::uint32_t seed, std::size_t polygons) {
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) { return uniform(random, low, high); };
  PolygonSoup soup;
  while (soup.size() < polygons) {
    const double x = number(-50, 50), y = number(-50, 50);
    if (soup.size() % 10 == 0) {
      const double length = number(2, 20);
      if (random() % 2 == 0) {
        add_wall(soup, x, y, y + length, 0, number(3, 10));
      } else {
        add(soup, {{x, y, 0}, {x + length, y, 0}, {x + length, y, 5}, {x, y, 5}});
      }
    } else {
      const glm::dvec3 at{x, y, number(0, 5)};
      const auto near = [&] { return at + glm::dvec3{number(-0.5, 0.5), number(-0.5, 0.5), number(-0.5, 0.5)}; };
      add(soup, {near(), near(), near()});
    }
  }
  return soup;
}

/// The box from `low` to `high`, every face turned outwards. A face is a quadrilateral, or two triangles along a diagonal
/// that begins at the lowest corner of the box or ends at the highest.
inline void add_box(PolygonSoup& soup, const glm::dvec3& low, const glm::dvec3& high, bool triangles = false) {
  std::array<std::uint32_t, 8> corners{};
  for (std::uint32_t i = 0; i < 8; ++i) {
    corners[i] = soup.add_vertex({i & 1U ? high.x : low.x, i & 2U ? high.y : low.y, i & 4U ? high.z : low.z});
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : kFaces) {
    const std::array loop{corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
    if (triangles) {
      soup.add_polygon(std::array{loop[0], loop[1], loop[2]});
      soup.add_polygon(std::array{loop[0], loop[2], loop[3]});
    } else {
      soup.add_polygon(loop);
    }
  }
}

/// random_town() with a house of six quadrilaterals or twelve triangles for every forty polygons.
inline PolygonSoup random_town_of_houses(std::uint32_t seed, std::size_t polygons) {
  PolygonSoup soup = random_town(seed, polygons);
  std::mt19937 random(seed + 1);
  for (std::size_t i = 0; i < polygons / 40; ++i) {
    const auto number = [&](double low, double high) { return uniform(random, low, high); };
    const double x = number(-50, 50), y = number(-50, 50), z = number(0, 1);
    const glm::dvec3 low{x, y, z};
    const double width = number(1, 8), depth = number(1, 8), height = number(2, 9);
    add_box(soup, low, low + glm::dvec3{width, depth, height}, i % 2 == 0);
  }
  return soup;
}

}  // namespace occlude::culler
