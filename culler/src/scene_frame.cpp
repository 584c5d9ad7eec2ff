// SPDX-License-Identifier: MIT
#include "scene_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "bounds.h"
#include "cover_descent.h"
#include "drawn_groups.h"
#include "placed.h"
#include "prepared_mesh.h"
#include "seen_boxes.h"

namespace occlude::culler {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A tree of a mesh where the mesh stands. Its boxes need only be about right: what is not drawn into the coarse picture
/// hides nothing.
struct PlacedTree {
  std::span<const HierarchyNode> nodes;
  const Placement& placement;

  [[nodiscard]] kernel::Aabb box(std::uint32_t node) const { return placed(placement, nodes[node].box); }
  template <class Question>
  decltype(auto) ask(std::uint32_t node, const Question& question) const {
    return question(box(node));
  }
};

auto volumes_of(std::span<const HierarchyNode> nodes) {
  return [nodes](std::uint32_t node, const auto& question) { return question(nodes[node].box); };
}

class SceneFrame {
 public:
  SceneFrame(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
             const SceneOptions& options, SceneView::Memory& memory)
      : objects_(objects),
        occluders_(occluders),
        options_(options),
        memory_(memory),
        result_(memory.result),
        work_(memory.result.stats.work),
        buffer_(memory.cover.buffer),
        painter_(view, options.cover, options.margin, memory.cover, work_) {}

  /// What is seen of the occluders closes pixels. joined(painter, occluder) is called after each group that is drawn.
  template <class Joined>
  void draw_occluders(const Joined& joined) {
    for (const SceneOccluders::Forest& forest : occluders_.forests()) {
      const auto see = [&](const SeenNode& leaf) {
        draw(forest.occluders[forest.tree.order()[forest.tree.nodes()[leaf.node].first]], leaf.across, joined);
      };
      descend(
          forest.tree.nodes(), see, [](const Culled&) {}, planes_.all());
    }
  }

  /// What becomes of an object; not yet what hides it. REQUIRES: the occluders were drawn.
  [[nodiscard]] ObjectFate fate(ObjectId id) {
    using Reason = ObjectFate::Reason;
    const auto object = objects_.seen(id);
    if (!object) return {Reason::not_in_scene};
    if ((object->mask & options_.mask) == 0) return {Reason::in_no_layer};
    if (object->group == nullptr) return {Reason::always_drawn};
    for (std::uint32_t plane = 0; plane < planes_.planes.size(); ++plane) {
      if (is_out_of_view(*object->group, object->index, 1U << plane)) return {Reason::out_of_view, plane};
    }
    const kernel::Aabb& box = object->group->outer(object->index);
    if (buffer_.hides(box)) return {Reason::hidden};
    return {size_of(box) < options_.least_size ? Reason::too_small : Reason::drawn};
  }

  /// Lists the objects that are neither hidden nor out of view.
  void list_objects() {
    for (const auto unplaced : {objects_.standing_unplaced(), objects_.moving_unplaced()}) {
      for (const auto& [id, mask] : unplaced) {
        if ((mask & options_.mask) != 0) draw({id, kInfinity, -kInfinity});
      }
    }
    const LinearTree& groups = objects_.groups();
    const auto see = [&](const SeenNode& leaf) {
      list(objects_.group(groups.order()[groups.nodes()[leaf.node].first]), leaf.across);
    };
    const auto cull = [&](const Culled& culled) {
      const HierarchyNode& node = groups.nodes()[culled.node];
      for (const std::uint32_t i : groups.order().subspan(node.first, node.count)) {
        const ObjectGroup& group = objects_.group(i);
        count(culled.by, group.count(group.nodes()[0], options_.mask));
      }
    };
    descend(groups.nodes(), see, cull, planes_.all());
    if (!options_.is_front_to_back) return;
    std::ranges::sort(result_.drawn, [](const DrawnObject& a, const DrawnObject& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.id.slot < b.id.slot;
    });
  }

