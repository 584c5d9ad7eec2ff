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

/// Boxes around the objects, axis-aligned or oriented. The id of an object is its index in its span. The boxes are copied.
struct SceneObjects {
  std::span<const Box> statics = {};   ///< those that never move
  std::span<const Box> dynamics = {};  ///< the first boxes of those that do
};

/// How the occluders are prepared.
struct SceneConfig {
  OccluderSet::Config occluders = {};
  OccluderLists::Config lists = {};  ///< the nodes of Partition::Kind::tree are those of the static objects
};

/// What to draw: the ids of objects, each once, in no order that means anything.
struct SceneResult {
  std::vector<std::uint32_t> statics, dynamics;
  /// The same static objects as ranges of Scene::static_order(), neighbours merged: few draw calls, if the renderer keeps
  /// its objects in that order. These are ranges of objects, not of polygons.
  std::vector<PolygonRange> static_ranges;
};

/// One camera as it moves through one scene, and its last frame. Its contract is that of View.
class SceneView {
 public:
  [[nodiscard]] const SceneResult& result() const { return result_; }
  /// The details of the frame: half-spaces, occluders, statistics. Where CullResult says polygons, here it is objects:
  /// places in the tree of all objects, not ids.
  [[nodiscard]] const CullResult& frame() const { return view_.result(); }
  /// As View::visibility().
  [[nodiscard]] Visibility visibility(const Box& box) const { return view_.visibility(box); }

 private:
  friend class Scene;

  View view_;
  SceneResult result_;
};

/// **What culling promises.** An object is left out only if one of these holds of its box, in exact arithmetic (unless
/// CullOptions::arithmetic is plain):
/// 1. it is beyond a plane of the view, which is no tighter than the renderer's;
/// 2. it is in the shadow of one chosen occluder, or with CullOptions::unions of two together, and strictly beyond the near
///    plane;
/// 3. by Method::cover: it is wholly behind polygons of the occluders.
/// So nothing visible is left out if
/// 1. each box holds everything that is drawn of its object, and
/// 2. every point of an occluder is on or inside something opaque that stands still, and that is drawn unless it belongs to
///    an object that this scene leaves out.
/// An object whose box holds an occluder is never hidden by that occluder: the box reaches the near plane.
///
/// **Occluders** are chosen each frame from the polygons of a soup, from flat convex regions that they make up and from
/// convex solids that they enclose (section 4). The soup may be the scene's own geometry, or a few polygons and solids made
/// by hand inside it: "potential occluders" need not be the rendered geometry (4.1).
///
/// **Threads.** Const calls may run on several threads at once, each with a view of its own. update() must run alone.
///
/// A scene that was moved from may only be destroyed or assigned to.
class Scene {
 public:
  using Config = SceneConfig;

  /// Statics, dynamics and occluders may each be empty. Throws
  /// 1. std::invalid_argument, with the place and the reason, for a soup that is not well formed (polygon_soup.h), for a
  ///    vertex that is not legal, for a box that is not legal, for an oriented box whose axis-aligned bounding box is not
  ///    legal, and for a config.lists out of range;
  /// 2. std::runtime_error while the processor does not round to nearest (occlude/kernel/validity.h);
  /// 3. what `checkpoint` throws.
  Scene(const SceneObjects& objects, PolygonSoup occluders, const Config& config = {}, const Checkpoint& checkpoint = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// As Culler::prepare_cover().
  void prepare_cover(const Checkpoint& checkpoint = {}) const;

  /// What to draw for the next frame of this camera. Returns view.result(), valid until the next frame of the view. A view
  /// that was used with another scene starts anew. After the first frame of a view nothing more is allocated; exceptions:
  /// README.md, Growth and budgets. Throws std::invalid_argument for a camera with a fault(), and std::runtime_error while
  /// the processor does not round to nearest; the view then keeps its last frame.
  const SceneResult& cull(const Camera& camera, const CullOptions& options, SceneView& view) const;

  /// Sets the box that a dynamic object has from the next update() on; until then the scene is unchanged. Several threads
  /// may set different objects at once, also while others cull. Allocates nothing. Throws std::invalid_argument for a box as
  /// the constructor does, and for an id that does not exist; it then changes nothing.
  void set_bounds(std::uint32_t dynamic, const Box& box);
  /// Moves the dynamic objects to the boxes that were set. Call it once a frame, before culling; nothing else may run
  /// meanwhile. Takes time linear in the number n of dynamic objects, and n log n when their tree has become loose and is
  /// rebuilt. Allocates nothing.
  void update();

  [[nodiscard]] std::size_t statics() const;
  [[nodiscard]] std::size_t dynamics() const;
  /// The ids of the static objects in the order that SceneResult::static_ranges refers to. It never changes.
  [[nodiscard]] std::span<const std::uint32_t> static_order() const;
  /// The potential occluders, with the soup that they are made of. Occluder::index is an index in this set.
  [[nodiscard]] const OccluderSet& occluders() const { return occluders_; }

 private:
  Identity identity_;
  std::unique_ptr<ObjectTree> objects_;
  OccluderSet occluders_;
  std::unique_ptr<CoverOccluders> cover_;
};

}  // namespace occlude::culler
