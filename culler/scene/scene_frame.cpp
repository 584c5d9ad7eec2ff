// SPDX-License-Identifier: MIT
#include "scene/scene_frame.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "cover/cover_descent.h"
#include "cover/drawn_groups.h"
#include "cover/placed.h"
#include "cover/prepared_mesh.h"
#include "descent/add_counts.h"
#include "model/bounds.h"
#include "scene/object_listing.h"
#include "scene/occluder_descent.h"

namespace occlude::culler {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Groups that are worth a thread of their own.
constexpr std::size_t kGroupsOfPart = 4;

class SceneFrame {
  using Part = SceneView::Memory::Part;

 public:
  SceneFrame(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
             SceneView::Memory& memory, const CoverBuffer& hiding)
      : objects_(objects),
        occluders_(occluders),
        options_(options),
        memory_(memory),
        stats_(memory.result.stats),
        buffer_(memory.cover.buffer),
        hiding_(hiding),
        painter_(memory.view, options.cover, options.margin, memory.cover, stats_.work),
        asking_(options, planes_, hiding_, buffer_, nullptr, nullptr, {}) {}
  /// What the frame itself draws into its picture hides.
  SceneFrame(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
             SceneView::Memory& memory)
      : SceneFrame(objects, occluders, options, memory, memory.cover.buffer) {}

  /// Looks for what is idle. REQUIRES: nothing was drawn so far.
  void begin_looking() {
    told_ = &memory_.hiding;
    told_->begin(buffer_);
    memory_.cover.buffer.keep_closings();
  }
  void find_idle() {
    told_->find(memory_.cover.buffer.closings());
    memory_.occluders.find_idle(*told_, memory_.result.idle_occluders);
  }

  /// Keeps the boxes in which objects are found to be hidden.
  void keep_hidden(HiddenBoxes& boxes) { hidden_ = &boxes; }

  /// What is seen of the occluders closes pixels. joined(painter, occluder) is called after each group that is drawn.
  template <class Joined>
  void draw_occluders(const Joined& joined) {
    const auto takes_part = [&](const SceneOccluders::Standing& occluder) { return this->takes_part(occluder); };
    OccluderDescent(occluders_, options_, planes_, buffer_, painter_, memory_.occluders, stats_, takes_part, joined).run();
  }

  /// Lists the objects that are neither hidden nor out of view: first finds the groups that are neither, then lists the
  /// objects of these, perhaps on several threads. Each part lists to room of its own, and the parts are put together in
  /// their order. So the result does not depend on the threads.
  void list_objects() {
    make_room();
    draw_unplaced();
    ObjectListing culled = listing(0, 0);
    find_groups(culled);
    add(culled);
    try {
      list_parts();
    } catch (...) {
      draw_all();
      throw;
    }
    if (!options_.is_front_to_back) return;
    std::ranges::sort(memory_.result.drawn, [](const DrawnObject& a, const DrawnObject& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.id.slot() < b.id.slot();
    });
  }

  /// What became of an object; not yet what hides it. REQUIRES: keep_hidden(), and the objects were listed.
  [[nodiscard]] ObjectFate fate(ObjectId id) {
    using Reason = ObjectFate::Reason;
    const auto object = objects_.seen(id);
    if (!object) return {Reason::not_in_scene};
    if ((object->mask & options_.mask) == 0) return {Reason::in_no_layer};
    if (object->group == nullptr) return {Reason::always_drawn};
    for (std::uint32_t plane = 0; plane < planes_.planes.size(); ++plane) {
      if (beyond(plane, *object->group, object->index)) return {Reason::out_of_view, plane};
    }
    if (hidden_->contains(id.slot())) return {Reason::hidden};
    const bool is_small = asking_.size_of(object->group->outer(object->index)) < options_.least_size;
    return {is_small ? Reason::too_small : Reason::drawn};
  }

  [[nodiscard]] std::optional<Box> beyond(std::uint32_t plane, const ObjectGroup& group, std::uint32_t object) const {
    return asking_.beyond(plane, group, object);
  }

 private:
  [[nodiscard]] bool takes_part(const SceneOccluders::Standing& occluder) const {
    if (occluder.object.is_none()) return true;
    if (options_.is_to_be_held && options_.least_size > 0) return false;
    const auto object = objects_.seen(occluder.object);
    if (!object || (object->mask & options_.mask) == 0) return false;
    return object->group == nullptr || !(asking_.size_of(object->group->outer(object->index)) < options_.least_size);
  }

