// SPDX-License-Identifier: MIT
// The paper's pipeline behind two calls: build once, cull each frame. Reading order: 12.
#pragma once

#include <functional>
#include <memory>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_set.h"
#include "occlude/culler/preprocess.h"
#include "occlude/culler/view.h"

namespace occlude::culler {

class CoverBuffer;
class CoverTriangles;
class LazyTriangles;

/// Const calls may run on several threads at once.
class Culler {
 public:
  /// Throws std::invalid_argument, with the place and the reason, for a soup that is empty, that is not well formed
  /// (polygon_soup.h) or has a coordinate that is not finite or out of the kernel's legal range, and for a grid that cannot
  /// be; std::runtime_error while the processor does not round to nearest (occlude/kernel/validity.h). Seconds for millions
  /// of polygons: what `checkpoint` throws meanwhile comes out.
  explicit Culler(const PolygonSoup& soup, const BuildConfig& config = {}, const Checkpoint& checkpoint = {});
  /// From what preprocess() found out about this soup. Throws std::invalid_argument also when it is about another.
  Culler(const PolygonSoup& soup, Preprocess preprocess, const Checkpoint& checkpoint = {});

  /// Makes what frames by cover need, which else the first of them does: half a second for a million polygons. What
  /// `checkpoint` throws comes out.
  void prepare_cover(const Checkpoint& checkpoint = {}) const;

  /// What to draw for this camera: view-frustum culling, shadow culling and drawing in one traversal (section 5). Nothing
  /// visible is culled when options.arithmetic is certified. Throws std::invalid_argument for a camera with a fault(),
  /// and std::runtime_error while the processor does not round to nearest.
  [[nodiscard]] CullResult cull(const Camera& camera, const CullOptions& options = {}) const;

  /// The same for the next frame of a camera that moves: occluders are chosen by what they hid in the frames before, which
  /// culls far more. Returns view.result(). A view that was used with another culler or scene starts anew.
  const CullResult& cull(const Camera& camera, const CullOptions& options, View& view) const;

  // What follows REQUIRES that `frame` is one of this culler, which is not checked.

  /// Calls `visit` for every test of a box against a shadow that `frame` took, in the order of the traversal. `options` are
  /// those of the frame.
  void visit_shadow_tests(const CullResult& frame, const CullOptions& options,
                          const std::function<void(const Occluder& occluder, const Box& box)>& visit) const;

  /// Appends the proof of every cull of the frame, but for what hides culls by cover.
  void append_witnesses(const CullResult& frame, std::vector<Witness>& witnesses) const;

  /// The same of the culls by cover, found again: a cull is proved as one, or, while its proof has more than `most` corners,
  /// as its two halves, and a leaf polygon by polygon. `camera` and `options` are those of the frame.
  void append_covers(const CullResult& frame, const Camera& camera, const CullOptions& options, std::size_t most,
                     std::vector<CoverWitness>& witnesses) const;

  /// The coarse picture as a frame by cover with these options leaves it.
  [[nodiscard]] std::shared_ptr<const CoverBuffer> cover(const Camera& camera, const CullOptions& options) const;

  /// The cull of the frame that took polygon p of the tree; null where it is drawn.
  [[nodiscard]] const Culled* cull_of(const CullResult& frame, std::uint32_t p) const;

  /// How the model was prepared.
  [[nodiscard]] const BuildConfig& config() const { return config_; }
  [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }
  /// What may be an occluder, of the polygons of hierarchy().soup(), and the regions that list it.
  [[nodiscard]] const OccluderSet& occluders() const { return occluders_; }

 private:
  const CoverTriangles& triangles(const Checkpoint& checkpoint = {}) const;

  Identity identity_;
  BuildConfig config_;
  Hierarchy hierarchy_;
  OccluderSet occluders_;
  std::shared_ptr<LazyTriangles> triangles_;
};

}  // namespace occlude::culler
