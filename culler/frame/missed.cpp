// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "camera/frame_view.h"
#include "camera/shadow_rule.h"
#include "camera/sound_camera.h"
#include "cover/cull_budget.h"
#include "frame/culler_access.h"
#include "frame/frame_cover.h"
#include "frusta/plane_work.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

MissedReasons::MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame)
    : culler_(culler), hierarchy_(culler.hierarchy()), frame_(frame) {
  find_what_hides(camera, options);
}
MissedReasons::MissedReasons(const Culler& culler, const MatrixCamera& camera, const CullOptions& options,
                             const CullResult& frame)
    : culler_(culler), hierarchy_(culler.hierarchy()), frame_(frame) {
  find_what_hides(camera, options);
}

template <class AnyCamera>
void MissedReasons::find_what_hides(const AnyCamera& camera, const CullOptions& options) {
  for (const Occluder& occluder : frame_.occluders) chosen_.push_back({occluder.index, occluder.frustum});
  if (frame_.method == Method::frusta) {
    const FrameView view(camera, depth(hierarchy_.nodes()[0].box, eye_of(camera)));
    margin_ = std::make_shared<const ShadowMargin>(view, options.margin);
    keep_others(view, options);
    return;
  }
  cover_ = cover_of(culler_, camera, repeated(frame_, options));
  const bool has_budget = triangles_of(options.cover) < triangles_of(CoverOptions{});
  if (!has_budget && frame_.stats.unasked_polygons == 0 && frame_.idle.empty()) return;
  CullOptions unlimited = options;
  unlimited.cover.work = std::numeric_limits<std::size_t>::max();
  unlimited.cover.ms = std::numeric_limits<double>::infinity();
  unlimited.cover.as_before = {};
  unlimited_ = std::make_shared<const CullResult>(culler_.cull(camera, unlimited));
}

namespace {

/// The occluders of the list that look largest from the eye, at most kMostListed, in the order of the list.
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

/// Keeps the occluders of the region's list that may occlude from here and are not chosen.
void MissedReasons::keep_others(const FrameView& view, const CullOptions& options) {
  const OccluderSet& occluders = occluders_of(culler_);
  std::vector<kernel::Vec3> vertices;
  for (const std::uint32_t i : largest_of(occluders.lists().list(view.eye).occluders, occluders, view.eye)) {
    if (std::ranges::find(chosen_, i, &Shadow::occluder) != chosen_.end()) continue;
    occluders.vertices(i, vertices);
    if (view.may_clip(vertices)) continue;
    auto [frustum, refusal] = occluders.shadow(i, view.viewpoint, options.shadow_near);
    if (frustum) others_.push_back({i, std::move(*frustum)});
  }
}

/// The work that is left. When it runs out, what is being asked remains unknown.
class MissedReasons::Work : public PlaneWork {
 public:
  Work(std::size_t most, const Checkpoint& checkpoint) : PlaneWork(most), checkpoint_(checkpoint) {}

  template <class... What>
  void take(const What&... what) {
    checkpoint_();
    PlaneWork::take(what...);
  }

 private:
  const Checkpoint& checkpoint_;
};

/// The relation of a box to the shadow less the margin; `partial` if no work is left.
template <class AnyBox>
kernel::Relation MissedReasons::relation(const Shadow& shadow, const AnyBox& box, Work& work) const {
  if (!work.is_left()) return kernel::Relation::partial;
  const kernel::Decision found = decide_cull(shadow.frustum, box, Asked{}, *margin_);
  work.take(shadow.frustum, found.stage);
  return found.relation;
}

/// Of the shadows that meet the parent, those that meet the node. If one of the others holds the whole node, the rest of
/// them are not tested.
MissedReasons::Meeting MissedReasons::narrowed(const Meeting& above, std::uint32_t node, Work& work) const {
  const auto relation_to = [&](const Shadow& shadow) {
    return hierarchy_.ask(node, [&](const auto& box) { return relation(shadow, box, work); });
  };
  Meeting here;
  for (const Shadow* shadow : above.chosen) {
    if (relation_to(*shadow) != kernel::Relation::outside) here.chosen.push_back(shadow);
  }
  here.holder = above.holder;
  for (const Shadow* shadow : above.others) {
    const kernel::Relation found = relation_to(*shadow);
    if (found == kernel::Relation::inside) {
      here.holder = shadow;
      here.others.clear();
      break;
    }
    if (found == kernel::Relation::partial) here.others.push_back(shadow);
  }
  return here;
}

MissedReasons::Meeting MissedReasons::all() const {
  Meeting result;
  for (const Shadow& shadow : chosen_) result.chosen.push_back(&shadow);
  for (const Shadow& shadow : others_) result.others.push_back(&shadow);
  return result;
}

bool MissedReasons::hides(const Shadow& shadow, const kernel::Aabb& box, Work& work) const {
  return relation(shadow, box, work) == kernel::Relation::inside;
}

bool MissedReasons::is_out_of_view(std::uint32_t p, Work& work) const {
  return std::ranges::any_of(frame_.view, [&](const HalfSpace& h) {
    return std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
      work.take(std::size_t{1});
      const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
      return work.is_left() && kernel::relation({to_kernel(h.normal), h.offset}, kernel::Aabb{corner, corner},
                                                kernel::Arithmetic::certified) == kernel::Relation::outside;
    });
  });
}

