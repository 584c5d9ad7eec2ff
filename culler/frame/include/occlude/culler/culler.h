// SPDX-License-Identifier: MIT
// The paper's pipeline behind two calls: build once, cull each frame. Reading order: 12.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/parts.h"

namespace occlude::culler {

/// 1. A view belongs to one camera, and one thread at a time may cull with it. Different views may be culled at once.
/// 2. If it is used with another culler than in the frame before, it starts anew, as if it had just been made.
/// 3. After its first frame nothing more is allocated. Exceptions: culler/README.md, Budgets.
/// 4. A view that was moved from may only be destroyed or assigned to.
class View {
 public:
  View();
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;

  /// The last frame; empty before the first. Valid until the next frame of this view.
  [[nodiscard]] const CullResult& result() const;

  /// Whether any box, such as that of an object about to be created, would be visible in the last frame.
  /// 1. It is tested against the frame's half-spaces, and its occluders or cover, with the frame's margin. The tests are
  ///    certified, whatever the frame's arithmetic. Shadows begin strictly beyond their near planes.
  /// 2. Before the first frame everything is visible.
  /// 3. The box may reach farther from the eye than everything that the culler holds. Then the half-spaces are
  ///    moved outwards by another margin, that of its L1 distance (append_view_frustum()), and no cover hides it.
  /// 4. Allocates nothing. Many threads may ask the same view at once, while no frame of it is being culled.
  /// Throws std::invalid_argument for a box that is not legal, and std::runtime_error while the processor does not round to
  /// nearest (occlude/kernel/validity.h).
  [[nodiscard]] Visibility visibility(const Box& box) const;

  /// Whether the last frame does for this camera, too: it culls nothing that the camera shows from its eye and from all of
  /// its `eyes`. Takes about a microsecond.
  /// 1. It is never true by rounding. A camera may be turned by rounding as far as a frame's margins for single precision
  ///    have room for: by less than 2^-22.
  /// 2. It is true if the eyes are in the region of the frame's camera, the picture as seen from the eye is within that
  ///    camera's, the far plane is no farther, and what hid something is not before the near plane. So a camera that is
  ///    turned needs a nearer near plane: at each corner of its picture, near (forward of the frame . c) must be no more
  ///    than the near plane of the frame, where c is the corner's ray at a distance of 1. If the frame is of one eye, it
  ///    culled what was before its near plane, so that the two near planes must be the same.
  /// 3. It is true of the frame's camera, and of one that differs from it only by an eye of the region, unless that is
  ///    within rounding of the region's surface. The eye of a matrix is known up to rounding.
  /// 4. It is false of a camera of another projection, of parallel rays in any other direction, and of parallel rays that
  ///    are another matrix. It is false before the first frame.
  /// 5. It knows nothing of CullOptions::margin, which is a share of the height of the frame's picture. A move by m in the
  ///    camera's picture, at a distance of 1, is one by up to m |c|^2 in the frame's, c the ray of a corner of the frame's.
  /// Throws as Culler::cull().
  [[nodiscard]] bool holds_for(const Camera& camera) const;
  [[nodiscard]] bool holds_for(const MatrixCamera& camera) const;

  struct Memory;  ///< frame/view_memory.h

 private:
  friend Memory& memory_of(const View& view);

  std::unique_ptr<Memory> memory_;
};

class BlockTree;
class CoverTriangles;
class HierarchyBlocks;
class OccluderSet;
template <class T>
class Lazy;

/// Const calls may run on several threads at once, each with a View of its own. A copy counts as the same culler for a View.
class Culler {
 public:
  /// Builds the tree. Takes the soup: one that is moved here is not copied. Takes a second for a million polygons. What
  /// frames by one method need beside it is made later: prepare(), which takes a checkpoint of its own. Throws
  /// 1. std::invalid_argument, with the place and the reason, for a soup that is empty, that is not well formed
  ///    (polygon_soup.h) or has a coordinate that is not finite or out of the kernel's legal range, and for a config.lists
  ///    out of range;
  /// 2. std::runtime_error while the processor does not round to nearest (occlude/kernel/validity.h);
  /// 3. what `checkpoint` throws.
  explicit Culler(PolygonSoup soup, const BuildConfig& config = {}, const Checkpoint& checkpoint = {});
  /// The same culler from its parts, which are kept and not copied. What only frames by one method need may be left out
  /// (method_of()), and is then made later, as config() says, but for samples of preprocess(), which are lost. Takes a
  /// twentieth of the time. Everything that a wrong cull could come of is checked on all processors, and
  /// std::invalid_argument thrown, with the part and the reason, if it cannot be of these polygons. Parts may come from
  /// anywhere:
  /// 1. No parts lead out of bounds, or to more memory than several times their size. Trees have at most kMostLevels levels.
  ///    What is left out takes what its making takes. Where lists are left out, settings are refused that ask for more
  ///    regions or entries than the bytes of the model (with Parts::left_out) could hold, and more than the default.
  /// 2. Nothing visible is culled, whatever they are, as long as oriented boxes hold their polygons. This alone is not
  ///    checked, and concerns Bounds::obb alone.
  /// 3. What is heuristics may be anything: the lists, and what is known of occluders.
  /// Convex shells are made when they are first chosen: until then frames allocate, against (3) of View.
  /// Throws also as (2) and (3) above.
  explicit Culler(const Parts& parts, const Checkpoint& checkpoint = {});

