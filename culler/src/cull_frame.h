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
#include "legal_soup.h"
#include "node_tests.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occluder_choice.h"
#include "view_memory.h"

namespace occlude::culler {

/// Throws std::invalid_argument for a camera with a fault(), std::runtime_error while the processor does not round to
/// nearest.
inline void require_sound(const Camera& camera) {
  require_rounding();
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
}

/// What all frames begin with: the half-spaces of the view, and an empty result. REQUIRES: require_sound(camera).
inline double begin_frame(std::span<const HierarchyNode> nodes, const Camera& camera, const CullOptions& options,
                          View::Memory& memory) {
  memory.begin_frame();
  const double reach = nodes.empty() ? 0 : depth(nodes[0].box, camera.eye);
  memory.eye = camera.eye;
  memory.reach = reach;
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

/// Is told of a frame by cover what it does, and wants nothing of it.
struct Unwatched {
  static void begin(const CoverFrame&) {}
  static void joined(const CoverFrame&) {}
  static void culled(const Culled&) {}
};

/// A model by cover: what is seen of it is what hides.
template <class Ask, class Watch = Unwatched>
void cull_by_cover(const CoverSource& source, const Ask& ask, const Camera& camera, const CullOptions& options,
                   View::Memory& memory, Watch&& watch = {}) {
  const double reach = begin_frame(source.nodes, camera, options, memory);
  CoverFrame frame(source, camera, reach, options, memory);
  watch.begin(frame);
  const auto see = [&](std::uint32_t leaf, const CoverBuffer::Footprint& footprint, bool is_worth_closing) {
    frame.see(leaf, footprint);
    if (is_worth_closing) frame.take(leaf);
  };
  const auto cull = [&](const Culled& culled) {
    watch.culled(culled);
    frame.cull(source.nodes, culled);
  };
  const auto join = [&] {
    if (frame.join()) watch.joined(frame);
  };
  frame.descend(source.nodes, ask, see, cull, join);
  frame.finish(source.nodes, cull);
}

/// Objects by cover: first what is seen of the occluders closes pixels, then the objects are asked.
template <class Ask>
void cull_by_cover(std::span<const HierarchyNode> nodes, const Ask& ask, const CoverSource& source, const Camera& camera,
                   const CullOptions& options, View::Memory& memory) {
  double reach = begin_frame(nodes, camera, options, memory);
  if (!source.nodes.empty()) reach = std::max(reach, depth(source.nodes[0].box, camera.eye));
  CoverFrame frame(source, camera, reach, options, memory);
  const auto ask_occluders = [&](std::uint32_t node, auto&& question) { return question(source.nodes[node].box); };
  const auto take = [&](std::uint32_t leaf, const CoverBuffer::Footprint&, bool is_worth_closing) {
    if (is_worth_closing) frame.take(leaf);
  };
  frame.descend(
      source.nodes, ask_occluders, take, [](const Culled&) {}, [&] { frame.join(); });
  const auto see = [&](std::uint32_t leaf, const CoverBuffer::Footprint& footprint, bool) { frame.see(leaf, footprint); };
  const auto cull = [&](const Culled& culled) { frame.cull(nodes, culled); };
  frame.descend(nodes, ask, see, cull, [] {});
  frame.finish(nodes, cull);
}

}  // namespace occlude::culler
