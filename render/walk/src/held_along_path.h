// SPDX-License-Identifier: MIT
// Frames of a walk that are held: a region of eyes ahead is culled when the one before does not do for a frame any more.
// Nothing depends on time, so that a walk can be repeated.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "held/held_model.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/frames_along_path.h"
#include "occlude/render/walk.h"

namespace occlude::render {

class HeldAlongPath {
 public:
  /// All arguments must outlive this object.
  HeldAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk);

  /// Culls a frame. REQUIRES: all frames of the walk before it were culled.
  void cull(std::size_t frame);

  // As those of FramesAlongPath.

  [[nodiscard]] const culler::CullResult& result();
  [[nodiscard]] CulledFor source() const;
  [[nodiscard]] std::size_t region() const { return is_of_point_ ? 0 : regions_.size(); }
  [[nodiscard]] const std::vector<RegionRecord>& regions() const { return regions_; }

 private:
  void start_region(std::size_t frame);
  [[nodiscard]] glm::dvec3 way_from(std::size_t frame) const;

  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& walk_;
  culler::HeldModel model_;
  culler::HeldRegion region_;
  culler::Camera camera_, camera_of_region_;
  culler::CullOptions options_of_region_;
  std::vector<RegionRecord> regions_;
  bool is_of_point_ = false, is_new_ = false;  ///< the frame, and its region
  bool is_told_ = false;                       ///< whether `result_` is that of the frame
  culler::CullResult result_;
  culler::View view_alone_;
};

/// What is culled by the frame's own view, or else by the region: the outermost subtrees of both. REQUIRES: both are of this
/// tree.
[[nodiscard]] culler::CullResult joined(const culler::Hierarchy& hierarchy, const culler::CullResult& own,
                                        const culler::CullResult& region);

}  // namespace occlude::render
