// SPDX-License-Identifier: MIT
// The frames of a walk: each is culled by both methods, drawn and compared.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/render/frames_along_path.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/scene_renderer.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// The OpenGL context and its renderer; both null if the walk does not render.
struct Drawing {
  Drawing(const culler::Culler& culler, const WalkOptions& options);

  /// The driver's own name for itself; empty without a context.
  [[nodiscard]] std::string description() const { return context ? context->description() : ""; }

  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<SceneRenderer> renderer;
};

/// A frame with its figures.
struct FinishedFrame {
  const FrameRecord& record;
  const culler::CullResult& culled;
  const CulledFor& source;                    ///< as FramesAlongPath::source()
  const std::vector<std::uint32_t>* visible;  ///< polygons with a pixel, ascending; null if nothing is drawn
  bool is_reference;
};
/// Called after each frame.
using OnFrame = std::function<void(const FinishedFrame& frame)>;

/// Culls, draws (if there is a renderer) and compares the frames that the options select. Fills everything of the
/// result except witnesses, operations and the time of the preprocess. Shows progress. Throws InputError if there is no such
/// frame, Interrupted on Ctrl-C.
[[nodiscard]] WalkResult walk_frames(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                                     const Drawing& drawing, const OnFrame& on_frame = {});

}  // namespace occlude::render