/// A shadow is convex: it holds a polygon if it holds its corners. The parts of an occluder are not hidden by it.
bool MissedReasons::hides(const Shadow& shadow, std::uint32_t p, Work& work) const {
  return !std::ranges::binary_search(occluders_of(culler_).parts(shadow.occluder), p) &&
         std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
           const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
           return hides(shadow, kernel::Aabb{corner, corner}, work);
         });
}

Missed MissedReasons::missed_by_cover(std::uint32_t p, const kernel::Aabb& box, Work& work) const {
  if (unlimited_ && culler_.cull_of(*unlimited_, p) != nullptr) return Missed::left_out;
  constexpr std::size_t kPlanes = 100;  // a box takes about as much time: it is projected, and some tiles are read
  work.take(kPlanes);
  const CoverBuffer::Gap gap = cover_->gap(box);
  if (gap == CoverBuffer::Gap::none) return Missed::coarse_node;
  if (gap == CoverBuffer::Gap::beyond_picture) return Missed::beyond_picture;
  return gap == CoverBuffer::Gap::open ? Missed::open_pixel : Missed::not_behind;
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p, const Meeting& meeting, Work& work) const {
  if (is_out_of_view(p, work)) return {Missed::out_of_view, Culled::kNone};
  const kernel::Aabb box = hierarchy_.soup().box(p);
  if (cover_) return {missed_by_cover(p, box, work), Culled::kNone};
  for (const Shadow* shadow : meeting.chosen) {
    if (hides(*shadow, p, work) && hides(*shadow, box, work)) return {Missed::coarse_node, shadow->occluder};
  }
  for (const Shadow* shadow : meeting.chosen) {
    if (hides(*shadow, p, work)) return {Missed::straddling_box, shadow->occluder};
  }
  const bool is_in_several = std::ranges::all_of(hierarchy_.soup().loop(p), [&](std::uint32_t index) {
    const kernel::Vec3 corner = to_kernel(hierarchy_.soup().vertices[index]);
    return std::ranges::any_of(meeting.chosen, [&](const Shadow* s) {
      return hides(*s, kernel::Aabb{corner, corner}, work);
    });
  });
  if (is_in_several) return {Missed::several, Culled::kNone};
  if (meeting.holder != nullptr && hides(*meeting.holder, p, work)) return {Missed::not_chosen, meeting.holder->occluder};
  for (const Shadow* shadow : meeting.others) {
    if (hides(*shadow, p, work)) return {Missed::not_chosen, shadow->occluder};
  }
  return {Missed::no_single_one, Culled::kNone};
}

MissedReasons::Answer MissedReasons::answer(std::uint32_t p) const {
  const Checkpoint none;
  Work unbounded(std::numeric_limits<std::size_t>::max(), none);
  std::uint32_t node = 0;
  Meeting meeting = narrowed(all(), node, unbounded);
  while (!hierarchy_.nodes()[node].is_leaf()) {
    const std::uint32_t right = hierarchy_.nodes()[node].right;
    node = p < hierarchy_.nodes()[right].first ? node + 1 : right;
    meeting = narrowed(meeting, node, unbounded);
  }
  return answer(p, meeting, unbounded);
}

MissedReasons::Counts MissedReasons::count(const Answers& answers) {
  Counts counts{.missed = answers.size()};
  for (const auto& [polygon, answer] : answers) {
    if (answer) ++counts.reasons[static_cast<std::size_t>(answer->reason)];
  }
  return counts;
}

