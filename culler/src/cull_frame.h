// SPDX-License-Identifier: MIT
// A frame from the camera to what is drawn: half-spaces, occluders, one descent of the tree, what to remember.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stdexcept>
#include <string>

#include "bounds.h"
#include "node_tests.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occluder_choice.h"
#include "view_memory.h"

namespace occlude::culler {

/// Fills memory.result. `ask` and `holds_part` as in NodeTests; of no nodes nothing is drawn. Throws
/// std::invalid_argument for a camera with a fault(), and leaves the last frame as it was.
template <class Ask, class HoldsPart>
void cull_frame(std::span<const HierarchyNode> nodes, const Ask& ask, const HoldsPart& holds_part,
                const OccluderSource& source, const Camera& camera, const CullOptions& options, View::Memory& memory) {
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
  memory.begin_frame();
  const double reach = nodes.empty() ? 0 : depth(nodes[0].box, camera.eye);
  append_view_frustum(camera, reach, memory.result.view);
  memory.result.margin = ShadowMargin(camera, options.margin, reach);
  choose_occluders(source, camera, reach, options, memory);
  const auto unwatched = [](const Occluder&, const auto&) {};
  if (!nodes.empty()) traverse(nodes, ask, holds_part, unwatched, options, memory);
  memory.history.record(source.occluders.size(), memory.result.occluders, memory.probes);
}

}  // namespace occlude::culler
