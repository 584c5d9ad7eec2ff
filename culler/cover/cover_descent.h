// SPDX-License-Identifier: MIT
// One descent of a tree, front to back, that culls by the view and by what a cover buffer has closed.
//
// Leaves that are not culled go to `see`, one at a time. A few leaves together may then close pixels for what lies behind
// them. Nothing hides itself, because a box is never strictly beyond what it holds.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "camera/view_planes.h"
#include "cover/cover_buffer.h"
#include "cover/projected_boxes.h"
#include "cover/seen_node.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A tree as a descent sees it: its boxes are where they are.
struct StandingBoxes {
  std::span<const HierarchyNode> nodes;

  [[nodiscard]] const kernel::Aabb& box(std::uint32_t node) const { return nodes[node].box; }
  template <class Question>
  decltype(auto) ask(std::uint32_t node, const Question& question) const {
    return question(box(node));
  }
};

/// What a descent looks for.
enum class Sought {
  seen,          ///< all that is not culled
  worth_closing  ///< what is seen through more than a slit. Where nothing is, the descent does not enter
};

/// see(SeenNode) is called for each leaf that is sought, cull(Culled) for each node that is culled. join() is called after
/// each subtree of few items and may add to the buffer what was seen.
template <class Tree, class See, class Cull, class Join>
class CoverDescent {
 public:
  /// A subtree has few items if it has at most this many, or is a leaf. With a smaller limit, more of what
  /// was drawn before is drawn again; with a larger one, what was seen closes pixels later. With 512, large models take up
  /// to 3 % less, but a small town 9 % more instructions.
  static constexpr std::uint32_t kFew = 256;

  /// A leaf that is seen through fewer pixels is not worth drawing: it shows through slits that nothing closes. With a
  /// limit of 4, frames of models would draw 50 % more triangles and cull only a few thousandths more. An occluder of a
  /// scene costs more, because it is found in two trees: with 8, a cull takes 8 % longer and draws 1 % fewer objects.
  static constexpr int kWorthOfLeaf = 8, kWorthOfOccluder = 12;
  /// The more a frame has drawn, the less another leaf is worth: the limit is a pixel for each 512 triangles, as far as this
  /// is between the limit above and 24. Frames of up to 4,096 triangles stay as they are. The castle and Sponza, of 18,000
  /// to 28,000, draw half to two thirds of that, take 0.7 to 0.8 of the time, and cull less: of what is hidden 0.2 to 0.8 %
  /// in the castle, 1 to 5 % in Sponza.
  static constexpr std::size_t kTrianglesOfPixel = 512, kMostWorth = 24;

  CoverDescent(const Tree& tree, const ViewPlanes& view, const CoverBuffer& buffer, Sought sought, CullStats& stats,
               const See& see, const Cull& cull, const Join& join)
      : tree_(tree), view_(view), buffer_(buffer), sought_(sought), stats_(stats), see_(see), cull_(cull), join_(join) {}

  /// Descends from the root. `straddled_planes` has a bit for each plane that may cross it.
  void run(std::uint32_t straddled_planes) {
    if (tree_.nodes.empty()) return;
    Visit root{0, straddled_planes};
    if (!is_in_view(root)) return;
    if (!is_few(root.node)) return visit_below(root);
    visit_part(root);
    join_();
  }

 private:
  struct Visit {
    std::uint32_t node;
    std::uint32_t straddled_planes;  ///< a bit for each plane that may cross the node
  };
  /// Nodes that are tested together.
  struct Batch {
    std::array<Visit, ProjectedBoxes::kMost> visits;
    ProjectedBoxes boxes;
    std::size_t groups = 0;  ///< how many had been drawn when it was tested
  };
  /// A subtree of few items: the nodes that the descent enters there, and the next ones to be tested.
  struct Part {
    std::array<Visit, kFew> entered;  ///< which has room: a subtree has fewer nodes with children than items
    std::size_t size = 0;             ///< of `entered`
    Batch batch;
  };

  [[nodiscard]] bool is_few(std::uint32_t node) const {
    return tree_.nodes[node].is_leaf() || tree_.nodes[node].count <= kFew;
  }

  /// Visits what is below a node: three levels of the tree at once, nearest first. A subtree of few items begins a level of
  /// its own. REQUIRES: the node has more items.
  void visit_below(const Visit& visit) {
    Batch batch;
    gather(visit, kLevels, batch, nullptr);
    const kernel::BoxBits hidden = test(batch);
    std::array<std::uint8_t, ProjectedBoxes::kMost> order{};
    for (std::uint8_t i = 0; i < batch.boxes.size; ++i) {
      std::size_t k = i;
      for (; k > 0 && batch.boxes.distance[order[k - 1]] > batch.boxes.distance[i]; --k) order[k] = order[k - 1];
      order[k] = i;
    }
    for (const std::uint8_t i : std::span(order).first(batch.boxes.size)) {
      const Visit& next = batch.visits[i];
      const bool is_entered = decide(batch, i, hidden), is_part = is_few(next.node);
      if (is_entered && !is_part) visit_below(next);
      if (is_entered && is_part) visit_part(next);
      if (is_part) join_();
    }
  }

