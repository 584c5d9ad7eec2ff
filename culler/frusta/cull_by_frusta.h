// SPDX-License-Identifier: MIT
// A frame by shadow frusta, as in the paper, from top to bottom: half-spaces, a few chosen occluders (4.2), one descent of
// the tree (5), what to remember for the next frame. Reading order: 12.
#pragma once

#include "descent/frame.h"
#include "frusta/node_tests.h"
#include "frusta/occluder_choice.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// Section 4.2: of the list of the eye's region, those in view are sorted by the objective, and the best n_occ get shadow
/// frusta. What hid something in earlier frames comes first (4, criterion 3).
inline void choose_occluders(const OccluderSet& occluders, const CullOptions& options, Frame& frame, FrustaMemory& memory) {
  OccluderChoice choice(occluders, options, frame, memory);
  const bool is_coherent = options.objective.coherence != 0;
  choice.sort_candidates_and_take_proven();
  if (is_coherent) choice.take_untried();
  choice.take_best();
  if (is_coherent) choice.take_probes();
  if (options.unions && frame.margin.is_of_one_eye()) choice.pair_neighbours();
}

/// `occluders` may be null if options.occluders is 0. What is thrown leaves a result that draws everything. REQUIRES: the
/// frame has begun.
inline void cull_by_frusta(const Hierarchy& hierarchy, const BlockTree& tree, const OccluderSet* occluders,
                           const CullOptions& options, Frame& frame, FrustaMemory& memory) {
  try {
    if (options.occluders > 0) choose_occluders(*occluders, options, frame, memory);

    // Section 5: one descent of the tree culls by the half-spaces and by the shadows, and draws.
    const auto unwatched = [](const TreeBlock&, const kernel::BlockQuestions&, kernel::BoxBytes) {};
    traverse(tree, hierarchy, occluders, unwatched, options, frame, memory);
  } catch (...) {
    frame.draw_all(hierarchy.soup().all());
    throw;
  }

  // For the next frame: what each occluder hid, and what each probe would have hidden.
  memory.history.record(occluders == nullptr ? 0 : occluders->size(), frame.result.occluders, memory.probes);
}

}  // namespace occlude::culler
