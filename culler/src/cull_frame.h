// SPDX-License-Identifier: MIT
// A frame from the camera to what is drawn, by both methods.
//
//   frusta: half-spaces, a few chosen occluders, one descent of the tree, what to remember for the next frame.
//   cover:  half-spaces, one descent of the tree from front to back, in which what is seen closes pixels.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stdexcept>
#include <string>

#include "bounds.h"
#include "cover_frame.h"
#include "cover_pieces.h"
#include "node_tests.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occluder_choice.h"
#include "view_memory.h"

namespace occlude::culler {

/// What all frames begin with: the half-spaces of the view, and an empty result. Throws std::invalid_argument for a camera
/// with a fault(), and leaves the last frame as it was.
inline double begin_frame(std::span<const HierarchyNode> nodes, const Camera& camera, const CullOptions& options,
                          View::Memory& memory) {
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
  memory.begin_frame();
  const double reach = nodes.empty() ? 0 : depth(nodes[0].box, camera.eye);
  append_view_frustum(camera, reach, memory.result.view);
  memory.result.method = Method::frusta;
  memory.result.margin = ShadowMargin(camera, options.margin, reach);
  return reach;
}

/// By frusta. `ask` and `holds_part` as in NodeTests; of no nodes nothing is drawn.
template <class Ask, class HoldsPart>
void cull_by_frusta(std::span<const HierarchyNode> nodes, const Ask& ask, const HoldsPart& holds_part,
                    const OccluderSource& source, const Camera& camera, const CullOptions& options, View::Memory& memory) {
  const double reach = begin_frame(nodes, camera, options, memory);
  choose_occluders(source, camera, reach, options, memory);
  const auto unwatched = [](const Occluder&, const auto&) {};
  if (!nodes.empty()) traverse(nodes, ask, holds_part, unwatched, options, memory);
  memory.history.record(source.occluders.size(), memory.result.occluders, memory.probes);
}

/// A model by cover: what is seen of it is what hides.
template <class Ask>
void cull_by_cover(std::span<const HierarchyNode> nodes, const Ask& ask, const CoverPieces& meshes, const Camera& camera,
                   const CullOptions& options, View::Memory& memory) {
  const double reach = begin_frame(nodes, camera, options, memory);
  CoverFrame frame(meshes, camera, reach, options, memory);
  const auto see = [&](std::uint32_t leaf) {
    frame.see(leaf);
    frame.close(nodes[leaf]);
  };
  frame.descend(nodes, ask, see, [&](const Culled& culled) { frame.cull(nodes, culled); });
  frame.finish(nodes);
}

/// Objects by cover: first what is seen of the occluders closes pixels, then the objects are asked.
template <class Ask>
void cull_by_cover(std::span<const HierarchyNode> nodes, const Ask& ask, std::span<const HierarchyNode> occluders,
                   const CoverPieces& meshes, const Camera& camera, const CullOptions& options, View::Memory& memory) {
  double reach = begin_frame(nodes, camera, options, memory);
  if (!occluders.empty()) reach = std::max(reach, depth(occluders[0].box, camera.eye));
  CoverFrame frame(meshes, camera, reach, options, memory);
  const auto ask_occluders = [&](std::uint32_t node, auto&& question) { return question(occluders[node].box); };
  const auto close = [&](std::uint32_t leaf) { frame.close(occluders[leaf]); };
  frame.descend(occluders, ask_occluders, close, [](const Culled&) {});
  const auto see = [&](std::uint32_t leaf) { frame.see(leaf); };
  frame.descend(nodes, ask, see, [&](const Culled& culled) { frame.cull(nodes, culled); });
  frame.finish(nodes);
}

}  // namespace occlude::culler