  /// All parts of the culler, which they keep. Makes what frames need as prepare() does. The same culler always gives the
  /// same bytes.
  [[nodiscard]] Parts parts(const Checkpoint& checkpoint = {}) const;
  /// The method whose frames alone need the part of this name; none if it must always be there.
  [[nodiscard]] static std::optional<Method> method_of(std::string_view part);

  /// Makes what frames by a method need: about two seconds for a million polygons by frusta, up to one by cover. Otherwise
  /// the first such frame makes it, on all processors. It is made once. Throws std::runtime_error while the processor does
  /// not round to nearest, and what `checkpoint` throws; the next call tries again.
  void prepare(Method method = Method::automatic, const Checkpoint& checkpoint = {}) const;

  /// What to draw for this camera, by options.method. Nothing visible is culled if options.arithmetic is certified. By
  /// frusta, a frame without a view has no probes and chooses occluders by what they look like alone. Throws
  /// std::invalid_argument for a camera with a fault(), and std::runtime_error while the processor does not round to
  /// nearest.
  [[nodiscard]] CullResult cull(const Camera& camera, const CullOptions& options = {}) const;

  /// The same for the next frame of a camera that moves. By frusta, occluders are chosen by what they hid in the frames
  /// before, which culls far more; by cover, memory is kept, and nothing else. Returns view.result(), valid until the next
  /// frame of the view. A view that was used with another culler starts anew. If the camera or the rounding mode is refused,
  /// the view keeps its last frame.
  const CullResult& cull(const Camera& camera, const CullOptions& options, View& view) const;

  /// Both for a camera that is a matrix. Throws std::invalid_argument for a camera with a fault().
  [[nodiscard]] CullResult cull(const MatrixCamera& camera, const CullOptions& options = {}) const;
  const CullResult& cull(const MatrixCamera& camera, const CullOptions& options, View& view) const;

  // What takes a `frame` REQUIRES that it is a frame of this culler, and that `camera` and `options` are those of the frame.
  // Neither is checked.

  /// Appends a witness for every cull of the frame, in the order of frame.culled. What hides a cull by cover is not in it:
  /// see append_covers().
  void append_witnesses(const CullResult& frame, std::vector<Witness>& witnesses) const;

  /// Appends what hides each cull by cover; nothing for a frame by frusta. Culls the frame again to find it. A subtree has
  /// one witness if the polygons that hide it have at most `most` corners together. Otherwise its two halves have witnesses
  /// of their own, and each polygon of a leaf. Throws as cull().
  void append_covers(const CullResult& frame, const Camera& camera, const CullOptions& options, std::size_t most,
                     std::vector<CoverWitness>& witnesses) const;
  /// Of a camera with several eyes, the same polygons hide the subtree from each of them.
  void append_covers(const CullResult& frame, const MatrixCamera& camera, const CullOptions& options, std::size_t most,
                     std::vector<CoverWitness>& witnesses) const;

  /// The element of frame.culled whose subtree has polygon p of hierarchy().soup(); null if p is drawn.
  /// REQUIRES: p < hierarchy().soup().size().
  [[nodiscard]] const Culled* cull_of(const CullResult& frame, std::uint32_t p) const;

  /// How the model was prepared.
  [[nodiscard]] const BuildConfig& config() const { return config_; }
  [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }

