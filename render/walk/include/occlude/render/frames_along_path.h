// SPDX-License-Identifier: MIT
// The frames of a walk, one after the other: each is culled for its own eye or, if the walk holds, for a region of eyes.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/view_along_path.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// A cull, and for what it was made.
struct CulledFor {
  culler::Camera camera;
  culler::CullOptions options;
  const culler::CullResult& result;
};

class HeldAlongPath;  // held_along_path.h

class FramesAlongPath {
 public:
  /// Starts at the walk's first frame. All arguments must outlive this object.
  FramesAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk);
  ~FramesAlongPath();

  /// Goes to a frame. Culls those before it on which it depends. REQUIRES: a frame after that of the last call. Throws
  /// Interrupted on Ctrl-C.
  void go_to(std::size_t frame);
  /// Culls the frame, as a program does that draws it.
  void cull();

  // Of the frame that was culled last:

  /// What it draws and what it culls. Of a frame that is held: what the region culls, and what the frame's own view does, as
  /// the cull of the outermost subtrees. Its half-spaces are those of the frame, and after them those of the region.
  [[nodiscard]] const culler::CullResult& result();
  /// The cull that tells what is hidden: the frame's own, or that of the region.
  [[nodiscard]] CulledFor source() const;
  /// The number of the region that held for it, from 1; 0: it was culled for itself.
  [[nodiscard]] std::size_t region() const;

  /// The regions so far.
  [[nodiscard]] std::span<const RegionRecord> regions() const;
  /// Whether the culling of a frame depends on the frames before it.
  [[nodiscard]] bool has_past() const { return held_ || along_.has_past(); }

 private:
  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& walk_;
  std::size_t frame_, next_;
  ViewAlongPath along_;                  ///< of a walk that does not hold
  culler::View* view_ = nullptr;         ///< of the frame
  std::unique_ptr<HeldAlongPath> held_;  ///< null unless the walk holds
};

}  // namespace occlude::render
