// SPDX-License-Identifier: MIT
// The choice of section 4.2: the list of the eye's region, narrowed to the view frustum, sorted by the objective, the best
// n_occ. Reading order: 11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "frame_view.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/occluder_set.h"
#include "plane_work.h"
#include "view_memory.h"

namespace occlude::culler {

/// The work that choosing may take, for each occluder that a frame may use: PlaneWork, to which each corner of a candidate
/// counts as a plane, and a candidate that the kernel refuses as an answer of the exact stage. Without a bound one wall that
/// hides all other candidates has every one of them asked. For each occluder that is half a millisecond or so, and more
/// than four times what the models tried take at most: 14,100, with 64 occluders a frame.
inline constexpr std::size_t kChoiceWorkOfEach = std::size_t{1} << 16U;

/// The steps of a choice, for a frame whose half-spaces are known; cull_frame.h has their order. Fills
/// memory.result.occluders and memory.pairs, best first, and memory.probes. Left out are occluders that the kernel refuses
/// from this viewpoint, those that reach before the renderer's near plane (what is clipped away must not occlude), and those
/// that lie in the shadow of a better one: their shadow is part of its shadow. Once the work is spent no more are taken.
class OccluderChoice {
 public:
  /// Makes room for all that a choice by these options may take, so that none after the first has to.
  OccluderChoice(const OccluderSet& occluders, const FrameView& view, const CullOptions& options, View::Memory& memory);
  ~OccluderChoice();
  OccluderChoice(const OccluderChoice&) = delete;
  OccluderChoice& operator=(const OccluderChoice&) = delete;

  /// The region's list, narrowed to the view frustum, by the criteria that do not depend on earlier frames.
  void sort_candidates();
  /// What hid something lately and is in view, whatever the region lists.
  void take_proven();
  /// Candidates that were not tried in the last frames, best first, while there is room.
  void take_untried();
  /// The rest of them.
  void take_best();
  /// The best of what was not tried lately; those near a good occluder in the picture come first.
  void take_probes();
  /// Those that share an edge. Pairs among the best occluders come before pairs with the next.
  void pair_neighbours();

 private:
  [[nodiscard]] double size_of(std::uint32_t i) const;
  [[nodiscard]] double goodness_near(std::uint32_t i) const;
  [[nodiscard]] glm::dvec3 direction_of(std::uint32_t i) const;
  [[nodiscard]] bool is_full() const;
  bool take(std::uint32_t i);
  bool is_usable(std::uint32_t i);
  bool is_in_shadow();
  bool add(std::uint32_t i);
  kernel::Refusal add_shell(std::uint32_t i, kernel::ShadowFrustum& frustum);

  const OccluderSet& occluders_;
  const FrameView& view_;
  const CullOptions& options_;
  View::Memory& memory_;
  PlaneWork work_;
  bool are_probes_ = false;  ///< whether what is taken only probes
};

}  // namespace occlude::culler
