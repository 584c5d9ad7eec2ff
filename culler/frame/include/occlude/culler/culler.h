// SPDX-License-Identifier: MIT
// The paper's pipeline behind two calls: build once, cull each frame. Reading order: 12.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/matrix_camera.h"
#include "occlude/culler/occluder_set.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/preprocess.h"
#include "occlude/culler/view.h"

namespace occlude::culler {

class BlockTree;
class CoverBuffer;
class CoverTriangles;
class HierarchyBlocks;
class PartReader;
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

  /// The same culler with what listed occluders hide, in the order of the lists (OccluderLists::Stored). Throws
  /// std::invalid_argument unless there is a finite number, not below 0, for each entry.
  [[nodiscard]] Culler with_hidden(std::vector<float> hidden) const;

  /// Makes what frames by a method need: about two seconds for a million polygons by frusta, up to one by cover. Otherwise
  /// the first such frame makes it, on all processors. It is made once. Throws std::runtime_error while the processor does
  /// not round to nearest, and what `checkpoint` throws; the next call tries again.
  void prepare(Method method, const Checkpoint& checkpoint = {}) const;

  /// What to draw for this camera: view-frustum culling, shadow culling and drawing in one traversal (section 5). Nothing
  /// visible is culled if options.arithmetic is certified. There are no probes. Throws std::invalid_argument for a camera
  /// with a fault(), and std::runtime_error while the processor does not round to nearest.
  [[nodiscard]] CullResult cull(const Camera& camera, const CullOptions& options = {}) const;

  /// The same for the next frame of a camera that moves. Occluders are chosen by what they hid in the frames before, which
  /// culls far more. Returns view.result(), valid until the next frame of the view. A view that was used with another culler
  /// starts anew. If the camera or the rounding mode is refused, the view keeps its last frame.
  const CullResult& cull(const Camera& camera, const CullOptions& options, View& view) const;

  /// Both for a camera that is a matrix. Throws std::invalid_argument for a camera with a fault(), the method's included.
  [[nodiscard]] CullResult cull(const MatrixCamera& camera, const CullOptions& options = {}) const;
  const CullResult& cull(const MatrixCamera& camera, const CullOptions& options, View& view) const;

  // What takes a `frame` REQUIRES that it is a frame of this culler, and that `camera` and `options` are those of the frame.
  // Neither is checked.

  /// Calls `visit` for every test of a box against the shadow of one occluder that `frame` took, in the order of the
  /// traversal. Tests of pairs and of probes are left out.
  void visit_shadow_tests(const CullResult& frame, const CullOptions& options,
                          const std::function<void(const Occluder& occluder, const Box& box)>& visit) const;

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

  /// The coarse picture (src/cover_buffer.h) as a frame with these options leaves it. Throws as cull().
  /// REQUIRES: options.method is cover.
  [[nodiscard]] std::shared_ptr<const CoverBuffer> cover(const Camera& camera, const CullOptions& options) const;
  [[nodiscard]] std::shared_ptr<const CoverBuffer> cover(const MatrixCamera& camera, const CullOptions& options) const;

  /// The element of frame.culled whose subtree has polygon p of hierarchy().soup(); null if p is drawn.
  /// REQUIRES: p < hierarchy().soup().size().
  [[nodiscard]] const Culled* cull_of(const CullResult& frame, std::uint32_t p) const;

  /// How the model was prepared.
  [[nodiscard]] const BuildConfig& config() const { return config_; }
  [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }
  /// The potential occluders among the polygons of hierarchy().soup(), and the regions that list them. Made now, as by
  /// prepare(), if neither that nor a frame has.
  [[nodiscard]] const OccluderSet& occluders() const { return occluders({}); }

 private:
  template <class AnyCamera>
  CullResult cull_alone(const AnyCamera& camera, const CullOptions& options) const;
  template <class AnyCamera>
  const CullResult& cull_next(const AnyCamera& camera, const CullOptions& options, View& view) const;
  template <class AnyCamera>
  void append_covers_of(const CullResult& frame, const AnyCamera& camera, const CullOptions& options, std::size_t most,
                        std::vector<CoverWitness>& witnesses) const;
  const OccluderSet& occluders(const Checkpoint& checkpoint) const;
  const CoverTriangles& triangles(const Checkpoint& checkpoint = {}) const;
  const HierarchyBlocks& blocks(const Checkpoint& checkpoint = {}) const;
  BlockTree tree() const;

  Culler(const PartReader& parts, const Checkpoint& checkpoint);
  Culler(const Culler& other, OccluderSet occluders);

  Identity identity_;
  BuildConfig config_;
  Hierarchy hierarchy_;
  std::shared_ptr<Lazy<OccluderSet>> occluders_;
  std::shared_ptr<Lazy<HierarchyBlocks>> blocks_;
  std::shared_ptr<Lazy<CoverTriangles>> triangles_;
};

}  // namespace occlude::culler
