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
#include "occlude/culler/matrix_camera.h"
#include "occluder_choice.h"
#include "view_memory.h"

namespace occlude::culler {

/// Throws std::invalid_argument for a camera with a fault(), std::runtime_error while the processor does not round to
/// nearest.
template <class AnyCamera>
void require_sound(const AnyCamera& camera) {
  require_rounding();
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
}

/// The same for a frame by this method.
inline void require_sound(const Camera& camera, Method) { require_sound(camera); }
inline void require_sound(const MatrixCamera& camera, Method method) {
  require_rounding();
  if (const std::string reason = fault(camera, method); !reason.empty()) throw std::invalid_argument("camera: " + reason);
}

[[nodiscard]] inline glm::dvec3 eye_of(const Camera& camera) { return camera.eye; }
[[nodiscard]] inline glm::dvec3 eye_of(const MatrixCamera& camera) { return camera.eye(); }

/// Begins a frame of either method: empties the result and makes the half-spaces of the view. REQUIRES:
/// require_sound(camera).
template <class AnyCamera>
void begin_frame(const Hierarchy& hierarchy, const AnyCamera& camera, const CullOptions& options, View::Memory& memory) {
  memory.begin_frame(hierarchy.nodes().size());
  memory.view = FrameView(camera, depth(hierarchy.nodes()[0].box, eye_of(camera)));
  memory.view.append_half_spaces(memory.result.view);
  memory.result.method = Method::frusta;
  memory.result.margin = ShadowMargin(memory.view, options.margin);
}

/// Section 4.2: of the list of the eye's region, those in view are sorted by the objective, and the best n_occ get shadow
/// frusta. What hid something in earlier frames comes first (4, criterion 3).
inline void choose_occluders(const OccluderSet& occluders, const CullOptions& options, View::Memory& memory) {
  OccluderChoice choice(occluders, memory.view, options, memory);
  const bool is_coherent = options.objective.coherence != 0;
  choice.sort_candidates_and_take_proven();
  if (is_coherent) choice.take_untried();
  choice.take_best();
  if (is_coherent) choice.take_probes();
  if (options.unions) choice.pair_neighbours();
}

/// Culls by frusta, as in the paper. `occluders` may be null if options.occluders is 0. What is thrown leaves a result that
/// draws everything. REQUIRES: begin_frame() was called.
inline void cull_by_frusta(const Hierarchy& hierarchy, const NodeBlocks& blocks, const OccluderSet* occluders,
                           const CullOptions& options, View::Memory& memory) {
  try {
    if (options.occluders > 0) choose_occluders(*occluders, options, memory);

    // Section 5: one descent of the tree culls by the half-spaces and by the shadows, and draws.
    const auto unwatched = [](const NodeBlock&, const kernel::BlockQuestions&, kernel::BoxBytes) {};
    traverse(blocks, hierarchy, occluders, unwatched, options, memory);
  } catch (...) {
    memory.draw_all(hierarchy.soup().all());
    throw;
  }

  // For the next frame: what each occluder hid, and what each probe would have hidden.
  memory.history.record(occluders == nullptr ? 0 : occluders->size(), memory.result.occluders, memory.probes);
}

/// A tree as a descent sees it: of a model.
struct ModelTree {
  const Hierarchy& hierarchy;
  std::span<const HierarchyNode> nodes = hierarchy.nodes();

  [[nodiscard]] const kernel::Aabb& box(std::uint32_t node) const { return nodes[node].box; }
  template <class Question>
  decltype(auto) ask(std::uint32_t node, const Question& question) const {
    return hierarchy.ask(node, question);
  }
};

/// Observes a frame by cover, and does nothing.
struct Unwatched {
  static void begin() {}
  static void joined(const CoverPainter&) {}
  static void culled(const Culled&) {}
};

/// Culls a model by cover: what is seen of it hides the rest. REQUIRES: begin_frame() was called.
template <class Watch = Unwatched>
void cull_by_cover(const Hierarchy& hierarchy, const CoverTriangles& triangles, const CullOptions& options,
                   View::Memory& memory, Watch&& watch = {}) {
  const CoverSource source{hierarchy.nodes(), triangles};
  CullResult& result = memory.result;
  CoverPainter painter(memory.view, options.cover, options.margin, memory.cover, result.stats);
  result.method = Method::cover;  // the picture is this frame's from here on
  painter.use(source);
  watch.begin();

  CoverFrame frame(source.nodes, memory);
  const auto see = [&](const SeenNode& leaf) {
    frame.see(leaf);
    if (leaf.is_worth_closing) painter.take(leaf);
  };
  const auto cull = [&](const Culled& culled) {
    watch.culled(culled);
    frame.cull(culled);
  };
  const auto join = [&] {
    if (painter.join()) watch.joined(painter);
  };
  memory.take_planes();
  const ViewPlanes planes{memory.planes, options.arithmetic};
  const ModelTree tree{hierarchy};
  CoverDescent(tree, planes, memory.cover.buffer, Sought::seen, result.stats, see, cull, join).run(planes.all());
  frame.finish(cull);
}

}  // namespace occlude::culler
