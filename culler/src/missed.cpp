// SPDX-License-Identifier: MIT
#include "occlude/culler/missed.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bounds.h"
#include "occlude/culler/parallel.h"
#include "occlude/kernel/overlap.h"
#include "occluder_choice.h"

namespace occlude::culler {
namespace {

/// The leaf that has polygon p.
std::uint32_t leaf_of(const Hierarchy& hierarchy, std::uint32_t p) {
  std::uint32_t node = 0;
  while (!hierarchy.nodes()[node].is_leaf()) {
    const std::uint32_t right = hierarchy.nodes()[node].right;
    node = p < hierarchy.nodes()[right].first ? node + 1 : right;
  }
  return node;
}

std::vector<bool> drawn_polygons(const Hierarchy& hierarchy, const std::vector<PolygonRange>& drawn) {
  std::vector<bool> result(hierarchy.soup().size());
  for (const auto [first, count] : drawn) std::fill_n(result.begin() + std::ptrdiff_t{first}, count, true);
  return result;
}

std::vector<kernel::Vec3> vertices_of(const OccluderGeometry& geometry) {
  if (const auto* polygon = std::get_if<std::vector<kernel::Vec3>>(&geometry)) return *polygon;
  return std::get<kernel::Polytope>(geometry).vertices;
}

}  // namespace

MissedReasons::MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame)
    : hierarchy_(culler.hierarchy()), frame_(frame) {
  for (const Occluder& occluder : frame.occluders) chosen_.push_back({occluder.index, occluder.frustum});
  keep_others(culler, camera, options);
}

/// Of the region's list what may occlude from here and is not chosen.
void MissedReasons::keep_others(const Culler& culler, const Camera& camera, const CullOptions& options) {
  const PolygonSoup& soup = hierarchy_.soup();
  for (const std::uint32_t i : culler.grid().list(camera.eye).occluders) {
    if (std::ranges::find(chosen_, i, &Shadow::occluder) != chosen_.end()) continue;
    if (may_be_clipped(camera, vertices_of(culler.occluders().geometry(soup, i)))) continue;
    auto [frustum, refusal] = culler.occluders().shadow(soup, i, camera.viewpoint(), options.near);
    if (frustum) others_.push_back({i, std::move(*frustum)});
  }
}

MissedReasons::Near MissedReasons::near(std::uint32_t node) const {
  const auto meeting = [&](const std::vector<Shadow>& shadows) {
    std::vector<const Shadow*> result;
    for (const Shadow& shadow : shadows) {
      const auto relation = hierarchy_.ask(node, [&](const auto& box) {
        return kernel::conservative_certified(shadow.frustum, box, kernel::NearBoundary::open).relation;
      });
      if (relation != kernel::Relation::outside) result.push_back(&shadow);
    }
    return result;
  };
  return {meeting(chosen_), meeting(others_)};
}

bool MissedReasons::hides(const Shadow& shadow, const kernel::Aabb& box) const {
  return kernel::conservative_certified(shadow.frustum, box, kernel::NearBoundary::open).relation ==
             kernel::Relation::inside &&
         frame_.margin.keeps(shadow.frustum, box);
}

/// A shadow is convex: it has a polygon when it has its corners.
bool MissedReasons::hides(const Shadow& shadow, std::uint32_t p) const {
  return std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
    const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
    return hides(shadow, kernel::Aabb{corner, corner});
  });
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p, const Near& near) const {
  const kernel::Aabb box = polygon_box(hierarchy_.soup(), p);
  for (const Shadow* shadow : near.chosen) {
    if (hides(*shadow, box)) return {Missed::coarse_node, shadow->occluder};
  }
  for (const Shadow* shadow : near.chosen) {
    if (hides(*shadow, p)) return {Missed::straddling_box, shadow->occluder};
  }
  const bool is_in_several = std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
    const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
    return std::ranges::any_of(near.chosen, [&](const Shadow* s) { return hides(*s, kernel::Aabb{corner, corner}); });
  });
  if (is_in_several) return {Missed::several, Culled::kNone};
  for (const Shadow* shadow : near.others) {
    if (hides(*shadow, p)) return {Missed::not_chosen, shadow->occluder};
  }
  return {Missed::no_single_one, Culled::kNone};
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p) const { return answer(p, near(leaf_of(hierarchy_, p))); }

std::array<std::size_t, kMissedReasons> MissedReasons::count(const std::vector<bool>& shows) const {
  const std::vector<bool> drawn = drawn_polygons(hierarchy_, frame_.drawn);
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t n = 0; n < hierarchy_.nodes().size(); ++n) {
    if (hierarchy_.nodes()[n].is_leaf()) leaves.push_back(n);
  }
  std::vector<std::array<std::size_t, kMissedReasons>> of_leaf(leaves.size());
  parallel_for(leaves.size(), [&](std::size_t i) {
    const HierarchyNode& leaf = hierarchy_.nodes()[leaves[i]];
    std::optional<Near> shadows;  // few leaves have missed polygons
    for (std::uint32_t p = leaf.first; p < leaf.first + leaf.count; ++p) {
      if (!drawn[p] || shows[p]) continue;
      if (!shadows) shadows = near(leaves[i]);
      ++of_leaf[i][static_cast<std::size_t>(answer(p, *shadows).reason)];
    }
  });
  std::array<std::size_t, kMissedReasons> total{};
  for (const auto& counts : of_leaf) {
    for (std::size_t r = 0; r < kMissedReasons; ++r) total[r] += counts[r];
  }
  return total;
}

}  // namespace occlude::culler