  void make_room() {
    const std::size_t most = objects_.seen_size();
    memory_.result.drawn.reserve(std::bit_ceil(most));
    if (memory_.room_size >= most) return;
    memory_.room_size = std::bit_ceil(most);
    memory_.room = std::make_unique_for_overwrite<DrawnObject[]>(memory_.room_size);
  }

  [[nodiscard]] ObjectListing listing(std::size_t first, std::size_t objects) {
    const std::span room(memory_.room.get(), memory_.room_size);
    return {options_, planes_, hiding_, buffer_, told_, hidden_, room.subspan(first, objects)};
  }

  /// The groups of a scene, for a descent of their tree.
  class Groups : public StandingNodes {
   public:
    Groups(const SceneFrame& frame, ObjectListing& listing)
        : objects_(frame.objects_),
          mask_(frame.options_.mask),
          view_(frame.planes_),
          seen_(frame.memory_.groups),
          listing_(listing) {}

    [[nodiscard]] kernel::BlockRelations relations(const TreeBlock&, const kernel::BoxBlock& boxes,
                                                   kernel::BoxBytes asked) const {
      return kernel::relations(view_.planes, boxes, asked);
    }
    static bool is_few(const ItemRange&) { return true; }
    void cull(const TreeBlock& block, std::uint32_t i, const Culled& culled) {
      const ItemRange groups = block.items(i);
      listing_.count(culled.by, objects_.count(groups, mask_));
      if (!listing_.keeps(culled.by)) return;
      for (std::uint32_t item = groups.first; item < groups.first + groups.count; ++item) {
        const ObjectGroup& group = objects_.group(item);
        listing_.keep(block.boxes.box(i), group, {0, static_cast<std::uint32_t>(group.size())});
      }
    }
    void hide(const ProjectedBoxes& boxes, kernel::BoxBits hidden) { listing_.hide(boxes, hidden); }
    template <class Boxes>
    bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
      if (!tested.block.is_leaf(i)) return true;
      seen_.push_back({tested.block.begin[i], tested.straddled_planes[i]});
      return false;
    }

   private:
    const SceneObjects& objects_;
    std::uint32_t mask_;
    const ViewPlanes& view_;
    std::vector<SceneView::Memory::SeenGroup>& seen_;
    ObjectListing& listing_;
  };

  void find_groups(ObjectListing& listing) {
    memory_.groups.clear();
    memory_.groups.reserve(std::bit_ceil(objects_.groups().size()));
    Groups groups(*this, listing);
    CoverDescent(objects_.groups().tree(), hiding_, listing.stats().work, groups).run(planes_.all());
  }

  static void prefetch(const ObjectGroup& group) { group.tree().tree().prefetch(0); }

  /// Divides the groups into at most so many parts.
  void divide(std::size_t most) {
    const std::span<const SceneView::Memory::SeenGroup> groups = memory_.groups;
    const std::size_t parts = std::clamp<std::size_t>(groups.size() / kGroupsOfPart, 1, most);
    const std::size_t length = (groups.size() + parts - 1) / parts;
    memory_.parts.clear();
    memory_.parts.reserve(most);
    memory_.runner.reserve(most);
    std::size_t first_object = 0;
    for (std::size_t first = 0; first < groups.size(); first += length) {
      const auto of_part = groups.subspan(first, std::min(length, groups.size() - first));
      std::size_t objects = 0;
      for (const auto& [group, straddled_planes] : of_part) objects += objects_.group(group).living();
      memory_.parts.push_back({of_part, listing(first_object, objects)});
      first_object += objects;
    }
  }

  /// Lists them by the executor.
  void list_parts() {
    const Executor this_thread;
    const Executor& executor = options_.executor == nullptr ? this_thread : *options_.executor;
    divide(4 * executor.threads());
    const auto work_of = [&](std::size_t i) { return memory_.parts[i].groups.size(); };
    memory_.runner.run(executor, memory_.parts.size(), work_of, [&](std::size_t i) { list(memory_.parts[i]); });
    for (Part& part : memory_.parts) add(part.listing);
    memory_.parts.clear();  // they refer to this frame
  }

  void list(Part& part) const {
    part.listing.clear();
    for (std::size_t i = 0; i < part.groups.size(); ++i) {
      if (i + 1 < part.groups.size()) prefetch(objects_.group(part.groups[i + 1].group));
      part.listing.list(objects_.group(part.groups[i].group), part.groups[i].straddled_planes);
    }
  }

