// SPDX-License-Identifier: MIT
// What is seen of the occluders of a scene closes pixels, from front to back over all of them.
//
// A mesh is not descended to its end before the next one: of all subtrees, whatever trees they are of, the nearest goes
// next. So the order does not depend on how a world is cut into meshes, nor on the groups that occluders are in.
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/each_bit.h"
#include "camera/view_planes.h"
#include "cover/cover_descent.h"
#include "cover/cover_painter.h"
#include "cover/hiding_meshes.h"
#include "cover/idle_set.h"
#include "cover/opening.h"
#include "cover/placed.h"
#include "cover/prepared_mesh.h"
#include "cover/worth_drawing.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/box_block.h"
#include "scene/scene_occluders.h"

namespace occlude::culler {

/// What a view keeps for the descent, so that only its first frame allocates.
struct OccluderMemory {
  /// What a node is of: the tree of all groups, that of one group, or that of a mesh where it stands.
  enum class Level : std::uint8_t { groups, group, mesh };
  /// A node that waits for its turn.
  struct Node {
    const TreeBlock* block;
    std::uint32_t i;                 ///< in the block
    std::uint32_t straddled_planes;  ///< a bit for each plane that may cross it
    std::uint32_t of;                ///< the group or the source
    Level level;
    NodeFootprint at;
  };
  /// The turn of a node. Nodes above occluders come before those of occluders that are as near, and these in the order of
  /// their slots. So occluders have the same order in whatever groups they are.
  struct Turn {
    float distance;
    std::uint32_t rank;  ///< 1 more than the slot of the occluder; 0 above occluders
    std::uint32_t node;  ///< its index

    friend auto operator<=>(const Turn&, const Turn&) = default;
  };
  /// An occluder whose polygons are looked at.
  struct Source {
    const SceneOccluders::Standing* occluder;
    CoverSource polygons;
    bool is_drawn = false;
    bool has_hidden = false;  ///< something; found by find_idle()
  };

  std::vector<Node> nodes;
  std::vector<Turn> turns;  ///< a heap, the next one first
  std::vector<Turn> small;  ///< those that wait until the others have had theirs, in no order
  std::vector<Source> sources;
  std::vector<std::uint32_t> groups;  ///< of each group that was drawn, the index of its source
  IdleSet idle;                       ///< slots of occluders
  std::uint64_t idle_edition = 0;     ///< those that have changed since this edition are not idle
  std::vector<std::uint32_t> taken;   ///< of those, the ones that the frame took as idle

  /// After a frame in which nothing was idle: idle are the occluders whose polygons it looked at, and which hid nothing.
  void find_idle(const HidingMeshes& hiding, std::vector<OccluderId>& ids) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (hiding.has_hidden(static_cast<std::uint32_t>(g + 1))) sources[groups[g]].has_hidden = true;
    }
    ids.clear();
    ids.reserve(sources.capacity());
    for (const Source& source : sources) {
      if (source.has_hidden) continue;
      idle.set(source.occluder->id.slot());
      ids.push_back(source.occluder->id);
    }
    std::ranges::sort(ids, {}, &OccluderId::slot);
  }
};

/// The boxes of a block where they are.
struct StandingBoxes {
  const kernel::BoxBlock& operator()(const TreeBlock& block) const { return block.boxes; }
};
/// The boxes of a mesh's block where the mesh stands. They need only be about right: what is not drawn into the coarse
/// picture hides nothing.
struct PlacedBoxes {
  const Placement& placement;

  kernel::BoxBlock operator()(const TreeBlock& block) const { return nearly_placed(placement, block.boxes); }
};

/// takes_part(standing) says whether an occluder may hide in the frame. joined(painter, standing) is called after each group
/// that is drawn.
template <class TakesPart, class Joined>
class OccluderDescent {
  using Level = OccluderMemory::Level;
  using Node = OccluderMemory::Node;
  using Source = OccluderMemory::Source;
  using Standing = SceneOccluders::Standing;

 public:
  OccluderDescent(const SceneOccluders& occluders, const SceneOptions& options, const ViewPlanes& view,
                  const CoverBuffer& buffer, CoverPainter& painter, OccluderMemory& memory, SceneStats& stats,
                  const TakesPart& takes_part, const Joined& joined)
      : occluders_(occluders),
        boxes_(occluders.boxes()),
        options_(options),
        view_(view),
        buffer_(buffer),
        painter_(painter),
        memory_(memory),
        stats_(stats),
        takes_part_(takes_part),
        joined_(joined) {
    reserve();
  }

