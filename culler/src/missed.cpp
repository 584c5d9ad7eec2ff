// SPDX-License-Identifier: MIT
#include "occlude/culler/missed.h"

#include <algorithm>
#include <utility>

#include "bounds.h"
#include "occlude/culler/parallel.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occluder_choice.h"

namespace occlude::culler {
MissedReasons::MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame)
    : hierarchy_(culler.hierarchy()), occluders_(culler.occluders()), frame_(frame) {
  for (const Occluder& occluder : frame.occluders) chosen_.push_back({occluder.index, occluder.frustum});
  keep_others(culler, camera, options);
}

/// Of the region's list what may occlude from here and is not chosen.
void MissedReasons::keep_others(const Culler& culler, const Camera& camera, const CullOptions& options) {
  const PolygonSoup& soup = hierarchy_.soup();
  std::vector<kernel::Vec3> vertices;
  for (const std::uint32_t i : culler.grid().list(camera.eye).occluders) {
    if (std::ranges::find(chosen_, i, &Shadow::occluder) != chosen_.end()) continue;
    occluders_.vertices(soup, i, vertices);
    if (may_be_clipped(camera, vertices)) continue;
    auto [frustum, refusal] = occluders_.shadow(soup, i, camera.viewpoint(), options.near);
    if (frustum) others_.push_back({i, std::move(*frustum)});
  }
}

/// Of the shadows above the node those that meet it. Where one of the others has all of it, the rest of them are not asked.
MissedReasons::Near MissedReasons::narrowed(const Near& above, std::uint32_t node) const {
  const auto relation = [&](const Shadow& shadow) {
    return hierarchy_.ask(node, [&](const auto& box) {
      const auto found = kernel::conservative_certified(shadow.frustum, box, kernel::NearBoundary::open).relation;
      return found == kernel::Relation::inside && !frame_.margin.keeps(shadow.frustum, box) ? kernel::Relation::partial
                                                                                            : found;
    });
  };
  Near here;
  for (const Shadow* shadow : above.chosen) {
    if (relation(*shadow) != kernel::Relation::outside) here.chosen.push_back(shadow);
  }
  here.holder = above.holder;
  for (const Shadow* shadow : above.others) {
    const kernel::Relation found = relation(*shadow);
    if (found == kernel::Relation::inside) {
      here.holder = shadow;
      here.others.clear();
      break;
    }
    if (found == kernel::Relation::partial) here.others.push_back(shadow);
  }
  return here;
}

MissedReasons::Near MissedReasons::all() const {
  Near result;
  for (const Shadow& shadow : chosen_) result.chosen.push_back(&shadow);
  for (const Shadow& shadow : others_) result.others.push_back(&shadow);
  return result;
}

bool MissedReasons::hides(const Shadow& shadow, const kernel::Aabb& box) const {
  return kernel::conservative_certified(shadow.frustum, box, kernel::NearBoundary::open).relation ==
             kernel::Relation::inside &&
         frame_.margin.keeps(shadow.frustum, box);
}

bool MissedReasons::is_out_of_view(std::uint32_t p) const {
  return std::ranges::any_of(frame_.view, [&](const HalfSpace& h) {
    return std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
      const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
      return kernel::relation({to_kernel(h.normal), h.offset}, kernel::Aabb{corner, corner},
                              kernel::Arithmetic::certified) == kernel::Relation::outside;
    });
  });
}

/// A shadow is convex: it has a polygon when it has its corners. What an occluder is drawn as is drawn.
bool MissedReasons::hides(const Shadow& shadow, std::uint32_t p) const {
  return !std::ranges::binary_search(occluders_.parts(shadow.occluder), p) &&
         std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
           const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
           return hides(shadow, kernel::Aabb{corner, corner});
         });
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p, const Near& near) const {
  if (is_out_of_view(p)) return {Missed::out_of_view, Culled::kNone};
  const kernel::Aabb box = hierarchy_.soup().box(p);
  for (const Shadow* shadow : near.chosen) {
    if (hides(*shadow, p) && hides(*shadow, box)) return {Missed::coarse_node, shadow->occluder};
  }
  for (const Shadow* shadow : near.chosen) {
    if (hides(*shadow, p)) return {Missed::straddling_box, shadow->occluder};
  }
  const bool is_in_several = std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
    const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
    return std::ranges::any_of(near.chosen, [&](const Shadow* s) { return hides(*s, kernel::Aabb{corner, corner}); });
  });
  if (is_in_several) return {Missed::several, Culled::kNone};
  if (near.holder != nullptr && hides(*near.holder, p)) return {Missed::not_chosen, near.holder->occluder};
  for (const Shadow* shadow : near.others) {
    if (hides(*shadow, p)) return {Missed::not_chosen, shadow->occluder};
  }
  return {Missed::no_single_one, Culled::kNone};
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p) const {
  return answer(p, narrowed(all(), hierarchy_.leaf_of(p)));
}

MissedReasons::Counts MissedReasons::count(const std::vector<bool>& shows) const {
  std::vector<bool> missed = polygons_of(frame_.drawn, hierarchy_.soup().size());
  for (std::size_t p = 0; p < missed.size(); ++p) missed[p] = missed[p] && !shows[p];
  // Subtrees of a share of the model each, so that all processors have some.
  constexpr std::uint32_t kShares = 64;
  std::vector<Subtree> subtrees;
  descend({0, all()}, hierarchy_.nodes()[0].count / kShares, missed, [&](Subtree&& s) { subtrees.push_back(std::move(s)); });
  std::vector<Counts> counts(subtrees.size(), Counts{});
  parallel_for(subtrees.size(), [&](std::size_t i) {
    descend(subtrees[i], 0, missed, [&](const Subtree& leaf) { count_leaf(leaf, missed, counts[i]); });
  });
  Counts total{};
  for (const Counts& some : counts) {
    for (std::size_t r = 0; r < kMissedReasons; ++r) total[r] += some[r];
  }
  return total;
}

/// Descends, with the shadows that meet the nodes, to those of at most so many polygons and to leaves, but for subtrees
/// without a missed polygon.
template <class OnSubtree>
void MissedReasons::descend(const Subtree& above, std::uint32_t polygons, const std::vector<bool>& missed,
                            const OnSubtree& on_subtree) const {
  const HierarchyNode& n = hierarchy_.nodes()[above.node];
  const auto begin = missed.begin() + std::ptrdiff_t{n.first}, end = begin + std::ptrdiff_t{n.count};
  if (std::find(begin, end, true) == end) return;
  Subtree here{above.node, narrowed(above.near, above.node)};
  if (n.is_leaf() || n.count <= polygons) return on_subtree(std::move(here));
  here.node = above.node + 1;
  descend(here, polygons, missed, on_subtree);
  here.node = n.right;
  descend(here, polygons, missed, on_subtree);
}

void MissedReasons::count_leaf(const Subtree& leaf, const std::vector<bool>& missed, Counts& counts) const {
  const HierarchyNode& n = hierarchy_.nodes()[leaf.node];
  for (std::uint32_t p = n.first; p < n.first + n.count; ++p) {
    if (missed[p]) ++counts[static_cast<std::size_t>(answer(p, leaf.near).reason)];
  }
}

}  // namespace occlude::culler