  /// Lists all objects that take part, whatever was found.
  void draw_all() {
    memory_.result.drawn.clear();
    stats_.drawn = stats_.out_of_view = stats_.hidden = stats_.too_small = 0;
    draw_unplaced();
    for (std::uint32_t item = 0; item < objects_.groups().size(); ++item) {
      const ObjectGroup& group = objects_.group(item);
      for (std::uint32_t i = 0; i < group.size(); ++i) draw_always(group.id(i), group.mask(i));
    }
  }
  void draw_unplaced() {
    for (const auto unplaced : {objects_.standing_unplaced(), objects_.moving_unplaced()}) {
      for (const auto& [id, mask] : unplaced) draw_always(id, mask);
    }
  }
  void draw_always(ObjectId id, std::uint32_t mask) {
    if ((mask & options_.mask) == 0) return;
    memory_.result.drawn.push_back({id, kInfinity, -kInfinity});
    ++stats_.drawn;
  }

  void add(ObjectListing& listing) {
    memory_.result.drawn.insert(memory_.result.drawn.end(), listing.drawn().begin(), listing.drawn().end());
    const SceneStats& part = listing.stats();
    stats_.drawn += part.drawn;
    stats_.out_of_view += part.out_of_view;
    stats_.hidden += part.hidden;
    stats_.too_small += part.too_small;
    add_counts(stats_.work, part.work);
  }

  const SceneObjects& objects_;
  const SceneOccluders& occluders_;
  const SceneOptions& options_;
  SceneView::Memory& memory_;
  SceneStats& stats_;
  const CoverBuffer& buffer_;  ///< of the frame
  const CoverBuffer& hiding_;  ///< in which objects are hidden: the same, or one that is held
  CoverPainter painter_;
  HidingMeshes* told_ = nullptr;   ///< what is hidden, if that is to be found
  HiddenBoxes* hidden_ = nullptr;  ///< where it is, if that is to be kept
  ViewPlanes planes_{memory_.planes, kernel::Arithmetic::certified};
  ObjectListing asking_;  ///< which lists nothing
};

/// Empties the result, and makes the planes of the view.
void begin_frame(SceneView::Memory& memory) {
  memory.result.drawn.clear();
  memory.result.view.clear();
  memory.occluders.taken.clear();
  memory.view.append_half_spaces(memory.result.view);
  memory.result.stats = {};
  memory.planes.clear();
  for (const HalfSpace& h : memory.result.view) memory.planes.push_back({to_kernel(h.normal), h.offset});
}

/// A frame that is culled again, and keeps what closed which pixel.
class FrameAgain {
 public:
  FrameAgain(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
             const SceneOptions& options)
      : objects_(objects),
        options_(on_this_thread(options)),
        memory_(begun(view, options.cover)),
        frame_(objects, occluders, options_, memory_) {
    memory_.cover.buffer.keep_owners();
    frame_.keep_hidden(hidden_);
    frame_.draw_occluders([&](const CoverPainter& painter, const SceneOccluders::Standing& occluder) {
      drawn_.keep(painter, memory_.cover, static_cast<std::uint32_t>(drawn_occluders_.size()));
      drawn_occluders_.push_back(&occluder);
    });
    frame_.list_objects();
  }

  [[nodiscard]] ObjectFate fate(ObjectId id) {
    ObjectFate fate = frame_.fate(id);
    if (fate.reason == ObjectFate::Reason::hidden) append_hiding(hidden_box(id), fate.by);
    return fate;
  }
  /// The object's own box if that is found to be hidden, else the larger one that was: from several eyes, a box is asked in
  /// other layers than a smaller one in it. REQUIRES: the object is hidden.
  [[nodiscard]] kernel::Aabb hidden_box(ObjectId id) const {
    const auto object = objects_.seen(id);
    const kernel::Aabb own = object->group->outer(object->index);
    return memory_.cover.buffer.hides(own) ? own : hidden_.at(id.slot());
  }
  /// The box of an object that is beyond the plane.
  [[nodiscard]] std::optional<Box> beyond(std::uint32_t plane, const ObjectGroup& group, std::uint32_t object) const {
    return frame_.beyond(plane, group, object);
  }

 private:
  [[nodiscard]] static SceneOptions on_this_thread(SceneOptions options) {
    options.executor = nullptr;
    return options;
  }
  [[nodiscard]] static SceneView::Memory begun(const FrameView& view, const CoverOptions& options) {
    SceneView::Memory memory;
    if (options.as_before) memory.occluders.idle.begin_again(options.as_before->idle);
    memory.occluders.idle_edition = std::numeric_limits<std::uint64_t>::max();
    memory.view = view;
    begin_frame(memory);
    return memory;
  }

