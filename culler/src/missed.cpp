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

namespace {

/// Of the list what looks largest from the eye, in the order of the list.
std::vector<std::uint32_t> largest_of(std::span<const std::uint32_t> list, const PotentialOccluders& occluders,
                                      const glm::dvec3& eye) {
  std::vector<std::uint32_t> kept(list.begin(), list.end());
  if (kept.size() <= MissedReasons::kMostListed) return kept;
  const auto end = kept.begin() + std::ptrdiff_t{MissedReasons::kMostListed};
  std::ranges::nth_element(kept, end, [&](std::uint32_t a, std::uint32_t b) {
    const double of_a = occluders[a].area_angle(eye), of_b = occluders[b].area_angle(eye);
    return of_a != of_b ? of_a > of_b : a < b;
  });
  kept.erase(end, kept.end());
  std::ranges::sort(kept);
  return kept;
}

}  // namespace

/// Of the region's list what may occlude from here and is not chosen.
void MissedReasons::keep_others(const Culler& culler, const Camera& camera, const CullOptions& options) {
  const PolygonSoup& soup = hierarchy_.soup();
  const double reach = depth(hierarchy_.nodes()[0].box, camera.eye);
  std::vector<kernel::Vec3> vertices;
  for (const std::uint32_t i : largest_of(culler.grid().list(camera.eye).occluders, occluders_, camera.eye)) {
    if (std::ranges::find(chosen_, i, &Shadow::occluder) != chosen_.end()) continue;
    occluders_.vertices(soup, i, vertices);
    if (may_be_clipped(camera, reach, vertices)) continue;
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

MissedReasons::Counts& MissedReasons::Counts::operator+=(const Counts& other) {
  missed += other.missed;
  for (std::size_t r = 0; r < kMissedReasons; ++r) reasons[r] += other.reasons[r];
  return *this;
}

/// A descent of a part of the tree, which ends when it has looked at so many shadows.
class MissedReasons::Asking {
 public:
  Asking(const MissedReasons& reasons, const std::vector<bool>& missed, const Checkpoint& checkpoint, std::size_t looks)
      : reasons_(reasons), missed_(missed), checkpoint_(checkpoint), looks_left_(looks) {}

  /// Descends, with the shadows that meet the nodes, to those of at most so many polygons and to leaves, but for subtrees
  /// without a missed polygon.
  template <class OnSubtree>
  void descend(const Subtree& above, std::uint32_t polygons, const OnSubtree& on_subtree) {
    const HierarchyNode& n = reasons_.hierarchy_.nodes()[above.node];
    if (missed_in(n) == 0 || !looks_at(above.near)) return;
    Subtree here{above.node, reasons_.narrowed(above.near, above.node)};
    if (n.is_leaf() || n.count <= polygons) return on_subtree(std::move(here));
    here.node = above.node + 1;
    descend(here, polygons, on_subtree);
    here.node = n.right;
    descend(here, polygons, on_subtree);
  }

  void count_leaf(const Subtree& leaf, Counts& counts) {
    const HierarchyNode& n = reasons_.hierarchy_.nodes()[leaf.node];
    for (std::uint32_t p = n.first; p < n.first + n.count; ++p) {
      if (missed_[p] && looks_at(leaf.near))
        ++counts.reasons[static_cast<std::size_t>(reasons_.answer(p, leaf.near).reason)];
    }
  }

  [[nodiscard]] std::size_t missed_in(const HierarchyNode& n) const {
    const auto begin = missed_.begin() + std::ptrdiff_t{n.first};
    return static_cast<std::size_t>(std::count(begin, begin + std::ptrdiff_t{n.count}, true));
  }

 private:
  bool looks_at(const Near& near) {
    checkpoint_();
    const std::size_t shadows = near.chosen.size() + near.others.size();
    if (shadows > looks_left_) return false;
    looks_left_ -= shadows;
    return true;
  }

  const MissedReasons& reasons_;
  const std::vector<bool>& missed_;
  const Checkpoint& checkpoint_;
  std::size_t looks_left_;
};

MissedReasons::Counts MissedReasons::count(const std::vector<bool>& shows, const Checkpoint& checkpoint,
                                           std::size_t looks) const {
  std::vector<bool> missed = polygons_of(frame_.drawn, hierarchy_.soup().size());
  for (std::size_t p = 0; p < missed.size(); ++p) missed[p] = missed[p] && !shows[p];
  // Subtrees of a share of the model each, so that all processors have some.
  constexpr std::uint32_t kShares = 64;
  const HierarchyNode& root = hierarchy_.nodes()[0];
  std::vector<Subtree> subtrees;
  Asking asking(*this, missed, checkpoint, looks);
  asking.descend({0, all()}, root.count / kShares, [&](Subtree&& s) { subtrees.push_back(std::move(s)); });
  Counts total{.missed = asking.missed_in(root)};
  std::vector<Counts> counts(subtrees.size());
  parallel_for(subtrees.size(), [&](std::size_t i) {
    // Each its share of the looks, by what is missed in it.
    const double share =
        static_cast<double>(asking.missed_in(hierarchy_.nodes()[subtrees[i].node])) / static_cast<double>(total.missed);
    Asking part(*this, missed, checkpoint, static_cast<std::size_t>(share * static_cast<double>(looks)));
    part.descend(subtrees[i], 0, [&](const Subtree& leaf) { part.count_leaf(leaf, counts[i]); });
  });
  for (const Counts& some : counts) total += some;
  return total;
}

}  // namespace occlude::culler
