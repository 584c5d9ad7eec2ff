// SPDX-License-Identifier: MIT
// How a frame of a scene is asked for, and what comes of it. Reading order: 14.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/scene_id.h"
#include "occlude/culler/visibility.h"

namespace occlude::culler {

/// How a frame of a scene is culled.
struct SceneOptions {
  CoverOptions cover = {};
  /// As CullOptions::margin: what a renderer rounds, as a share of the picture's height. Nothing is hidden if it is negative
  /// or not a number.
  double margin = 0;
  /// Objects and occluders take part if their mask and this one have a bit in common.
  std::uint32_t mask = ~std::uint32_t{0};
  /// Objects that look smaller are left out (DrawnObject::size). They are counted in SceneStats::too_small, and nothing is
  /// said of their visibility.
  float least_size = 0;
  /// Whether the objects to draw are listed from front to back. This takes time n log n.
  bool is_front_to_back = false;
  /// On which threads the objects are tested; nullptr: on the calling thread. Occluders are drawn on the calling thread. The
  /// result is the same, to the order of the list. What it throws is thrown on, and all objects that take part are drawn
  /// then.
  const Executor* executor = nullptr;
};

/// An object to draw, and how it looks.
struct DrawnObject {
  ObjectId id;
  /// No less than the height and the width of its box in the picture, as a share of the picture's height: what a level of
  /// detail depends on. Infinity for a box that reaches before the near plane, and for one that is always drawn.
  float size;
  /// About the square of the distance from the eye to its box, or how far along the line of sight the box begins if rays
  /// are parallel. -infinity for what is always drawn.
  float distance;
};

struct SceneStats {
  std::size_t drawn = 0;        ///< objects to draw
  std::size_t out_of_view = 0;  ///< beyond a plane of the view
  std::size_t hidden = 0;       ///< behind occluders
  std::size_t too_small = 0;    ///< smaller than SceneOptions::least_size
  std::size_t occluders = 0;    ///< of which at least a part was drawn into the coarse picture
  CullStats work;               ///< what the descents did
};

/// The result of one frame. Each object whose mask has a bit of SceneOptions::mask is in `drawn` exactly once, or is counted
/// in exactly one of the three numbers that follow it in SceneStats.
struct SceneResult {
  std::vector<DrawnObject> drawn;  ///< in an order that means nothing, unless SceneOptions::is_front_to_back
  std::vector<HalfSpace> view;     ///< as append_view_frustum() has them
  SceneStats stats;
};

/// What became of an object in a frame, and why.
struct ObjectFate {
  enum class Reason {
    drawn,
    always_drawn,  ///< it has no place, or ObjectOptions::is_always_drawn
    out_of_view,   ///< its box is beyond SceneResult::view[plane]
    hidden,        ///< `by` hide its box
    too_small,     ///< it looks smaller than SceneOptions::least_size
    in_no_layer,   ///< it is disabled, or has no bit of SceneOptions::mask
    not_in_scene,  ///< there was no such object at the last update
  };
  /// A polygon that hides.
  struct Hiding {
    OccluderId occluder;
    std::uint32_t polygon = 0;          ///< its number in the soup of the occluder's mesh
    std::vector<kernel::Vec3> corners;  ///< where they are in the scene
  };

  Reason reason = Reason::not_in_scene;
  std::uint32_t plane = 0;
  std::vector<Hiding> by = {};  ///< each once; together they hide the box, beyond the near plane of the camera
};

/// The proof of a cull.
struct ObjectWitness {
  ObjectId object;
  /// All of it is hidden, or out of view. Holds the box of the object: it is that box, or the axis-aligned one around it.
  Box box;
  ObjectFate fate;  ///< hidden or out_of_view
};

/// One camera, and its last frame.
/// 1. One thread at a time may cull with it. Different views may be culled at once.
/// 2. It may be used with any scene at any time. A frame does not depend on those before it.
/// 3. After its first frame nothing more is allocated. Exceptions: culler/README.md, Budgets.
/// 4. A view that was moved from may only be destroyed or assigned to.
class SceneView {
 public:
  SceneView();
  ~SceneView();
  SceneView(SceneView&&) noexcept;
  SceneView& operator=(SceneView&&) noexcept;

  /// The last frame; empty before the first. Valid until the next frame of this view.
  [[nodiscard]] const SceneResult& result() const;
  /// Whether any box would be visible in the last frame, as View::visibility().
  [[nodiscard]] Visibility visibility(const Box& box) const;

  /// For scenes only: src/scene_frame.h. Not protected by `const`.
  struct Memory;
  [[nodiscard]] Memory& memory() const { return *memory_; }

 private:
  std::unique_ptr<Memory> memory_;
};

}  // namespace occlude::culler
