// SPDX-License-Identifier: MIT
// Small models to walk and fly through, z up, in metres.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render::scenes {

using culler::PolygonSoup;
using glm::dvec3;

inline void add_face(PolygonSoup& soup, const std::array<dvec3, 4>& corners) {
  std::array<std::uint32_t, 4> loop{};
  for (std::size_t i = 0; i < 4; ++i) loop[i] = soup.add_vertex(corners[i]);
  soup.add_polygon(loop);
}

/// A box whose faces turn inwards.
inline void add_room(PolygonSoup& soup, const dvec3& low, const dvec3& high) {
  PolygonSoup box;
  box.add_box(low, high);
  for (std::size_t p = 0; p < box.size(); ++p) {
    const auto loop = box.loop(p);
    add_face(soup, {box.vertices[loop[3]], box.vertices[loop[2]], box.vertices[loop[1]], box.vertices[loop[0]]});
  }
}

/// An upright wall from a to b.
inline void add_wall(PolygonSoup& soup, const dvec3& a, const dvec3& b, double height) {
  add_face(soup, {a, b, b + dvec3(0, 0, height), a + dvec3(0, 0, height)});
}

inline void add_ground(PolygonSoup& soup, const dvec3& low, const dvec3& high) {
  add_face(soup, {low, {high.x, low.y, low.z}, {high.x, high.y, low.z}, {low.x, high.y, low.z}});
}

/// A closed room, 12 m long, that a wall at x = 6 divides. Its door is a metre wide and 2.1 m high.
inline PolygonSoup two_rooms() {
  PolygonSoup soup;
  add_room(soup, {0, 0, 0}, {12, 6, 3});
  add_wall(soup, {6, 0, 0}, {6, 4, 0}, 3);
  add_wall(soup, {6, 5, 0}, {6, 6, 0}, 3);
  add_wall(soup, {6, 4, 2.1}, {6, 5, 2.1}, 0.9);
  return soup;
}

/// A street along x, 8 m wide, between two terraces of houses, on a wide plain.
inline PolygonSoup street() {
  PolygonSoup soup;
  add_ground(soup, {-100, -80, 0}, {100, 80, 0});
  for (int i = -4; i < 4; ++i) {
    soup.add_box({10.0 * i, 4, 0}, {10.0 * (i + 1), 14, 9});
    soup.add_box({10.0 * i, -14, 0}, {10.0 * (i + 1), -4, 9});
  }
  return soup;
}

/// A hall in which a stair of 14 steps leads from a floor at z = 0 to one at z = 2.52.
inline PolygonSoup stairs() {
  PolygonSoup soup;
  add_room(soup, {0, 0, 0}, {14, 5, 6});
  for (int i = 0; i < 14; ++i) soup.add_box({5 + 0.28 * i, 0, 0}, {5 + 0.28 * (i + 1), 5, 0.18 * (i + 1)});
  soup.add_box({5 + 0.28 * 14, 0, 0}, {14, 5, 2.52});
  return soup;
}

inline PolygonSoup closed_box() {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {10, 10, 10});
  return soup;
}

/// A box of 10 m with a hole of 4 m in its side x = 10.
inline PolygonSoup hollow_box() {
  PolygonSoup soup;
  PolygonSoup box;
  box.add_box({0, 0, 0}, {10, 10, 10});
  for (std::size_t p = 0; p < box.size(); ++p) {
    const auto loop = box.loop(p);
    if (p != 1) add_face(soup, {box.vertices[loop[0]], box.vertices[loop[1]], box.vertices[loop[2]], box.vertices[loop[3]]});
  }
  add_wall(soup, {10, 0, 0}, {10, 3, 0}, 10);
  add_wall(soup, {10, 7, 0}, {10, 10, 0}, 10);
  add_wall(soup, {10, 3, 0}, {10, 7, 0}, 3);
  add_wall(soup, {10, 3, 7}, {10, 7, 7}, 3);
  return soup;
}

/// A block of 10 m with a pit in its top, 1 m wide and deep, of which a flight sees little.
inline PolygonSoup pit() {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {4.5, 10, 10});
  soup.add_box({5.5, 0, 0}, {10, 10, 10});
  soup.add_box({4.5, 0, 0}, {5.5, 4.5, 10});
  soup.add_box({4.5, 5.5, 0}, {5.5, 10, 10});
  soup.add_box({4.5, 4.5, 0}, {5.5, 5.5, 9});
  return soup;
}

inline double landscape_height(double x, double y) { return 8 * std::sin(x / 30) * std::cos(y / 25); }

/// Gentle hills, 160 m square.
inline PolygonSoup landscape() {
  PolygonSoup soup;
  constexpr std::uint32_t kCells = 40;
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const double x = 4.0 * i, y = 4.0 * j;
      soup.add_vertex({x, y, landscape_height(x, y)});
    }
  }
  for (std::uint32_t j = 0; j < kCells; ++j) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i, b = a + kCells + 1;
      soup.add_polygon(std::array{a, a + 1, b + 1, b});
    }
  }
  return soup;
}

/// Triangles as large as a third of the model, anywhere.
inline PolygonSoup random_triangles(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](double size) { return size * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  PolygonSoup soup;
  for (int i = 0; i < 60; ++i) {
    const dvec3 middle(number(40), number(40), number(40));
    std::array<std::uint32_t, 3> loop{};
    for (std::uint32_t& corner : loop) corner = soup.add_vertex(middle + dvec3(number(15), number(15), number(15)));
    soup.add_polygon(loop);
  }
  return soup;
}

}  // namespace occlude::render::scenes
