// SPDX-License-Identifier: MIT
// What frames by frusta keep from frame to frame, and memory that they reuse.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/sparse_zero_array.h"
#include "base/work_runner.h"
#include "descent/frame.h"
#include "descent/parallel_traversal.h"
#include "frusta/candidate_order.h"
#include "frusta/followed_silhouettes.h"
#include "frusta/occluder_history.h"
#include "frusta/occluder_set.h"
#include "frusta/seen_occluders.h"
#include "frusta/shrunk_shadow.h"

namespace occlude::culler {

/// An occluder of a frame as seen from the eye, and what it hid lately, as a share of the most that one of them hid.
struct OccluderDirection {
  glm::dvec3 direction;
  double goodness;
};

/// The list of the region that the eye was in last. Most frames find the eye there again.
struct ListedOccluders {
  std::optional<std::size_t> region;  ///< none: of no region
  std::vector<SeenOccluders> groups;  ///< each but the last is full
};

/// What casts a shadow.
struct ShadowCaster {
  std::span<const std::uint32_t> parts;  ///< ascending
  bool are_surface;                      ///< whether the parts are in the surface at which the shadow begins
};

/// A part of the start of a choice: the groups of a list from `first` to before `end`, and what is found to be in view.
struct ChoiceSlice {
  std::size_t first = 0, end = 0;
  std::vector<Candidate> candidates;
};

/// A probe whose shadow is to be made, on any thread.
struct UnmadeProbe {
  std::size_t probe = 0;  ///< which of the probes
  std::vector<kernel::Vec3> loop;
  kernel::Refusal refusal = kernel::Refusal::none;
};

/// The result of trying to take an occluder, which may have to be tried again.
enum class Trial : std::uint8_t { none, taken, refused, again };
static_assert(Trial{} == Trial::none);

struct FrustaMemory {
  OccluderHistory history;
  ListedOccluders listed;
  CandidateOrder order;
  FollowedSilhouettes silhouettes;

  std::vector<Candidate> candidates;
  std::vector<ChoiceSlice> choice_slices;
  std::vector<kernel::ShadowFrustum> spare;  ///< frusta of earlier frames
  std::vector<kernel::Vec3> loop;
  std::vector<OccluderDirection> directions;
  std::vector<std::uint32_t> tried;                  ///< occluders that the frame has tried to take
  SparseZeroArray<Trial> trials;                     ///< for each occluder, what came of it
  std::vector<Occluder> probes;                      ///< of the frame, which hide nothing
  std::vector<UnmadeProbe> unmade;                   ///< may be longer than those that are
  std::vector<ShrunkShadow> shrunk;                  ///< for each occluder of the frame, its shadow less the margin
  std::vector<const kernel::ShadowFrustum*> frusta;  ///< of the occluders, then of the probes
  std::vector<ShadowCaster> casters;                 ///< those that cast `frusta`
  TraversalMemory traversal;
  ParallelMemory parts;
  WorkRunner runner;

  /// Fills `frusta` and `casters`. `occluders` may be null if the frame has none.
  void take_casters(const CullResult& frame, const OccluderSet* occluders, kernel::Near near);
  /// Fills `shrunk`, which may be longer than the occluders are.
  void shrink_shadows(const Frame& frame);
  /// Takes the frusta of the frame and of its probes for the next one.
  void keep_spare(CullResult& frame);
};

}  // namespace occlude::culler
