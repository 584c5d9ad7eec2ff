// SPDX-License-Identifier: MIT
// A view that moves along a path, including the frames that a walk does not count.
#pragma once

#include <cstddef>

#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// But by cover, the culling of a frame depends on the frames before it. This class gives a frame the same history for
/// every step of a walk.
class ViewAlongPath {
 public:
  /// Starts at the walk's first frame and culls with `cull`. All arguments must outlive this object.
  ViewAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk,
                const culler::CullOptions& cull)
      : culler_(culler), path_(path), walk_(walk), cull_(cull), next_(walk.begin) {}

  /// The view before `frame`, which the caller then culls. Culls the skipped frames first, if it has_past(). REQUIRES: a
  /// frame after that of the last call. Throws Interrupted on Ctrl-C.
  [[nodiscard]] culler::View& before(std::size_t frame);
  [[nodiscard]] const culler::View& view() const { return view_; }
  /// Whether the culling of a frame depends on the frames before it.
  [[nodiscard]] bool has_past() const {
    return cull_.method == culler::Method::automatic || (cull_.method == culler::Method::frusta && cull_.occluders > 0);
  }

 private:
  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& walk_;
  const culler::CullOptions& cull_;
  std::size_t next_;
  culler::View view_;
};

}  // namespace occlude::render
