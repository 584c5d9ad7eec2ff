// SPDX-License-Identifier: MIT
// A model, as frames of it are held.
#pragma once

#include <span>
#include <vector>

#include "camera/frame_view.h"
#include "camera/sound_camera.h"
#include "held/held_frames.h"
#include "held/held_region.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/held_cull.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

inline void to_planes(std::span<const HalfSpace> view, std::vector<kernel::HalfSpace>& planes) {
  planes.clear();
  for (const HalfSpace& h : view) planes.push_back({to_kernel(h.normal), h.offset});
}

/// A model, for HeldFrames.
class HeldModel {
 public:
  using Region = HeldRegion;
  static constexpr bool kAround = true;

  HeldModel(const Culler& culler, const CullOptions& options) : culler_(culler), options_(options) {}

  [[nodiscard]] double depth(const glm::dvec3& eye) const { return culler::depth(culler_.hierarchy().nodes()[0].box, eye); }
  template <class AnyCamera>
  [[nodiscard]] bool holds(const HeldRegion& region, const AnyCamera& camera) const {
    return region.holds_for(camera);
  }

  void cull(HeldRegion& region, std::span<const Camera> cameras, double stretch) {
    CullOptions options = beside();
    options.margin *= stretch;
    region.cull(culler_, cameras, options, view_of_regions_);
  }
  ComparedRegion compare(const HeldRegion& region, const Camera& camera) {
    const double ms = milliseconds([&] { culler_.cull(camera, beside(), view_compared_); });
    const CullResult& frame = view_compared_.result();
    std::vector<kernel::HalfSpace> planes;
    to_planes(frame.view, planes);
    HeldResult drawn;
    region.leaves().list(planes, drawn);
    const double hidden = static_cast<double>(frame.stats.shadow_culled_polygons);
    const double more = static_cast<double>(drawn.drawn_polygons) - static_cast<double>(frame.stats.drawn_polygons);
    return {hidden > 0 ? 1 - more / hidden : 1, ms};
  }

  /// What is held, culled by the view.
  template <class AnyCamera>
  void list(const HeldRegion& region, const AnyCamera& camera) {
    const FrameView view(camera, depth(eye_of(camera)));
    to_planes(std::span(view.half_spaces).first(view.half_space_count), planes_);
    region.leaves().list(planes_, result_);
    result_.is_of_point = false;
  }
  template <class AnyCamera>
  void cull_by_point(const AnyCamera& camera) {
    const CullResult& frame = culler_.cull(camera, options_, view_by_point_);
    result_.drawn.assign(frame.drawn.begin(), frame.drawn.end());
    result_.drawn_polygons = frame.stats.drawn_polygons;
    result_.is_of_point = true;
  }

  [[nodiscard]] const HeldResult& result() const { return result_; }
  /// Of the last camera of the region that was culled last, and of the last frame by point: what they cull, too.
  [[nodiscard]] const CullResult& frame_of_region() const { return view_of_regions_.result(); }
  [[nodiscard]] const CullResult& frame_by_point() const { return view_by_point_.result(); }

 private:
  /// The options of what is culled on another thread: the executor is for the caller's.
  [[nodiscard]] CullOptions beside() const {
    CullOptions options = options_;
    options.executor = nullptr;
    return options;
  }

  const Culler& culler_;
  CullOptions options_;
  HeldResult result_;
  std::vector<kernel::HalfSpace> planes_;
  View view_by_point_, view_of_regions_, view_compared_;
};

}  // namespace occlude::culler