  /// Visits a subtree of few items, or the leaf itself. What is seen there closes pixels when the descent leaves it, so the
  /// order does not matter, and only the last batch need not be full.
  void visit_part(const Visit& root) {
    Part part;
    part.entered[part.size++] = root;
    for (std::size_t next = 0; next < part.size;) {
      gather(part.entered[next++], kLevels, part.batch, &part);
      if (next == part.size && part.batch.boxes.size > 0) settle(part);
    }
  }
  /// Decides about the batch, and empties it.
  void settle(Part& part) {
    const kernel::BoxBits hidden = test(part.batch);
    for (std::size_t i = 0; i < part.batch.boxes.size; ++i) {
      if (decide(part.batch, i, hidden)) part.entered[part.size++] = part.batch.visits[i];
    }
    part.batch.boxes.size = 0;
  }

  /// Adds the nodes in view so many levels below, and leaves above them, to a batch. In a part, settles it when it is full;
  /// elsewhere, goes into no subtree of few items.
  void gather(const Visit& visit, int levels, Batch& batch, Part* part) {
    const HierarchyNode& node = tree_.nodes[visit.node];
    if (node.is_leaf() || levels == 0) {
      batch.visits[batch.boxes.size] = visit;
      batch.boxes.add(buffer_.box_picture(), tree_.box(visit.node));
      if (part != nullptr && batch.boxes.size == ProjectedBoxes::kMost) settle(*part);
      return;
    }
    hwy::Prefetch(&tree_.nodes[node.right]);  // which is far from here
    for (const std::uint32_t below : {visit.node + 1, node.right}) {
      Visit next{below, visit.straddled_planes};
      if (is_in_view(next)) gather(next, part == nullptr && is_few(below) ? 0 : levels - 1, batch, part);
    }
  }

  /// Those nodes of the batch that are hidden.
  [[nodiscard]] kernel::BoxBits test(Batch& batch) const {
    batch.boxes.project(buffer_.box_picture());
    batch.groups = stats_.cover_groups;
    return buffer_.hidden(batch.boxes, batch.boxes.all());
  }

  /// Whether the node is in view. Culls it if not.
  bool is_in_view(Visit& visit) {
    ++stats_.nodes_visited;
    for (std::uint32_t left = visit.straddled_planes; left != 0; left &= left - 1) {
      const auto plane = static_cast<std::uint32_t>(std::countr_zero(left));
      ++stats_.view_tests;
      const kernel::Relation relation = tree_.ask(
          visit.node, [&](const auto& box) { return kernel::relation(view_.planes[plane], box, view_.arithmetic); });
      if (relation == kernel::Relation::outside) {
        cull_({visit.node, Culled::By::view, plane});
        return false;
      }
      if (relation == kernel::Relation::inside) visit.straddled_planes &= ~(std::uint32_t{1} << plane);
    }
    return true;
  }

  /// Decides about a node of a batch, of which these were hidden when they were tested; what is hidden stays so. Returns
  /// whether to go below it.
  bool decide(const Batch& batch, std::size_t i, kernel::BoxBits hidden) {
    const Visit& visit = batch.visits[i];
    const bool is_leaf = tree_.nodes[visit.node].is_leaf(), is_closing = sought_ == Sought::worth_closing;
    ++stats_.cover_tests;
    if ((hidden >> i & 1U) != 0) return cull(visit);
    const bool is_up_to_date = batch.groups == stats_.cover_groups;  // it is still not hidden: nothing was drawn since
    if (!is_leaf && !is_closing && is_up_to_date) return true;
    const CoverBuffer::Footprint footprint = buffer_.footprint(batch.boxes, i);
    const int worth = worth_closing();
    // How many pixels are open does not matter where there are fewer than are worth drawing, and it is not hidden.
    const bool is_too_small = is_up_to_date && footprint.size() < worth;
    const int open = is_too_small ? 1 : buffer_.open(footprint, is_leaf || is_closing ? worth : 1);
    if (open == 0 && footprint.is_in_picture) return cull(visit);
    if (is_closing && open < worth) return false;
    if (is_leaf) see_(SeenNode{visit.node, visit.straddled_planes, footprint, open >= worth});
    return !is_leaf;
  }

  /// Culls a hidden node. Returns whether to go below it.
  bool cull(const Visit& visit) {
    cull_({visit.node, Culled::By::cover});
    return false;
  }

  /// Through how many pixels a leaf must be seen to be worth drawing.
  [[nodiscard]] int worth_closing() const {
    const int least = sought_ == Sought::worth_closing ? kWorthOfOccluder : kWorthOfLeaf;
    return std::max(least, static_cast<int>(std::min(stats_.cover_triangles / kTrianglesOfPixel, kMostWorth)));
  }

  static constexpr int kLevels = 3;
  static_assert(1U << kLevels == ProjectedBoxes::kMost);

  const Tree& tree_;
  const ViewPlanes& view_;
  const CoverBuffer& buffer_;
  Sought sought_;
  CullStats& stats_;
  const See& see_;
  const Cull& cull_;
  const Join& join_;
};

}  // namespace occlude::culler
