// SPDX-License-Identifier: MIT
#include "occlude/oracle/second.h"

#include "near_side.h"
#include "points.h"
#include "triangles.h"
#include "weights.h"

namespace occlude::oracle::second {
namespace {

constexpr int kCorners = 8;

/// Corner `index` of the box: bit k is set at the high end of the box's own coordinate k.
ExactPoint corner(const Box& box, int index) {
  const auto is_high = [&](int k) { return (index >> k & 1) != 0; };
  if (const Aabb* aabb = std::get_if<Aabb>(&box)) {
    const auto [x0, y0, z0] = aabb->min;
    const auto [x1, y1, z1] = aabb->max;
    return {is_high(0) ? x1 : x0, is_high(1) ? y1 : y0, is_high(2) ? z1 : z0};
  }
  const auto& [center, half_edges] = std::get<Obb>(box);
  ExactPoint x = exact(center);
  for (int k = 0; k < 3; ++k) {
    const ExactVector half_edge = from_origin(half_edges[static_cast<std::size_t>(k)]);
    x = is_high(k) ? x + half_edge : x - half_edge;
  }
  return x;
}

}  // namespace

Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  const Triangles triangles(view, occluder);
  const std::optional<NearSide> across = near_side(view, occluder, near, triangles);
  const auto is_shaded = [&](const ExactPoint& x) {
    return across ? triangles.are_in_line_with(x) && is_beyond(*across, x) : triangles.shade(x);
  };
  int within = 0;
  for (int i = 0; i < kCorners; ++i) within += is_shaded(corner(box, i)) ? 1 : 0;
  if (within == kCorners) return {"", Relation::inside};
  const bool is_partial = within > 0 || share_a_point(view, vertices_of(occluder), across, box);
  return {"", is_partial ? Relation::partial : Relation::outside};
}

}  // namespace occlude::oracle::second