  /// Appends the polygons that hide the box, each once.
  void append_hiding(const kernel::Aabb& box, std::vector<ObjectFate::Hiding>& by) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> polygons;
    drawn_.visit_before(memory_.cover.buffer, box,
                        [&](std::uint32_t source, std::uint32_t p) { polygons.emplace_back(source, p); });
    std::ranges::sort(polygons);
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    for (const auto& [source, p] : polygons) {
      const SceneOccluders::Standing& occluder = *drawn_occluders_[source];
      const Hierarchy& tree = *prepared_of(*occluder.mesh).tree;
      const WeldedMesh::Polygon polygon = occluder.polygon(tree.original(p));
      ObjectFate::Hiding hiding{polygon.part, polygon.number, {}};
      for (const std::uint32_t v : tree.soup().loop(p)) {
        hiding.corners.push_back(placed(occluder.placement, to_kernel(tree.soup().vertices[v])));
      }
      if (polygon.is_turned) std::reverse(hiding.corners.begin() + 1, hiding.corners.end());
      by.push_back(std::move(hiding));
    }
  }

  const SceneObjects& objects_;
  SceneOptions options_;
  SceneView::Memory memory_;
  SceneFrame frame_;
  HiddenBoxes hidden_;
  DrawnGroups drawn_;
  std::vector<const SceneOccluders::Standing*> drawn_occluders_;
};

}  // namespace

double reach(const SceneObjects& objects, const SceneOccluders& occluders, const glm::dvec3& eye) {
  kernel::Aabb all = occluders.boxes().box();
  grow(all, objects.box());
  const bool is_empty = all.min.x > all.max.x;
  return is_empty ? 0 : depth(all, eye);
}

void cull_scene(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
                SceneView::Memory& memory) {
  begin_frame(memory);
  SceneOptions limited = options;
  const bool is_adaptive = options.is_adaptive && !options.is_to_be_held && memory.view.eyes.is_point();
  using Kind = WorthOfHiding::Frame;
  Kind kind = Kind::whole;
  if (is_adaptive) {
    memory.worth.begin_next(memory.view, memory.occluders.idle_edition != occluders.edition());
    kind = memory.worth.frame();
    limited.cover = memory.worth.limited(options.cover);
  }
  const bool looks = kind == Kind::looks;
  memory.occluders.idle.begin_next(kind, occluders.slots());
  if (looks) memory.occluders.idle_edition = occluders.edition();
  if (kind == Kind::whole) memory.result.idle_occluders.clear();
  SceneFrame frame(objects, occluders, limited, memory);
  if (looks) frame.begin_looking();
  frame.draw_occluders([](const CoverPainter&, const SceneOccluders::Standing&) {});
  frame.list_objects();
  if (looks) frame.find_idle();
  const SceneStats& stats = memory.result.stats;
  if (is_adaptive) memory.worth.learn(stats.hidden, stats.drawn, stats.work.cover_work);
}

/// Its own picture is for nothing but the sizes of objects, and so as small as pictures are.
void cull_scene_held(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
                     const CoverBuffer& held, SceneView::Memory& memory) {
  begin_frame(memory);
  SceneOptions own = options;
  own.cover.width = own.cover.height = kLeastCoverSide;
  SceneFrame frame(objects, occluders, own, memory, held);
  frame.list_objects();
}

std::vector<ObjectFate> fates_of(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
                                 const SceneOptions& options, std::span<const ObjectId> ids) {
  FrameAgain frame(objects, occluders, view, options);
  std::vector<ObjectFate> fates;
  for (const ObjectId id : ids) fates.push_back(frame.fate(id));
  return fates;
}

void append_witnesses_of(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
                         const SceneOptions& options, std::vector<ObjectWitness>& witnesses) {
  using Reason = ObjectFate::Reason;
  FrameAgain frame(objects, occluders, view, options);
  for (std::uint32_t item = 0; item < objects.groups().size(); ++item) {
    const ObjectGroup& group = objects.group(item);
    for (std::uint32_t i = 0; i < group.size(); ++i) {
      if ((group.mask(i) & options.mask) == 0) continue;
      ObjectFate fate = frame.fate(group.id(i));
      if (fate.reason == Reason::hidden) {
        witnesses.push_back({group.id(i), frame.hidden_box(group.id(i)), std::move(fate)});
      } else if (fate.reason == Reason::out_of_view) {
        witnesses.push_back({group.id(i), *frame.beyond(fate.plane, group, i), std::move(fate)});
      }
    }
  }
}

}  // namespace occlude::culler
