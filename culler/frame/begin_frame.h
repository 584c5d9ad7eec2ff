// SPDX-License-Identifier: MIT
// The start of a frame of a model, whatever the method. Reading order: 11.
#pragma once

#include "camera/sound_camera.h"
#include "frame/view_memory.h"
#include "model/bounds.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// Empties the result and makes the half-spaces of the view. REQUIRES: require_sound(camera).
template <class AnyCamera>
void begin_frame(const Hierarchy& hierarchy, const AnyCamera& camera, const CullOptions& options, View::Memory& memory) {
  Frame& frame = memory.frame;
  memory.frusta.keep_spare(frame.result);
  frame.begin(hierarchy.nodes().size());
  const double reach = depth(hierarchy.nodes()[0].box, eye_of(camera));
  frame.view = FrameView(camera, reach);
  frame.view.append_half_spaces(frame.result.view);
  frame.margin = ShadowMargin(frame.view, options.margin);
  memory.idle.begin(options.cover);
}

}  // namespace occlude::culler
