// SPDX-License-Identifier: MIT
// Culls that are made now and then, and hold for the frames between them. Reading order: 12.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/culler/scene.h"

namespace occlude::culler {

/// Runs a task on another thread, now or later, and returns at once: a job system. A task takes milliseconds. It may also be
/// run at once on the calling thread, or never.
using Later = std::function<void(std::function<void()> task)>;

/// When and where regions are culled.
struct HeldOptions {
  /// How far the eye may leave its way, at least, and the camera turn, at least.
  AheadOptions way = {.turn_degrees = 2};
  /// Where regions are culled while frames are drawn. Empty: on the calling thread, when one is needed.
  Later later = {};
  /// Whether the same cameras, at the same times, always give the same results: the next frame waits for a region that is
  /// being culled, and culls it itself if that has not begun.
  bool is_repeatable = false;
};

/// What became of the frames so far.
struct HeldStats {
  std::size_t frames = 0;
  std::size_t of_point = 0;  ///< frames that were culled for their own eye alone
  std::size_t regions = 0;   ///< culled for regions, whether or not a frame used them
  std::size_t around = 0;    ///< of these, for all directions
  std::size_t late = 0;      ///< regions that held no longer when they were there
};

/// What to draw in a frame.
struct HeldResult {
  std::vector<PolygonRange> drawn;  ///< of Hierarchy::soup(), in the order of the leaves, neighbours merged
  std::size_t drawn_polygons = 0;
  bool is_of_point = false;  ///< culled for this frame alone
};

/// Culls a model for one camera that moves, as frames by point do, at a small part of their time.
/// 1. A frame draws all that its camera shows: what is drawn of it in a cull of a region that holds for the camera, as
///    View::holds_for(), and that is not beyond a plane of its view. No occlusion is decided in such a frame.
/// 2. While one region holds, the next is culled by options.later, for where the eye will be then. Of each model and camera
///    one region at most is being culled.
/// 3. A frame for which no region holds is culled for itself, as by Culler::cull(): the first ones, one after a jump, and
///    those for which the next region comes too late.
/// 4. Regions are as long as the eye takes for them what the last ones were worth. They become shorter where they hide less
///    than a frame by point would, and where the eye leaves them early. While the camera turns fast, six pictures hold for
///    all directions. Where even short ones hide less than half of what a frame by point does, or hold for so few frames
///    that they cost more, frames are culled by point, and a region is tried again now and then.
/// 5. None of this can make a frame wrong. Only with is_repeatable is it the same each time.
/// 6. One thread at a time may use it. It may be moved while a region is being culled. The destructor and repeatable frames
///    wait for a task that is running; one that has not begun never touches the culler.
class HeldCull {
 public:
  /// `cull` is of all culls: its margin is a share of the height of the picture of the cameras that are culled for, and its
  /// executor does frames by point. REQUIRES: the culler and that executor outlive this. Throws std::invalid_argument for an
  /// options.way that ahead() refuses.
  explicit HeldCull(const Culler& culler, HeldOptions options = {}, const CullOptions& cull = {});
  ~HeldCull();
  HeldCull(HeldCull&&) noexcept;
  HeldCull& operator=(HeldCull&&) noexcept;

  /// What to draw for the next frame, at this time: seconds by any clock, from which speeds are found. The result is valid
  /// until the next frame. Throws as Culler::cull(), std::invalid_argument for a time that is not finite, and what
  /// options.later throws.
  const HeldResult& cull(const Camera& camera, double seconds);
  const HeldResult& cull(const MatrixCamera& camera, double seconds);

  [[nodiscard]] const HeldStats& stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for a scene, with what differs:
/// 1. A frame is one that is held against the region's (Scene::cull() with `held`): each object is asked in each frame where
///    it is then, so that objects may come, go and move. Occluders that move (OccluderOptions::moves) hide in frames by
///    point alone. Where one that stands still is changed, regions that were culled before hold no longer, as Scene::holds()
///    says; new ones hide in the next region.
/// 2. Scene::update() waits while a region is being culled, as long as a few frames take.
/// 3. While the camera turns fast, frames are culled by point.
class HeldSceneCull {
 public:
  /// `cull` is of all culls; its executor does frames, not regions. REQUIRES: the scene and that executor outlive this, and
  /// the scene is not moved. Throws as the constructor of HeldCull.
  explicit HeldSceneCull(const Scene& scene, HeldOptions options = {}, const SceneOptions& cull = {});
  ~HeldSceneCull();
  HeldSceneCull(HeldSceneCull&&) noexcept;
  HeldSceneCull& operator=(HeldSceneCull&&) noexcept;

  /// As HeldCull::cull(). Throws as that and as Scene::cull().
  const SceneResult& cull(const Camera& camera, double seconds);
  const SceneResult& cull(const MatrixCamera& camera, double seconds);

  /// Whether the last frame was culled for itself alone.
  [[nodiscard]] bool is_of_point() const;
  [[nodiscard]] const HeldStats& stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace occlude::culler
