// SPDX-License-Identifier: MIT
#include "scene/packed_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

constexpr unsigned kEdgeBits = 10;
constexpr int kMostUnits = (1 << (kEdgeBits - 1)) - 1;
/// The half-width of the outer box in units. No edge of the box within is longer on any axis; what is left up to kMostUnits
/// is room to grow.
constexpr double kUnits = 500;

/// Edges in units are columns: what is unpacked is `middle` and each edge times `unit`, axis by axis.
using EdgeVectors = std::array<glm::dvec3, 3>;

struct EdgeGrid {
  glm::dvec3 middle, unit, units;  ///< units of 1, or 0

  explicit EdgeGrid(const kernel::Aabb& outer) {
    // The outer box of a box that is flat at 0 has a width of 2^-99, so that its numbers are legal. With a larger one
    // every number of a grid is 0 or legal.
    constexpr double kFlat = 0x1p-90;
    for (int axis = 0; axis < 3; ++axis) {
      const double half = outer.max[axis] / 2 - outer.min[axis] / 2;
      middle[axis] = outer.min[axis] / 2 + outer.max[axis] / 2;
      unit[axis] = half < kFlat ? 0 : half / kUnits;
      units[axis] = half < kFlat ? 0 : kUnits / half;
    }
  }

  /// None if a flat grid cannot have the vector.
  [[nodiscard]] std::optional<glm::dvec3> in_units(const glm::dvec3& v) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (unit[axis] == 0 && v[axis] != 0) return std::nullopt;
    }
    return v * units;
  }

  [[nodiscard]] kernel::Obb box(const EdgeVectors& whole) const {
    kernel::Obb box{to_kernel(middle), {}};
    for (std::size_t k = 0; k < whole.size(); ++k) box.half_edges[k] = to_kernel(whole[k] * unit);
    return box;
  }
};

/// A unit vector across another one.
glm::dvec3 any_across(const glm::dvec3& v) {
  glm::dvec3 axis{0};
  axis[std::fabs(v.x) < 0.5 ? 0 : std::fabs(v.y) < 0.5 ? 1 : 2] = 1;
  return glm::normalize(glm::cross(v, axis));
}

/// Normals of the faces, as long as these are large.
EdgeVectors normals(const EdgeVectors& edges) {
  return {glm::cross(edges[1], edges[2]), glm::cross(edges[2], edges[0]), glm::cross(edges[0], edges[1])};
}

/// How thick a box is to be in units, half from face to face: more than what rounding moves its edges.
constexpr double kLeastRoom = 1.5;

bool is_thin(const EdgeVectors& edges) {
  const EdgeVectors across = normals(edges);
  const double volume = glm::dot(edges[0], across[0]);
  return std::ranges::any_of(
      across, [&](const glm::dvec3& n) { return volume * volume < kLeastRoom * kLeastRoom * glm::dot(n, n); });
}

/// Edges of which none is shorter than that across the longer ones. The box of two edges or fewer is flat and would
/// hold nothing beside it.
EdgeVectors thickened(const EdgeVectors& edges) {
  std::array<std::size_t, 3> by_length{0, 1, 2};
  std::ranges::sort(by_length, std::ranges::greater(), [&](std::size_t k) { return glm::dot(edges[k], edges[k]); });
  EdgeVectors thick = edges;
  glm::dvec3 &longest = thick[by_length[0]], &second = thick[by_length[1]], &shortest = thick[by_length[2]];
  const glm::dvec3 along = glm::normalize(longest);
  const glm::dvec3 beside = second - glm::dot(second, along) * along;
  const double width = glm::length(beside);
  glm::dvec3 across = width > 0 ? beside / width : any_across(along);
  if (width < kLeastRoom) second = kLeastRoom * across;
  across = glm::cross(along, across);
  if (std::fabs(glm::dot(shortest, across)) < kLeastRoom) shortest = kLeastRoom * across;
  return thick;
}

/// Makes an edge longer by a unit, or to `share` of its length if that is more.
void lengthen(glm::dvec3& edge, double share) { edge *= std::max(share, 1 + 1 / glm::length(edge)); }

