// SPDX-License-Identifier: MIT
// The pipeline for engines, which draw objects and not polygons: boxes that stay, boxes that move, and occluders that need
// not be what is drawn. Reading order: 13.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/occluder_set.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/culler/view.h"

namespace occlude::culler {

class ObjectTree;
class CoverOccluders;

/// Boxes around the objects, axis-aligned or oriented. The id of an object is its place in its span.
struct SceneObjects {
  std::span<const Box> statics = {};   ///< those that never move
  std::span<const Box> dynamics = {};  ///< the first boxes of those that do
};

/// How the occluders are prepared.
struct SceneConfig {
  OccluderSet::Config occluders = {};
  OccluderGrid::Config grid = {};
};

/// What to draw: the ids of objects, each once, in no order that means anything.
struct SceneResult {
  std::vector<std::uint32_t> statics, dynamics;
  /// The same static objects as runs of Scene::static_order(), neighbours merged: few calls to draw, for whom keeps them in
  /// that order. A range is of objects here.
  std::vector<PolygonRange> static_ranges;
};

/// One camera on one scene as it moves, and its last frame; as View, which it is made of.
class SceneView {
 public:
  [[nodiscard]] const SceneResult& result() const { return result_; }
  /// How the frame came about: half-spaces, occluders, statistics. Where CullResult counts polygons, here it counts objects.
  [[nodiscard]] const CullResult& frame() const { return view_.result(); }
  /// As View::visibility().
  [[nodiscard]] Visibility visibility(const Box& box) const { return view_.visibility(box); }

 private:
  friend class Scene;

  View view_;
  SceneResult result_;
};

/// **What culling promises.** An object is left out only if, in exact arithmetic (unless CullOptions::arithmetic is plain),
/// its box is beyond a plane of the view that is no tighter than the renderer's, or in the shadow of one chosen occluder
/// (with CullOptions::unions: of two together) and strictly beyond its near plane, or, by Method::cover, wholly behind
/// polygons of the occluders. So nothing visible is left out as long as
///  - boxes hold all that is drawn of their objects, and
///  - every point of an occluder is a point of something opaque, or inside of it, that stands still and is drawn unless it
///    belongs to an object that this scene leaves out.
/// An object whose box holds its occluder is never hidden by it: its box reaches the near plane.
///
/// **Occluders** are chosen each frame from the polygons of a soup, from flat convex regions that they make up and from
/// convex solids that they enclose (section 4). It may be the scene's own geometry, or a few polygons and solids made by
/// hand inside of it: "potential occluders" need not be the rendered geometry (4.1).
///
/// **Threads.** Const calls may run on several threads at once, each with a view of its own. update() must run alone.
class Scene {
 public:
  using Config = SceneConfig;

  /// Any of the three may be empty. Throws std::invalid_argument, with the place and the reason, for a soup
  /// that is not well formed (polygon_soup.h), for a vertex that is not legal and for a box that the kernel refuses, or, of
  /// an oriented one, the axis-aligned box around it. What `checkpoint` throws while the scene is prepared comes out. Throws
  /// std::runtime_error while the processor does not round to nearest (occlude/kernel/validity.h).
  Scene(const SceneObjects& objects, PolygonSoup occluders, const Config& config = {}, const Checkpoint& checkpoint = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// As Culler::prepare_cover().
  void prepare_cover(const Checkpoint& checkpoint = {}) const;

  /// What to draw for the next frame of this camera. After the first frame of a view nothing is allocated any more. Returns
  /// view.result(). A view that was used with another scene starts anew. Throws std::invalid_argument for a camera with a
  /// fault(), std::runtime_error while the processor does not round to nearest, and the view keeps its last frame.
  const SceneResult& cull(const Camera& camera, const CullOptions& options, SceneView& view) const;

  /// Where the object is from the next update() on; until then the scene is as it was. Threads may set different objects at
  /// once, and while others cull. Throws std::invalid_argument for a box as the constructor does, and for an id that does
  /// not exist, and changes nothing.
  void set_bounds(std::uint32_t dynamic, const Box& box);
  /// Moves the objects: once a frame, before it is culled. Linear in the number of dynamic objects, and now and then, when
  /// these lie otherwise than they did, n log n. Allocates nothing.
  void update();

  [[nodiscard]] std::size_t statics() const;
  [[nodiscard]] std::size_t dynamics() const;
  /// The ids of the static objects in the order in which SceneResult::static_ranges counts them.
  [[nodiscard]] std::span<const std::uint32_t> static_order() const;
  /// What may be an occluder, with the polygons of the soup: Occluder::index is one of these.
  [[nodiscard]] const OccluderSet& occluders() const { return occluders_; }

 private:
  Identity identity_;
  std::unique_ptr<ObjectTree> objects_;
  OccluderSet occluders_;
  std::unique_ptr<CoverOccluders> cover_;
};

}  // namespace occlude::culler
