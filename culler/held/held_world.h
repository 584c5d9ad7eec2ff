// SPDX-License-Identifier: MIT
// A scene, as frames of it are held.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "held/held_frames.h"
#include "occlude/culler/held_cull.h"
#include "occlude/culler/scene.h"
#include "scene/scene_access.h"

namespace occlude::culler {

/// For HeldFrames.
class HeldWorld {
 public:
  using Region = SceneView;
  static constexpr bool kAround = false;

  HeldWorld(const Scene& scene, const SceneOptions& options) : scene_(scene), options_(options) {}

  [[nodiscard]] static double depth(const glm::dvec3&) { return 0; }
  template <class AnyCamera>
  [[nodiscard]] bool holds(const SceneView& region, const AnyCamera& camera) const {
    return scene_.holds(region, camera, options_);
  }

  void cull(SceneView& region, std::span<const Camera> cameras, double stretch) {
    const auto lock = SceneAccess::keep_from_updates(scene_);
    SceneOptions options = beside();
    options.is_to_be_held = true;
    options.margin *= stretch;
    scene_.cull(cameras[0], options, region);
  }
  ComparedRegion compare(const SceneView& region, const Camera& camera) {
    const auto lock = SceneAccess::keep_from_updates(scene_);
    const double ms = milliseconds([&] { scene_.cull(camera, beside(), view_compared_); });
    const auto hidden = static_cast<double>(view_compared_.result().stats.hidden);
    if (hidden == 0 || !holds(region, camera)) return {1, ms};
    scene_.cull(camera, beside(), region, view_compared_);
    return {static_cast<double>(view_compared_.result().stats.hidden) / hidden, ms};
  }

  template <class AnyCamera>
  void list(const SceneView& region, const AnyCamera& camera) {
    result_ = &scene_.cull(camera, options_, region, view_);
    is_of_point_ = false;
  }
  template <class AnyCamera>
  void cull_by_point(const AnyCamera& camera) {
    result_ = &scene_.cull(camera, options_, view_);
    is_of_point_ = true;
  }

  [[nodiscard]] const SceneResult& result() const { return *result_; }
  [[nodiscard]] bool is_of_point() const { return is_of_point_; }

 private:
  /// The options of what is culled on another thread: the executor is for the caller's.
  [[nodiscard]] SceneOptions beside() const {
    SceneOptions options = options_;
    options.executor = nullptr;
    return options;
  }

  const Scene& scene_;
  SceneOptions options_;
  const SceneResult* result_ = nullptr;
  bool is_of_point_ = false;
  SceneView view_, view_compared_;
};

}  // namespace occlude::culler