/// How far a box reaches in another one of whole edges: along each of these, as a share of it. None if that one is flat.
std::optional<std::array<double, 3>> reach(const EdgeVectors& box, const glm::dvec3& offset, const EdgeVectors& whole) {
  const EdgeVectors across = normals(whole);
  const double volume = glm::dot(whole[0], across[0]);
  if (volume == 0) return std::nullopt;
  std::array<double, 3> reach;
  for (std::size_t k = 0; k < reach.size(); ++k) {
    const glm::dvec3& normal = across[k];
    double sum = std::fabs(glm::dot(normal, offset));
    for (const glm::dvec3& edge : box) sum += std::fabs(glm::dot(normal, edge));
    reach[k] = sum / std::fabs(volume);
  }
  return reach;
}

/// What is reached, at most, of whole edges that certainly hold a box. Whole numbers are at most 511, so `across` and the
/// volume are exact, and the first are at most 2^19. The numbers of the box in units are at most 2^9, and have three
/// roundings. Its offset is a few units in the last place of numbers of the outer box, which is as wide as some of these,
/// and so at most 2^11. A sum of twelve products of at most 2^30, of some ten roundings of 2^-53 each, is wrong by less than
/// 2^-15, and no volume but 0 is below 1. The numbers of the unpacked box have two roundings more, which move what is
/// reached by less than that.
constexpr double kHeld = 1 - 0x1p-10;

double rounded(double x) { return static_cast<int>(x < 0 ? x - 0.5 : x + 0.5); }

/// None if they do not fit.
std::optional<EdgeVectors> rounded(const EdgeVectors& edges) {
  EdgeVectors whole;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::fabs(edges[k][axis]) < kMostUnits + 0.5)) return std::nullopt;
      whole[k][axis] = rounded(edges[k][axis]);
    }
  }
  return whole;
}

/// Whole edges of a box that holds the given one; none if they do not fit.
std::optional<EdgeVectors> holding(const EdgeVectors& box, const glm::dvec3& offset) {
  EdgeVectors edges = is_thin(box) ? thickened(box) : box;
  for (glm::dvec3& edge : edges) lengthen(edge, 1);
  while (const auto whole = rounded(edges)) {  // each time they are longer
    const auto reached = reach(box, offset, *whole);
    if (!reached) return std::nullopt;
    bool is_held = true;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if ((*reached)[k] <= kHeld) continue;
      lengthen(edges[k], (*reached)[k] / kHeld);
      is_held = false;
    }
    if (is_held) return whole;
  }
  return std::nullopt;
}

std::uint32_t packed(const glm::dvec3& whole) {
  std::uint32_t word = 0;
  for (int axis = 0; axis < 3; ++axis) {
    word = word << kEdgeBits | static_cast<std::uint32_t>(static_cast<int>(whole[axis]) + kMostUnits + 1);
  }
  return word;
}

glm::dvec3 unpacked(std::uint32_t word) {
  glm::dvec3 whole;
  for (int axis = 2; axis >= 0; --axis, word >>= kEdgeBits) {
    whole[axis] = static_cast<int>(word & ((1U << kEdgeBits) - 1)) - (kMostUnits + 1);
  }
  return whole;
}

}  // namespace

PackedEdges::PackedEdges(const kernel::Obb& box, const kernel::Aabb& outer) {
  const EdgeGrid grid(outer);
  EdgeVectors edges;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto edge = grid.in_units(to_glm(box.half_edges[k]));
    if (!edge) return;
    edges[k] = *edge;
  }
  const auto offset = grid.in_units(to_glm(box.center) - grid.middle);
  if (!offset || edges == EdgeVectors{}) return;
  const auto whole = holding(edges, *offset);
  if (!whole || kernel::check(grid.box(*whole)) != kernel::Refusal::none) return;
  for (std::size_t k = 0; k < edges.size(); ++k) edges_[k] = packed((*whole)[k]);
}

kernel::Obb PackedEdges::box(const kernel::Aabb& outer) const {
  EdgeVectors whole;
  for (std::size_t k = 0; k < whole.size(); ++k) whole[k] = unpacked(edges_[k]);
  return EdgeGrid(outer).box(whole);
}

}  // namespace occlude::culler
