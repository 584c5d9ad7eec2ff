// SPDX-License-Identifier: MIT
// A view that goes along a path, through the frames that a walk leaves out as well.
#pragma once

#include <cstddef>

#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// By frusta, what a frame culls depends on the frames before it. So a frame has the same past whatever the step of a walk
/// is.
class ViewAlongPath {
 public:
  /// From the walk's first frame on, culled with `cull`. All of these must outlive this.
  ViewAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk,
                const culler::CullOptions& cull)
      : culler_(culler), path_(path), walk_(walk), cull_(cull), next_(walk.begin) {}

  /// The view as the frame finds it, for the caller to cull it: frames before it that were left out are culled now. By
  /// cover, or without occluders, none is, for no frame has a past there. REQUIRES: a frame after that of the last call.
  /// Throws Interrupted on Ctrl-C.
  [[nodiscard]] culler::View& before(std::size_t frame);
  [[nodiscard]] const culler::View& view() const { return view_; }

 private:
  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& walk_;
  const culler::CullOptions& cull_;
  std::size_t next_;
  culler::View view_;
};

}  // namespace occlude::render