MissedReasons::Counts& MissedReasons::Counts::operator+=(const Counts& other) {
  missed += other.missed;
  for (std::size_t r = 0; r < kMissedReasons; ++r) reasons[r] += other.reasons[r];
  return *this;
}

/// A descent of a part of the tree, which ends when its work runs out.
class MissedReasons::Asking {
 public:
  Asking(const MissedReasons& reasons, const std::vector<bool>& missed, Work& work)
      : reasons_(reasons), missed_(missed), work_(work) {}

  /// Descends to the leaves and to the nodes of at most `polygons` polygons, with the shadows that meet them, and calls
  /// on_subtree for each. Leaves out subtrees without a missed polygon.
  template <class OnSubtree>
  void descend(const Subtree& above, std::uint32_t polygons, const OnSubtree& on_subtree) {
    const HierarchyNode& n = reasons_.hierarchy_.nodes()[above.node];
    if (!work_.is_left() || missed_in(n) == 0) return;
    Subtree here{above.node, reasons_.narrowed(above.meeting, above.node, work_)};
    if (n.is_leaf() || n.count <= polygons) return on_subtree(std::move(here));
    here.node = above.node + 1;
    descend(here, polygons, on_subtree);
    here.node = n.right;
    descend(here, polygons, on_subtree);
  }

  void answer_leaf(const Subtree& leaf, Answers& asked) {
    const HierarchyNode& n = reasons_.hierarchy_.nodes()[leaf.node];
    for (std::uint32_t p = n.first; p < n.first + n.count; ++p) {
      if (!missed_[p] || !work_.is_left()) continue;
      const Answer answer = reasons_.answer(p, leaf.meeting, work_);
      if (work_.is_left()) asked.push_back({p, answer});
    }
  }

  [[nodiscard]] std::size_t missed_in(const HierarchyNode& n) const {
    const auto begin = missed_.begin() + static_cast<std::ptrdiff_t>(n.first);
    return static_cast<std::size_t>(std::count(begin, begin + static_cast<std::ptrdiff_t>(n.count), true));
  }

 private:
  const MissedReasons& reasons_;
  const std::vector<bool>& missed_;
  Work& work_;
};

MissedReasons::Answers MissedReasons::answers(const std::vector<bool>& shows, const Checkpoint& checkpoint,
                                              std::size_t most_work) const {
  const std::size_t size = hierarchy_.soup().size();
  if (shows.size() != size) {
    throw std::invalid_argument(std::to_string(shows.size()) + " polygons that show or do not, for a model of " +
                                std::to_string(size));
  }
  std::vector<bool> missed = polygons_of(frame_.drawn, size);
  for (std::size_t p = 0; p < missed.size(); ++p) missed[p] = missed[p] && !shows[p];
  // Divides the model into subtrees, so that all processors have some.
  constexpr std::uint32_t kShares = 64;
  const HierarchyNode& root = hierarchy_.nodes()[0];
  std::vector<Subtree> subtrees;
  Work work(most_work, checkpoint);
  Asking asking(*this, missed, work);
  asking.descend({0, all()}, root.count / kShares, [&](Subtree&& s) { subtrees.push_back(std::move(s)); });
  const std::size_t total = asking.missed_in(root);
  std::vector<Answers> parts(subtrees.size());
  const auto answer_subtree = [&](std::size_t i) {
    // Half of the work that is left is divided equally, for the way down. The other half is divided in proportion to the
    // missed polygons.
    const double even = 1 / static_cast<double>(subtrees.size());
    const double of_missed =
        static_cast<double>(asking.missed_in(hierarchy_.nodes()[subtrees[i].node])) / static_cast<double>(total);
    const double share = (even + of_missed) / 2;
    Work part(static_cast<std::size_t>(share * static_cast<double>(work.left())), checkpoint);
    Asking below(*this, missed, part);
    below.descend(subtrees[i], 0, [&](const Subtree& leaf) { below.answer_leaf(leaf, parts[i]); });
  };
  parallel_for(subtrees.size(), answer_subtree, checkpoint);
  Answers result;
  result.reserve(total);
  for (std::uint32_t p = 0; p < missed.size(); ++p) {
    if (missed[p]) result.push_back({p, std::nullopt});
  }
  auto next = result.begin();
  for (const Answers& part : parts) {
    for (const MissedPolygon& asked : part) {
      while (next->polygon != asked.polygon) ++next;
      *next = asked;
    }
  }
  return result;
}

}  // namespace occlude::culler
