// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "surfaces.h"

namespace occlude::render {
namespace {

using culler::SoupView;
using glm::dvec3;

// |z| of the unit normal above which a surface counts as level (within 8 degrees), as ground (35) and as a roof (72).
constexpr double kLevel = 0.99, kGround = 0.82, kRoof = 0.3;

// Colours, red, green and blue in [0, 1].
constexpr std::array<dvec3, 2> kPavement = {{{0.74, 0.73, 0.69}, {0.78, 0.77, 0.72}}};
constexpr std::array<dvec3, 2> kEarth = {{{0.68, 0.69, 0.60}, {0.72, 0.72, 0.63}}};
constexpr std::array<dvec3, 4> kTiles = {{{0.74, 0.46, 0.36}, {0.68, 0.49, 0.42}, {0.58, 0.54, 0.54}, {0.78, 0.54, 0.41}}};
constexpr std::array<dvec3, 6> kWalls = {{{0.82, 0.64, 0.54},
                                          {0.92, 0.85, 0.73},
                                          {0.88, 0.77, 0.63},
                                          {0.95, 0.91, 0.84},
                                          {0.78, 0.59, 0.51},
                                          {0.85, 0.80, 0.74}}};

/// Mixes bits so that neighbouring values become unrelated (the finaliser of SplitMix64).
std::uint64_t scramble(std::uint64_t bits) {
  bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9;
  bits = (bits ^ bits >> 27) * 0x94D049BB133111EB;
  return bits ^ bits >> 31;
}

/// Of a point. Both zeros are one.
std::uint64_t hash_of(const dvec3& point) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) hash = scramble(hash ^ std::bit_cast<std::uint64_t>(point[axis] + 0.0));
  return hash;
}

/// The corner of a polygon that comes first in the order of x, y and z.
dvec3 first_corner(SoupView soup, std::size_t polygon) {
  const auto loop = soup.loop(polygon);
  const auto key = [&](std::uint32_t v) { return std::tuple(soup.vertices[v].x, soup.vertices[v].y, soup.vertices[v].z); };
  return soup.vertices[*std::ranges::min_element(loop, {}, key)];
}

/// For each surface, at its number, the hash of its first corner.
std::vector<std::uint64_t> surface_hashes(SoupView soup, const std::vector<std::uint32_t>& surface) {
  const auto key = [](const dvec3& v) { return std::tuple(v.x, v.y, v.z); };
  std::vector<dvec3> first(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const dvec3 corner = first_corner(soup, p);
    const std::uint32_t s = surface[p];
    if (s == p || key(corner) < key(first[s])) first[s] = corner;  // a surface has the number of its first polygon
  }
  std::vector<std::uint64_t> hashes(soup.size());
  std::ranges::transform(first, hashes.begin(), hash_of);
  return hashes;
}

template <std::size_t N>
dvec3 pick(const std::array<dvec3, N>& colours, std::uint64_t hash) {
  return colours[hash % N];
}

dvec3 material(double steepness, std::uint64_t hash) {
  if (steepness > kLevel) return pick(kPavement, hash);
  if (steepness > kGround) return pick(kEarth, hash);
  if (steepness > kRoof) return pick(kTiles, hash);
  return pick(kWalls, hash);
}

}  // namespace

std::vector<dvec3> surface_colours(SoupView soup, const std::vector<dvec3>& normals) {
  const std::vector<std::uint32_t> surface = surfaces(soup, normals);
  const std::vector<std::uint64_t> hashes = surface_hashes(soup, surface);
  std::vector<dvec3> colours(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const std::uint64_t hash = hashes[surface[p]];
    // Up to 4 % darker or brighter, so that equal materials side by side can be distinguished.
    const double variation = 1 + 0.04 * (static_cast<double>(hash >> 32 & 0xFF) / 127.5 - 1);
    colours[p] = variation * material(std::fabs(normals[p].z), hash);
  }
  return colours;
}

}  // namespace occlude::render
