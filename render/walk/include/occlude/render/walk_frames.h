// SPDX-License-Identifier: MIT
// The frames of a walk: each culled by both methods, drawn and compared.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "occlude/culler/culler.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/scene_renderer.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// The context and what draws in it; nothing when the walk does not render.
struct Stage {
  Stage(const culler::Culler& culler, const WalkOptions& options);

  /// As the driver names itself; empty without one.
  [[nodiscard]] std::string description() const { return context ? context->description() : ""; }

  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<SceneRenderer> renderer;
};

/// Called after each frame: what was measured, what culling left, and whether it is one of the few of which more is asked.
using OnFrame = std::function<void(const FrameRecord& record, const culler::CullResult& culled, bool is_reference)>;

/// Culls, draws (where the stage has a renderer) and compares the frames of the path that the options name: all of the
/// result but what is written of it, what on_frame may count, and the time of the preprocess. Shows its progress. Throws
/// InputError when there is no such frame, Interrupted on Ctrl-C.
[[nodiscard]] WalkResult walk_frames(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                                     const Stage& stage, const OnFrame& on_frame = {});

}  // namespace occlude::render
