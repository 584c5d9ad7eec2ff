// SPDX-License-Identifier: MIT
// Small models for the culler's tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

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

inline kernel::Vec3 random_vector(std::mt19937& random, double low, double high) {
  const double x = uniform(random, low, high), y = uniform(random, low, high);
  return {x, y, uniform(random, low, high)};
}

/// Each coordinate from -size to size.
inline glm::dvec3 random_point(std::mt19937& random, double size = 1) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
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

/// PolygonSoup::add_box() with two triangles for each face, if wanted: along a diagonal that begins at the lowest corner of
/// the box or ends at the highest.
inline void add_box(PolygonSoup& soup, const glm::dvec3& low, const glm::dvec3& high, bool triangles) {
  if (!triangles) return soup.add_box(low, high);
  PolygonSoup box;
  box.add_box(low, high);
  const std::uint32_t begin = PolygonSoup::narrowed(soup.vertices.size());
  for (const glm::dvec3& v : box.vertices) soup.add_vertex(v);
  for (std::size_t p = 0; p < box.size(); ++p) {
    const auto face = box.loop(p);
    for (std::size_t i = 2; i < face.size(); ++i) {
      soup.add_polygon(std::array{begin + face[0], begin + face[i - 1], begin + face[i]});
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
