// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "occlude/render/polygon_area.h"
#include "triangle_list.h"

namespace occlude::render {
namespace {

using glm::dvec3;

// Direction to the sun, south-west and 45 degrees high.
constexpr dvec3 kSun = {-0.57, -0.42, 0.71};

// Light on every surface, and the light that the sun adds to a surface facing it.
constexpr double kAmbient = 0.62, kSunlight = 0.38;

// |z| of the unit normal above which a surface counts as level (within 8 degrees), as ground (35) and as a roof (72).
constexpr double kLevel = 0.99, kGround = 0.82, kRoof = 0.3;

// Colours, red, green and blue in [0, 1].
constexpr std::array<dvec3, 2> kPavement = {{{0.66, 0.66, 0.60}, {0.71, 0.70, 0.64}}};
constexpr std::array<dvec3, 2> kGrass = {{{0.53, 0.62, 0.42}, {0.60, 0.66, 0.46}}};
constexpr std::array<dvec3, 4> kTiles = {{{0.72, 0.42, 0.32}, {0.66, 0.46, 0.38}, {0.55, 0.50, 0.50}, {0.76, 0.50, 0.36}}};
constexpr std::array<dvec3, 6> kWalls = {{{0.78, 0.56, 0.45},
                                          {0.88, 0.80, 0.66},
                                          {0.84, 0.70, 0.54},
                                          {0.92, 0.87, 0.78},
                                          {0.72, 0.50, 0.42},
                                          {0.80, 0.74, 0.66}}};

/// Of length one, or zero without area.
dvec3 unit_normal(const culler::PolygonSoup& soup, std::size_t polygon) {
  const dvec3 sum = doubled_area(soup, polygon);
  const double length = glm::length(sum);
  return length > 0 && std::isfinite(length) ? sum / length : dvec3(0, 0, 0);
}

/// Mixes bits so that neighbouring values become unrelated (the finaliser of SplitMix64).
std::uint64_t scramble(std::uint64_t bits) {
  bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9;
  bits = (bits ^ bits >> 27) * 0x94D049BB133111EB;
  return bits ^ bits >> 31;
}

/// The centre of the polygon's box: the same point for both triangles of a rectangle.
dvec3 middle(const culler::PolygonSoup& soup, std::size_t polygon) {
  dvec3 low = soup.vertices[soup.loop(polygon)[0]], high = low;
  for (const std::uint32_t index : soup.loop(polygon)) {
    low = glm::min(low, soup.vertices[index]);
    high = glm::max(high, soup.vertices[index]);
  }
  return 0.5 * low + 0.5 * high;
}

std::uint64_t combine(std::uint64_t hash, double value) {
  // Larger values do not fit into a 64-bit integer.
  constexpr double kLargest = 1e18;
  return scramble(hash ^ static_cast<std::uint64_t>(std::llround(std::clamp(value, -kLargest, kLargest))));
}

/// Equal for polygons of one surface: the same cell of 64 units, the same normal to 1/8 and the same distance from the
/// centre of the cell to 4 units. Coarse enough that most triangles of a scanned wall, which is never quite plane, agree.
std::uint64_t plane_hash(const dvec3& normal, const dvec3& point) {
  constexpr double kCell = 64, kDirections = 8, kDistance = 4;
  const dvec3 cell = glm::floor(point / kCell);
  std::uint64_t hash = combine(0, glm::dot(normal, point - (cell + 0.5) * kCell) / kDistance);
  for (int axis = 0; axis < 3; ++axis) {
    hash = combine(hash, cell[axis]);
    hash = combine(hash, normal[axis] * kDirections);
  }
  return hash;
}

template <std::size_t N>
dvec3 pick(const std::array<dvec3, N>& colours, std::uint64_t hash) {
  return colours[hash % N];
}

dvec3 material(double steepness, std::uint64_t hash) {
  if (steepness > kLevel) return pick(kPavement, hash);
  if (steepness > kGround) return pick(kGrass, hash);
  if (steepness > kRoof) return pick(kTiles, hash);
  return pick(kWalls, hash);
}

std::uint8_t channel(double value) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); }

}  // namespace

Rgba polygon_colour(const culler::PolygonSoup& soup, std::size_t polygon) {
  dvec3 normal = unit_normal(soup, polygon);
  // The winding of soup is not reliable, so both sides have the same colour.
  if (normal.z < 0 || (normal.z == 0 && (normal.y < 0 || (normal.y == 0 && normal.x < 0)))) normal = -normal;
  const std::uint64_t hash = plane_hash(normal, middle(soup, polygon));
  const double light = kAmbient + kSunlight * std::fabs(glm::dot(normal, kSun));
  // Up to 4 % darker or brighter, so that equal materials side by side can be distinguished.
  const double variation = 1 + 0.04 * (static_cast<double>(hash >> 32 & 0xFF) / 127.5 - 1);
  const dvec3 colour = light * variation * material(normal.z, hash);
  return {channel(colour.r), channel(colour.g), channel(colour.b), 255};
}

}  // namespace occlude::render
