// SPDX-License-Identifier: MIT
// A frame from the camera to what is drawn, from top to bottom, by both methods. Reading order: 12.
//
//   frusta: half-spaces, a few chosen occluders (4.2), one descent of the tree (5), what to remember for the next frame.
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
#include "frame_view.h"
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

/// What all frames begin with: an empty result, and the half-spaces of the view. `depth` as depth() of what is drawn.
/// REQUIRES: require_sound(camera).
inline const FrameView& begin_frame(std::span<const HierarchyNode> nodes, double depth, const Camera& camera,
                                    const CullOptions& options, View::Memory& memory) {
  memory.begin_frame(nodes.size());
  memory.view = FrameView(camera, depth);
  memory.view.append_half_spaces(memory.result.view);
  memory.result.method = Method::frusta;
  memory.result.margin = ShadowMargin(memory.view, options.margin);
  return memory.view;
}

/// As depth() of all below the root; 0 of no nodes.
inline double depth(std::span<const HierarchyNode> nodes, const Camera& camera) {
  return nodes.empty() ? 0 : depth(nodes[0].box, camera.eye);
}

/// By frusta, as the paper has it. `ask` and `holds_part` as in NodeTests; of no nodes nothing is drawn.
template <class Ask, class HoldsPart>
void cull_by_frusta(std::span<const HierarchyNode> nodes, const Ask& ask, const HoldsPart& holds_part,
                    const OccluderSet& occluders, const Camera& camera, const CullOptions& options, View::Memory& memory) {
  const FrameView& view = begin_frame(nodes, depth(nodes, camera), camera, options, memory);

  // Section 4.2: of the list of the eye's region what is in view, sorted by the objective; the best n_occ, each with its
  // shadow frustum. First comes what hid something in the frames before (4, criterion 3).
  if (options.occluders > 0) {
    OccluderChoice choice(occluders, view, options, memory);
    const bool is_coherent = options.objective.coherence != 0;
    choice.sort_candidates();
    if (is_coherent) choice.take_proven();
    if (is_coherent) choice.take_untried();
    choice.take_best();
    if (is_coherent) choice.take_probes();
    if (options.unions) choice.pair_neighbours();
  }

  // Section 5: one descent of the tree culls by the half-spaces and by the shadows, and draws.
  const auto unwatched = [](const Occluder&, const auto&) {};
  if (!nodes.empty()) traverse(nodes, ask, holds_part, unwatched, options, memory);

  // For the next frame: what each occluder has hidden, and each probe would have.
  memory.history.record(occluders.size(), memory.result.occluders, memory.probes);
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
  const FrameView& view = begin_frame(source.nodes, depth(source.nodes, camera), camera, options, memory);
  CoverFrame frame(source, view, options, memory);
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
  const FrameView& view = begin_frame(nodes, depth(nodes, camera), camera, options, memory);
  // What hides may reach farther than the objects.
  const FrameView all(camera, std::max(view.depth, depth(source.nodes, camera)));
  CoverFrame frame(source, all, options, memory);
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