 private:
  friend struct CullerAccess;  // frame/culler_access.h

  template <class AnyCamera>
  CullResult cull_alone(const AnyCamera& camera, const CullOptions& options) const;
  template <class AnyCamera>
  const CullResult& cull_next(const AnyCamera& camera, const CullOptions& options, View& view) const;
  const OccluderSet& occluders(const Checkpoint& checkpoint = {}) const;
  const CoverTriangles& triangles(const Checkpoint& checkpoint = {}) const;
  const HierarchyBlocks& blocks(const Checkpoint& checkpoint = {}) const;
  BlockTree tree() const;

  Culler(const PartReader& parts, const Checkpoint& checkpoint);
  Culler(const Culler& other, OccluderSet occluders);

  BuildConfig config_;
  Hierarchy hierarchy_;
  std::shared_ptr<Lazy<OccluderSet>> occluders_;  ///< tells cullers apart, too
  std::shared_ptr<Lazy<HierarchyBlocks>> blocks_;
  std::shared_ptr<Lazy<CoverTriangles>> triangles_;
};

/// How depth complexity is sampled (section 4, criterion 2). The same seed gives the same samples.
struct SampleConfig {
  enum class Pattern {
    even,    ///< a sequence of low discrepancy (Roberts 2018), shifted from region to region
    random,  ///< independent points
  };
  Pattern pattern = Pattern::even;
  /// Viewpoints in each region; 0: nothing is sampled. Takes minutes for a large model. Worth much only to frames that have
  /// no past (culler/README.md).
  std::size_t viewpoints = 0;
  std::uint64_t seed = 1;
};

/// Prepares the model and samples what its occluders hide: the culler of this soup with OccluderLists::Stored::hidden. Runs
/// on all processors; the result does not depend on their number. While sampling, calls progress(done, all), if given, after
/// each of all regions: on any thread, one call at a time. What it or `checkpoint` throws stops the work and is thrown on.
/// Throws also as the constructor of Culler.
[[nodiscard]] Culler preprocess(PolygonSoup soup, const BuildConfig& config, const SampleConfig& samples,
                                const std::function<void(std::size_t done, std::size_t all)>& progress = {},
                                const Checkpoint& checkpoint = {});

class CoverBuffer;
class ShadowMargin;
struct FrameView;

/// Reasons, in the order in which they are tested: the first that holds is the answer.
/// 1. Frames by frusta have the first six.
/// 2. Frames by cover have the first two and the last four. For them read "hidden by the frame's final coarse picture" where
///    coarse_node says "in the shadow".
enum class Missed {
  out_of_view,     ///< the polygon is beyond a half-space of the view, its leaf is not
  coarse_node,     ///< the polygon's own box is in the shadow of an occluder of the frame, its leaf's box is not
  straddling_box,  ///< the polygon is in the shadow of an occluder of the frame, its box is not
  several,         ///< each corner is in the shadow of some occluder of the frame, but not all in the same one
  not_chosen,      ///< the polygon is in the shadow of an occluder of the region's list that the frame did not choose
  no_single_one,   ///< no occluder of the list hides it alone: several do, or what it shows is less than a pixel
  beyond_picture,  ///< its box reaches beyond the coarse picture or in front of the near plane
  left_out,        ///< it would be culled if the frame had no budget and took nothing as idle; asked second
  open_pixel,      ///< a pixel that its box touches is open: a border runs there, or nothing closes it
  not_behind       ///< all pixels that its box touches are closed, but in one of them not strictly in front of the box
};
inline constexpr std::size_t kMissedReasons = 10;

/// Whether a frame by this method can miss a polygon for this reason.
[[nodiscard]] constexpr bool is_of(Missed reason, Method method) {
  if (reason <= Missed::coarse_node) return true;
  return (reason >= Missed::beyond_picture) == is_by_cover(method);
}

[[nodiscard]] constexpr std::string_view to_string(Missed reason) {
  constexpr std::array<std::string_view, kMissedReasons> kNames{"out_of_view", "coarse_node",   "straddling_box", "several",
                                                                "not_chosen",  "no_single_one", "beyond_picture", "left_out",
                                                                "open_pixel",  "not_behind"};
  return kNames[static_cast<std::size_t>(reason)];
}

/// Finds the reasons for one frame. Shadows are less the frame's margin, begin strictly beyond their near planes, and are
/// decided exactly. For analysis, not for every frame: it makes the shadow of every occluder that the region lists.
/// Const calls may run on several threads at once.
class MissedReasons {
 public:
  /// The most occluders of the region's list that are tried: those that look largest from the eye. Nearly all lists of the
  /// models tried are shorter.
  static constexpr std::size_t kMostListed = 4096;
  /// The default work of answers(): about a second of one processor. The unit is one plane of a shadow that a box or a
  /// corner is tested against (README.md, Budgets).
  static constexpr std::size_t kMostWork = std::size_t{1} << 28U;

