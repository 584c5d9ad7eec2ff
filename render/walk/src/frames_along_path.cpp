// SPDX-License-Identifier: MIT
#include "occlude/render/frames_along_path.h"

#include "held_along_path.h"
#include "occlude/render/interrupt.h"

namespace occlude::render {

FramesAlongPath::FramesAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk)
    : culler_(culler),
      path_(path),
      walk_(walk),
      frame_(walk.begin),
      next_(walk.begin),
      along_(culler, path, walk, walk.cull),
      held_(walk.hold > 0 ? std::make_unique<HeldAlongPath>(culler, path, walk) : nullptr) {}
FramesAlongPath::~FramesAlongPath() = default;

void FramesAlongPath::go_to(std::size_t frame) {
  if (held_) {
    for (; next_ < frame; ++next_) {
      check_interrupt();
      held_->cull(next_);
    }
  } else {
    view_ = &along_.before(frame);
  }
  frame_ = frame;
  next_ = frame + 1;
}

void FramesAlongPath::cull() {
  if (held_) return held_->cull(frame_);
  culler_.cull(path_.camera(frame_, aspect(walk_)), walk_.cull, *view_);
}

const culler::CullResult& FramesAlongPath::result() { return held_ ? held_->result() : view_->result(); }

CulledFor FramesAlongPath::source() const {
  if (held_) return held_->source();
  return {path_.camera(frame_, aspect(walk_)), walk_.cull, view_->result()};
}

std::size_t FramesAlongPath::region() const { return held_ ? held_->region() : 0; }

std::span<const RegionRecord> FramesAlongPath::regions() const {
  return held_ ? std::span<const RegionRecord>(held_->regions()) : std::span<const RegionRecord>();
}

}  // namespace occlude::render