 private:
  template <class See, class Cull>
  void descend(std::span<const HierarchyNode> nodes, const See& see, const Cull& cull, std::uint32_t across) {
    const auto ask = volumes_of(nodes);
    const StandingTree tree{nodes, ask};
    CoverDescent(tree, planes_, buffer_, work_, see, cull, [] {}).run(across);
  }

  [[nodiscard]] bool takes_part(const SceneOccluders::Standing& occluder) const {
    if ((occluder.mask & options_.mask) == 0) return false;
    if (occluder.object.is_none()) return true;
    const auto object = objects_.seen(occluder.object);
    if (!object || (object->mask & options_.mask) == 0) return false;
    return object->group == nullptr || !(size_of(object->group->outer(object->index)) < options_.least_size);
  }

  template <class Joined>
  void draw(const SceneOccluders::Standing& occluder, std::uint32_t across, const Joined& joined) {
    if (!painter_.may_draw() || !takes_part(occluder)) return;
    CoverStand stand;
    if (!occluder.is_identity) stand.placement = &occluder.placement;
    if (occluder.is_one_sided) {
      stand.front = occluder.is_mirrored ? CoverMesh::Front::clockwise : CoverMesh::Front::counter_clockwise;
    }
    const CoverSource source = occluder.mesh->prepared().source(stand);
    painter_.use(source);
    const std::uint32_t before = painter_.groups();
    const auto see = [&](const SeenNode& leaf) {
      if (leaf.is_worth_closing) painter_.take(leaf.node);
    };
    const auto join = [&] {
      if (painter_.join()) joined(painter_, occluder);
    };
    const auto ignore = [](const Culled&) {};
    const PlacedTree tree{source.nodes, occluder.placement};
    CoverDescent(tree, planes_, buffer_, work_, see, ignore, join).run(across);
    if (painter_.groups() != before) ++result_.stats.occluders;
  }

  /// The objects of a group whose box is neither hidden nor out of view.
  void list(const ObjectGroup& group, std::uint32_t across) {
    const auto see = [&](const SeenNode& leaf) { list(group, group.nodes()[leaf.node], leaf.across); };
    const auto cull = [&](const Culled& culled) {
      count(culled.by, group.count(group.nodes()[culled.node], options_.mask));
    };
    descend(group.nodes(), see, cull, across);
  }

  /// Those of a leaf.
  void list(const ObjectGroup& group, const HierarchyNode& leaf, std::uint32_t across) {
    static_assert(ObjectGroup::kLeaf <= SeenBoxes::kMost);
    SeenBoxes boxes;
    std::array<std::uint32_t, SeenBoxes::kMost> at{};
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      if ((group.mask(i) & options_.mask) == 0) continue;
      if (is_out_of_view(group, i, across)) {
        count(Culled::By::view, 1);
        continue;
      }
      at[boxes.size] = i;
      boxes.add(buffer_.box_picture(), group.outer(i));
    }
    boxes.see(buffer_.box_picture());
    for (std::size_t k = 0; k < boxes.size; ++k) {
      ++work_.cover_tests;
      const float size = buffer_.seen_size(boxes, k);
      if (buffer_.hides(buffer_.footprint(boxes, k))) {
        count(Culled::By::cover, 1);
      } else if (size < options_.least_size) {
        ++result_.stats.too_small;
      } else {
        draw({group.id(at[k]), size, boxes.distance[k]});
      }
    }
  }

  [[nodiscard]] bool is_out_of_view(const ObjectGroup& group, std::uint32_t i, std::uint32_t across) {
    for (std::uint32_t left = across; left != 0; left &= left - 1) {
      const auto plane = static_cast<std::size_t>(std::countr_zero(left));
      ++work_.view_tests;
      const kernel::Relation relation =
          group.ask(i, [&](const auto& box) { return kernel::relation(planes_.planes[plane], box, planes_.arithmetic); });
      if (relation == kernel::Relation::outside) return true;
    }
    return false;
  }

  [[nodiscard]] float size_of(const kernel::Aabb& box) const {
    SeenBoxes boxes;
    boxes.add(buffer_.box_picture(), box);
    boxes.see(buffer_.box_picture());
    return buffer_.seen_size(boxes, 0);
  }

