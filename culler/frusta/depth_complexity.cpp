// SPDX-License-Identifier: MIT
#include "frusta/depth_complexity.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <glm/geometric.hpp>

#include "frusta/candidate_order.h"
#include "model/bounds.h"
#include "occlude/kernel/overlap.h"

namespace occlude::culler {
namespace {

/// The number of occluders whose shadows are made at a viewpoint: the bits of a word.
constexpr std::size_t kShadows = 64;
/// At most this many occluders are found: more than any frame uses of one region.
constexpr std::size_t kMostTaken = 32;
/// A subtree that is seen under a smaller angle, in radians, is not descended into.
constexpr double kLeastAngle = 0.05;

using Mask = std::uint64_t;

/// The occluders that look largest and cast a shadow.
class Pool {
 public:
  Pool(const PotentialOccluders& occluders, const glm::dvec3& eye) : occluders_(occluders), eye_(eye) {}

  void fill(std::span<const std::uint32_t> listed) {
    std::vector<Candidate> candidates;
    for (const std::uint32_t i : listed) candidates.push_back({occluders_[i].area_angle(eye_), i});
    const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(std::min(candidates.size(), 4 * kShadows));
    std::partial_sort(candidates.begin(), end, candidates.end());
    for (auto candidate = candidates.begin(); candidate != end && frusta_.size() < kShadows; ++candidate) {
      if (!take(candidate->occluder) || named_.size() == frusta_.size()) continue;
      const bool is_listed = std::ranges::binary_search(listed, taken_.back());
      named_.push_back(is_listed ? taken_.back() : candidate->occluder);
    }
  }

  [[nodiscard]] std::span<const kernel::ShadowFrustum> frusta() const { return frusta_; }
  /// The listed occluder that frustum i counts for: its own, or a listed part of it.
  [[nodiscard]] std::uint32_t occluder(std::size_t i) const { return named_[i]; }

 private:
  /// Takes the largest occluder that i is a part of and that casts a shadow from here. Returns whether it is in the pool.
  bool take(std::uint32_t i) {
    const std::uint32_t container = occluders_.container(i);
    if (container != i && take(container)) return true;
    if (std::ranges::find(taken_, i) != taken_.end()) return true;
    if (std::ranges::find(refused_, i) != refused_.end() || frusta_.size() == kShadows) return false;
    const auto viewpoint = kernel::Viewpoint::eye(to_kernel(eye_));
    auto [frustum, refusal] = occluders_.shadow(i, viewpoint, kernel::Near::surface);
    if (!frustum) {
      refused_.push_back(i);
      return false;
    }
    taken_.push_back(i);
    frusta_.push_back(std::move(*frustum));
    return true;
  }

  const PotentialOccluders& occluders_;
  const glm::dvec3& eye_;
  std::vector<kernel::ShadowFrustum> frusta_;
  std::vector<std::uint32_t> taken_, named_, refused_;
};

/// How many polygons each of some occluders hides alone.
struct Hidden {
  Mask by;
  std::uint32_t polygons;
};

/// One descent of the tree with all shadows: it finds which subtree lies in which shadow.
class Descent {
 public:
  Descent(const Hierarchy& hierarchy, std::span<const kernel::ShadowFrustum> frusta, const glm::dvec3& eye)
      : nodes_(hierarchy.nodes()), frusta_(frusta), eye_(eye) {
    if (!frusta.empty()) visit(0, ~Mask{0} >> (kShadows - frusta.size()), 0);
  }

  [[nodiscard]] const std::vector<Hidden>& hidden() const { return hidden_; }

 private:
  /// `active` are the shadows to be tested, `by` those that hide the parent of the node.
  void visit(std::uint32_t index, Mask active, Mask by) {
    const HierarchyNode& node = nodes_[index];
    Mask undecided = 0;
    for (; active != 0; active &= active - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(active));
      const kernel::Relation relation =
          kernel::conservative_certified(frusta_[i], node.box, kernel::NearBoundary::open).relation;
      if (relation == kernel::Relation::inside) by |= Mask{1} << i;
      if (relation == kernel::Relation::partial) undecided |= Mask{1} << i;
    }
    if (undecided != 0 && !node.is_leaf() && looks_large(node.box)) {
      visit(index + 1, undecided, by);
      visit(node.right, undecided, by);
    } else if (by != 0) {
      hidden_.push_back({by, node.count});
    }
  }

  [[nodiscard]] bool looks_large(const kernel::Aabb& box) const {
    const glm::dvec3 low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z};
    return glm::distance(low, high) > kLeastAngle * glm::distance(low / 2.0 + high / 2.0, eye_);
  }

  std::span<const HierarchyNode> nodes_;
  std::span<const kernel::ShadowFrustum> frusta_;
  const glm::dvec3& eye_;
  std::vector<Hidden> hidden_;
};

}  // namespace

std::vector<HiddenBy> best_together(const Hierarchy& hierarchy, const PotentialOccluders& occluders,
                                    std::span<const std::uint32_t> listed, const glm::dvec3& eye) {
  Pool pool(occluders, eye);
  pool.fill(listed);
  std::vector<Hidden> left = Descent(hierarchy, pool.frusta(), eye).hidden();
  std::vector<HiddenBy> taken;
  while (taken.size() < kMostTaken) {
    std::array<std::uint32_t, kShadows> gain{};
    for (const auto& [by, polygons] : left) {
      for (Mask rest = by; rest != 0; rest &= rest - 1) gain[static_cast<std::size_t>(std::countr_zero(rest))] += polygons;
    }
    const auto best = std::ranges::max_element(gain);
    if (*best == 0) break;
    const auto i = static_cast<std::size_t>(best - gain.begin());
    taken.push_back({pool.occluder(i), *best});
    std::erase_if(left, [&](const Hidden& h) { return (h.by >> i & 1U) != 0; });
  }
  return taken;
}

}  // namespace occlude::culler