  void run() {
    if (!boxes_.groups().empty()) open({Level::groups, 0, 0}, boxes_.groups().tree(), 0, view_.all());
    visit_all();
    if (!memory_.small.empty()) {
      // Nothing larger is left that would need the budget.
      std::swap(memory_.turns, memory_.small);
      std::ranges::make_heap(memory_.turns, std::greater());
      worth_ = 0;
      visit_all();
    }
    painter_.finish();
  }

 private:
  /// What the nodes of a block are of.
  struct Above {
    Level level;
    std::uint32_t of, rank;
  };

  /// The nodes of any of the trees. Nothing is to be done about those that are culled.
  template <class BoxesOf>
  class Nodes : public StandingNodes {
   public:
    Nodes(const OccluderDescent& descent, const BoxesOf& boxes_of) : descent_(descent), boxes_of_(boxes_of) {}

    decltype(auto) boxes(const TreeBlock& block) const { return boxes_of_(block); }
    [[nodiscard]] kernel::BlockRelations relations(const TreeBlock&, const kernel::BoxBlock& boxes,
                                                   kernel::BoxBytes asked) const {
      return kernel::relations(descent_.view_.planes, boxes, asked);
    }
    static void cull(const TreeBlock&, std::uint32_t, const Culled&) {}

   private:
    const OccluderDescent& descent_;
    BoxesOf boxes_of_;
  };

  /// Those of a group, of which only occluders in a layer of the frame take part.
  class GroupNodes : public Nodes<StandingBoxes> {
   public:
    GroupNodes(const OccluderDescent& descent, const StandingBoxes& boxes_of, const OccluderGroup& group)
        : Nodes<StandingBoxes>(descent, boxes_of), group_(group), mask_(descent.options_.mask) {}

    [[nodiscard]] kernel::BoxBits asked(const TreeBlock& block) const {
      return block.divided != 0 ? block.used : group_.kinds(block.begin[0], mask_).in_layers;
    }

   private:
    const OccluderGroup& group_;
    std::uint32_t mask_;
  };

  /// Those of a subtree of few polygons, of which each leaf is drawn that is seen through more than a slit.
  template <class BoxesOf>
  class ClosingNodes : public Nodes<BoxesOf> {
   public:
    ClosingNodes(OccluderDescent& descent, const BoxesOf& boxes_of, Source& source)
        : Nodes<BoxesOf>(descent, boxes_of), descent_(descent), source_(source) {}

    template <class Boxes>
    bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
      const int worth = descent_.least_worth();
      const Opening opening(descent_.buffer_, tested, i, descent_.stats_.work.cover_groups, worth);
      if (opening.open < worth) return false;
      if (!tested.block.is_leaf(i)) return true;
      descent_.painter_.enqueue(tested.block.items(i), opening.footprint.most);
      return false;
    }
    bool spend(std::size_t work) { return descent_.painter_.budget().spend(work); }
    /// What is not drawn hides nothing.
    static void leave(const TreeBlock&, std::uint32_t) {}
    void join() { descent_.join(source_); }