  void draw(const DrawnObject& object) {
    result_.drawn.push_back(object);
    ++result_.stats.drawn;
  }

  void count(Culled::By by, std::size_t objects) {
    (by == Culled::By::view ? result_.stats.out_of_view : result_.stats.hidden) += objects;
  }

  const SceneObjects& objects_;
  const SceneOccluders& occluders_;
  const SceneOptions& options_;
  SceneView::Memory& memory_;
  SceneResult& result_;
  CullStats& work_;
  const CoverBuffer& buffer_;
  CoverPainter painter_;
  ViewPlanes planes_{memory_.planes, kernel::Arithmetic::certified};
};

/// Appends the polygons that hide the box, each once.
void append_hiding(const DrawnGroups& drawn, std::span<const SceneOccluders::Standing* const> occluders,
                   const CoverBuffer& buffer, const kernel::Aabb& box, std::vector<ObjectFate::Hiding>& by) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> polygons;
  drawn.visit_before(buffer, box, [&](std::uint32_t source, std::uint32_t p) { polygons.emplace_back(source, p); });
  std::ranges::sort(polygons);
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  for (const auto& [source, p] : polygons) {
    const SceneOccluders::Standing& occluder = *occluders[source];
    const Hierarchy& tree = *occluder.mesh->prepared().tree;
    ObjectFate::Hiding hiding{occluder.id, tree.original(p), {}};
    for (const std::uint32_t v : tree.soup().loop(p)) {
      hiding.corners.push_back(placed(occluder.placement, to_kernel(tree.soup().vertices[v])));
    }
    by.push_back(std::move(hiding));
  }
}

/// Empties the result, and makes the planes of the view.
void begin_frame(SceneView::Memory& memory) {
  memory.result.drawn.clear();
  memory.result.view.clear();
  memory.view.append_half_spaces(memory.result.view);
  memory.result.stats = {};
  memory.planes.clear();
  for (const HalfSpace& h : memory.result.view) memory.planes.push_back({to_kernel(h.normal), h.offset});
}

}  // namespace

double reach(const SceneObjects& objects, const SceneOccluders& occluders, const glm::dvec3& eye) {
  kernel::Aabb all = occluders.box();
  if (!objects.groups().nodes().empty()) grow(all, objects.groups().nodes()[0].box);
  const bool is_empty = all.min.x > all.max.x;
  return is_empty ? 0 : depth(all, eye);
}

void cull_scene(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
                SceneView::Memory& memory) {
  begin_frame(memory);
  memory.result.drawn.reserve(std::bit_ceil(objects.seen_size()));
  SceneFrame frame(objects, occluders, memory.view, options, memory);
  frame.draw_occluders([](const CoverPainter&, const SceneOccluders::Standing&) {});
  frame.list_objects();
}

std::vector<ObjectFate> fates_of(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
                                 const SceneOptions& options, std::span<const ObjectId> ids) {
  SceneView::Memory memory;
  memory.view = view;
  begin_frame(memory);
  SceneFrame frame(objects, occluders, memory.view, options, memory);
  memory.cover.buffer.keep_owners();
  DrawnGroups drawn;
  std::vector<const SceneOccluders::Standing*> drawn_occluders;
  frame.draw_occluders([&](const CoverPainter& painter, const SceneOccluders::Standing& occluder) {
    drawn.keep(painter, memory.cover, static_cast<std::uint32_t>(drawn_occluders.size()));
    drawn_occluders.push_back(&occluder);
  });
  std::vector<ObjectFate> fates;
  for (const ObjectId id : ids) {
    fates.push_back(frame.fate(id));
    if (fates.back().reason != ObjectFate::Reason::hidden) continue;
    const auto object = objects.seen(id);
    append_hiding(drawn, drawn_occluders, memory.cover.buffer, object->group->outer(object->index), fates.back().by);
  }
  return fates;
}

}  // namespace occlude::culler