  /// REQUIRES: `frame` is what `culler` made of this camera with these options, which is not checked; `culler` and `frame`
  /// outlive this object. For a frame by cover, culls the frame again, and throws as Culler::cull().
  MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame);
  MissedReasons(const Culler& culler, const MatrixCamera& camera, const CullOptions& options, const CullResult& frame);

  struct Answer {
    Missed reason;
    std::uint32_t occluder = Culled::kNone;  ///< one that hides the polygon alone, as Occluder::index, or kNone

    friend bool operator==(const Answer&, const Answer&) = default;
  };
  /// Why polygon p of Hierarchy::soup() was not culled. Takes as much work as it needs. REQUIRES: p is hidden, and drawn by
  /// the frame.
  [[nodiscard]] Answer answer(std::uint32_t p) const;

  /// A polygon that is hidden and drawn.
  struct MissedPolygon {
    std::uint32_t polygon;
    std::optional<Answer> answer;  ///< as of answer(polygon); none if there was too little work

    friend bool operator==(const MissedPolygon&, const MissedPolygon&) = default;
  };
  using Answers = std::vector<MissedPolygon>;
  /// Everything that the frame missed, ascending, with the reasons as far as `most_work` goes. Runs on all processors; the
  /// result does not depend on their number. shows[p] tells whether polygon p of Hierarchy::soup() is visible in the frame.
  /// What `checkpoint` throws is thrown on. Throws std::invalid_argument unless shows.size() is the number of polygons.
  [[nodiscard]] Answers answers(const std::vector<bool>& shows, const Checkpoint& checkpoint = {},
                                std::size_t most_work = kMostWork) const;

  struct Counts {
    std::size_t missed = 0;                             ///< polygons that are hidden and drawn
    std::array<std::size_t, kMissedReasons> reasons{};  ///< how many of them were missed for each, of those that were asked

    [[nodiscard]] std::size_t asked() const { return std::accumulate(reasons.begin(), reasons.end(), std::size_t{0}); }
    Counts& operator+=(const Counts& other);
  };
  [[nodiscard]] static Counts count(const Answers& answers);

 private:
  struct Shadow {
    std::uint32_t occluder;
    kernel::ShadowFrustum frustum;
  };
  /// The shadows that meet a node.
  struct Meeting {
    std::vector<const Shadow*> chosen, others;
    const Shadow* holder = nullptr;  ///< one of the others, that has all of it
  };
  struct Subtree {
    std::uint32_t node;
    Meeting meeting;
  };
  class Asking;
  class Work;

  template <class AnyCamera>
  void find_what_hides(const AnyCamera& camera, const CullOptions& options);
  void keep_others(const FrameView& view, const CullOptions& options);
  [[nodiscard]] Meeting all() const;
  [[nodiscard]] Meeting narrowed(const Meeting& above, std::uint32_t node, Work& work) const;
  [[nodiscard]] Answer answer(std::uint32_t p, const Meeting& meeting, Work& work) const;
  template <class AnyBox>
  [[nodiscard]] kernel::Relation relation(const Shadow& shadow, const AnyBox& box, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, std::uint32_t p, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, const kernel::Aabb& box, Work& work) const;
  [[nodiscard]] bool is_out_of_view(std::uint32_t p, Work& work) const;
  [[nodiscard]] Missed missed_by_cover(std::uint32_t p, const kernel::Aabb& box, Work& work) const;

  const Culler& culler_;
  const Hierarchy& hierarchy_;
  const CullResult& frame_;
  std::vector<Shadow> chosen_, others_;
  std::shared_ptr<const ShadowMargin> margin_;   ///< of a frame by frusta
  std::shared_ptr<const CoverBuffer> cover_;     ///< of a frame by cover
  std::shared_ptr<const CullResult> unlimited_;  ///< the frame without a budget, if it has spent one
};

}  // namespace occlude::culler