   private:
    OccluderDescent& descent_;
    Source& source_;
  };

  void reserve() {
    memory_.nodes.clear();
    memory_.turns.clear();
    memory_.small.clear();
    memory_.sources.clear();
    memory_.groups.clear();
    // In trees of eight, fewer nodes are above the occluders than there are of these, and at most four above a small group.
    const std::size_t nodes = 2 * boxes_.seen_size() + 4 * boxes_.groups().size() + occluders_.meshes().nodes;
    memory_.nodes.reserve(std::bit_ceil(std::min(nodes, kMostReserved)));
    memory_.turns.reserve(std::bit_ceil(std::min(nodes, kMostReserved)));
    if (worth_ > 0) memory_.small.reserve(memory_.turns.capacity());
    const std::size_t occluders = std::bit_ceil(std::min(boxes_.seen_size(), kMostReserved));
    memory_.sources.reserve(occluders);
    memory_.taken.reserve(occluders);
    memory_.groups.reserve(std::bit_ceil(std::min(nodes, kMostReserved)));
    painter_.reserve(std::min(occluders_.meshes().triangles, kMostTrianglesReserved));
  }

  /// Memory is reserved for no more nodes, occluders and triangles of these, which is 30 MB of addresses. Frames of the
  /// models tried, whole or in tiles, have 3,000 nodes and a million triangles at most; those that look at more allocate.
  static constexpr std::size_t kMostReserved = std::size_t{1} << 16U, kMostTrianglesReserved = std::size_t{1} << 22U;

  /// Through how many pixels a node must be seen to be worth drawing, now and ever.
  [[nodiscard]] int worth() const { return std::max(worth_, least_worth()); }
  [[nodiscard]] int least_worth() const { return worth_closing(kWorthOfOccluder, stats_.work.cover_triangles); }

  void visit_all() {
    while (!memory_.turns.empty() && !painter_.budget().is_spent()) visit(next());
  }

  /// Tests a block. The nodes wait that are left, unless they are seen through a slit at most.
  void open(const Above& above, const BlockTree& tree, std::uint32_t block, std::uint32_t straddled_planes) {
    if (!painter_.budget().spend(kernel::count(tree[block].used))) return;
    if (above.level == Level::group) {
      GroupNodes nodes(*this, StandingBoxes{}, boxes_.group(above.of));
      return wait(above, descent(tree, nodes).test(tree[block], straddled_planes));
    }
    const Standing* const occluder = above.level == Level::mesh ? memory_.sources[above.of].occluder : nullptr;
    if (occluder == nullptr || occluder->is_identity) {
      Nodes<StandingBoxes> nodes(*this, StandingBoxes{});
      wait(above, descent(tree, nodes).test(tree[block], straddled_planes));
    } else {
      Nodes<PlacedBoxes> nodes(*this, PlacedBoxes{occluder->placement});
      wait(above, descent(tree, nodes).test(tree[block], straddled_planes));
    }
  }
  template <class AnyNodes>
  CoverDescent<AnyNodes> descent(const BlockTree& tree, AnyNodes& nodes) {
    return {tree, buffer_, stats_.work, nodes};
  }

  template <class Boxes>
  void wait(const Above& above, const TestedBlock<Boxes>& tested) {
    for_each_bit(tested.left, [&](std::uint32_t i) {
      const NodeFootprint at(buffer_, tested, i);
      if (at.own.size() < least_worth()) return;
      const bool is_occluder = above.level == Level::group && tested.block.is_leaf(i);
      const std::uint32_t rank = is_occluder ? rank_of(boxes_.group(above.of).id(tested.block.begin[i])) : above.rank;
      put_off({tested.seen.distance[i], rank, static_cast<std::uint32_t>(memory_.nodes.size())}, at.own.size());
      memory_.nodes.push_back({&tested.block, i, tested.straddled_planes[i], above.of, above.level, at});
    });
  }
  /// What is seen through few pixels waits for what is seen through more, if there is a budget.
  void put_off(const OccluderMemory::Turn& turn, int pixels) {
    if (pixels < worth()) {
      memory_.small.push_back(turn);
    } else {
      memory_.turns.push_back(turn);
      std::ranges::push_heap(memory_.turns, std::greater());
    }
  }
  static std::uint32_t rank_of(OccluderId id) { return id.slot() + 1; }

  /// Takes the nearest node's turn.
  [[nodiscard]] OccluderMemory::Turn next() {
    std::ranges::pop_heap(memory_.turns, std::greater());
    const OccluderMemory::Turn turn = memory_.turns.back();
    memory_.turns.pop_back();
    if (!memory_.turns.empty()) prefetch(memory_.nodes[memory_.turns.front().node]);
    return turn;
  }
  /// What comes after the next node most often.
  void prefetch(const Node& node) const {
    if (node.level == Level::mesh) tree_of(*memory_.sources[node.of].occluder).prefetch(node.block->below[node.i]);
  }

  void visit(const OccluderMemory::Turn& turn) {
    const Node node = memory_.nodes[turn.node];
    const int enough = worth();
    const Opening opening(buffer_, node.at, stats_.work.cover_groups, enough);
    if (opening.open < enough) {
      if (worth_ > 0 && opening.open > 0) memory_.small.push_back(turn);
      return;
    }
    switch (node.level) {
      case Level::groups:
        return visit_of_groups(node);
      case Level::group:
        return visit_of_group(node);
      case Level::mesh:
        return visit_of_mesh(node, opening.footprint.most);
    }
  }

  void visit_of_groups(const Node& node) {
    const TreeBlock& block = *node.block;
    if (!block.is_leaf(node.i)) {
      return open({Level::groups, 0, 0}, boxes_.groups().tree(), block.below[node.i], node.straddled_planes);
    }
    const std::uint32_t group = block.begin[node.i];
    if (options_.is_to_be_held && boxes_.moves(group)) return;
    open({Level::group, group, 0}, boxes_.group(group).tree().tree(), 0, node.straddled_planes);
  }

  void visit_of_group(const Node& node) {
    const TreeBlock& block = *node.block;
    const OccluderGroup& group = boxes_.group(node.of);
    if (!block.is_leaf(node.i)) {
      return open({Level::group, node.of, 0}, group.tree().tree(), block.below[node.i], node.straddled_planes);
    }
    const Standing& occluder = occluders_.standing(group.id(block.begin[node.i]));
    if (!painter_.may_draw() || !takes_part_(occluder)) return;
    if (occluder.edition <= memory_.idle_edition && memory_.idle.take(occluder.id.slot(), memory_.taken)) return;
    const BlockTree tree = tree_of(occluder);
    const std::uint32_t source = add_source(occluder);
    if (StandingNodes::is_few(tree.items())) {
      close_few(source, 0, node.straddled_planes);
    } else {
      open({Level::mesh, source, rank_of(occluder.id)}, tree, 0, node.straddled_planes);
    }
  }

  void visit_of_mesh(const Node& node, float nearness) {
    const TreeBlock& block = *node.block;
    const ItemRange polygons = block.items(node.i);
    Source& source = memory_.sources[node.of];
    if (block.is_leaf(node.i)) {
      painter_.use(source.polygons);
      painter_.enqueue(polygons, nearness);
      join(source);
    } else if (StandingNodes::is_few(polygons)) {
      close_few(node.of, block.below[node.i], node.straddled_planes);
    } else {
      const Standing& occluder = *source.occluder;
      open({Level::mesh, node.of, rank_of(occluder.id)}, tree_of(occluder), block.below[node.i], node.straddled_planes);
    }
  }

  static BlockTree tree_of(const Standing& occluder) { return prepared_of(*occluder.mesh).blocks.tree(); }

  std::uint32_t add_source(const Standing& occluder) {
    OccluderInstance stand;
    if (!occluder.is_identity) stand.placement = &occluder.placement;
    if (occluder.is_one_sided) {
      stand.front = occluder.is_mirrored ? CoverMesh::Front::clockwise : CoverMesh::Front::counter_clockwise;
    }
    const CoverTriangles& triangles = prepared_of(*occluder.mesh).triangles;
    memory_.sources.push_back({&occluder, {triangles, stand, triangles_}});
    triangles_ += triangles.size();
    return static_cast<std::uint32_t>(memory_.sources.size() - 1);
  }

  /// What is seen of the few polygons below a block closes pixels.
  void close_few(std::uint32_t number, std::uint32_t block, std::uint32_t straddled_planes) {
    Source& source = memory_.sources[number];
    painter_.use(source.polygons);
    if (source.occluder->is_identity) {
      close_few(source, StandingBoxes{}, block, straddled_planes);
    } else {
      close_few(source, PlacedBoxes{source.occluder->placement}, block, straddled_planes);
    }
  }
  template <class BoxesOf>
  void close_few(Source& source, const BoxesOf& boxes_of, std::uint32_t block, std::uint32_t straddled_planes) {
    ClosingNodes<BoxesOf> nodes(*this, boxes_of, source);
    descent(tree_of(*source.occluder), nodes).run_few(block, straddled_planes);
  }
  void join(Source& source) {
    if (!painter_.flush_group()) return;
    if (!source.is_drawn) ++stats_.occluders;
    source.is_drawn = true;
    memory_.groups.push_back(static_cast<std::uint32_t>(&source - memory_.sources.data()));
    joined_(painter_, *source.occluder);
  }

  const SceneOccluders& occluders_;
  const SceneThings<SceneKind::occluder>& boxes_;
  const SceneOptions& options_;
  const ViewPlanes& view_;
  const CoverBuffer& buffer_;
  CoverPainter& painter_;
  OccluderMemory& memory_;
  SceneStats& stats_;
  const TakesPart& takes_part_;
  const Joined& joined_;
  int worth_ = painter_.budget().worth();  ///< while there is a budget that larger nodes may need
  std::size_t triangles_ = 0;              ///< of the sources
};

}  // namespace occlude::culler
