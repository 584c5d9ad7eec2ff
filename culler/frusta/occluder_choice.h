// SPDX-License-Identifier: MIT
// The choice of section 4.2: the list of the eye's region is narrowed to the view frustum and sorted by the objective, and
// the best n_occ are taken. Reading order: 12.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "camera/frame_view.h"
#include "frusta/frusta_memory.h"
#include "frusta/occluder_set.h"
#include "frusta/plane_work.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// The work that choosing may take for each occluder that a frame may use, in units of PlaneWork. A corner of a candidate
/// counts as a plane, and a candidate that the kernel refuses as an answer of the exact stage. Without a bound, one wall
/// that hides all other candidates would have every one of them tested. The bound is about half a millisecond for each
/// occluder, and more than four times the most that the models tried take: 14,100, with 64 occluders a frame.
inline constexpr std::size_t kChoiceWorkOfEach = std::size_t{1} << 16U;

/// The steps of a choice, for a frame whose half-spaces are known. cull_by_frusta.h has their order. They fill
/// frame.result.occluders and frame.result.pairs, best first, and memory.probes. Three kinds of occluders are left out:
/// those that the kernel refuses from this viewpoint, those that reach before the renderer's near plane (what is clipped
/// away must not occlude), and those in the shadow of a better one, because their shadow is a subset of its shadow. Once the
/// work is spent no more are taken.
class OccluderChoice {
 public:
  /// Reserves memory for all that a choice by these options may take, so that no choice after the first allocates.
  OccluderChoice(const OccluderSet& occluders, const CullOptions& options, Frame& frame, FrustaMemory& memory);
  ~OccluderChoice();
  OccluderChoice(const OccluderChoice&) = delete;
  OccluderChoice& operator=(const OccluderChoice&) = delete;

  /// Sorts what the region lists and is in view by the criteria that do not depend on earlier frames. At the same time
  /// takes, unless coherence has no weight, what hid something lately and is in view, whether or not the region lists it.
  void sort_candidates_and_take_proven();
  /// Takes candidates that were not tried in the last frames, best first, while there is room.
  void take_untried();
  /// Takes the other candidates, best first.
  void take_best();
  /// Takes the best candidates that were not tried lately as probes, first those near a good occluder in the picture.
  void take_probes();
  /// Pairs the occluders that share an edge. Pairs among the best occluders come before pairs with the next.
  void pair_neighbours();

 private:
  template <class OccluderAt, class Visit>
  void for_each_in_view(SeenOccluders& seen, const OccluderAt& occluder_at, const Visit& visit) const;
  void begin(const OccluderLists::List& listed);
  void begin_on_threads(const OccluderLists::List& listed);
  void sort(std::span<const Candidate> candidates);
  void take_proven();
  void find_candidates(const OccluderLists::List& listed, std::size_t first, std::size_t end,
                       std::vector<Candidate>& found) const;
  [[nodiscard]] std::size_t parts_of(std::size_t listed) const;
  [[nodiscard]] bool is_alone() const;
  void note_directions();
  [[nodiscard]] double goodness_near(const glm::dvec3& direction) const;
  [[nodiscard]] glm::dvec3 direction_to(const glm::dvec3& point) const;
  [[nodiscard]] bool is_full() const;
  bool take(std::uint32_t i);
  bool is_usable(std::uint32_t i);
  bool is_in_shadow();
  bool add(std::uint32_t i);
  void put_off(std::uint32_t i);
  bool make_probes();
  void make(UnmadeProbe& unmade);
  bool keep_made();
  kernel::Refusal add_shell(std::uint32_t i, kernel::ShadowFrustum& frustum);

  const OccluderSet& occluders_;
  const FrameView& view_;
  const CullOptions& options_;
  CullResult& frame_;
  FrustaMemory& memory_;
  PlaneWork work_;
  bool are_probes_ = false;        ///< whether what is taken is a probe
  bool is_list_gathered_ = false;  ///< whether memory_.listed is that of the eye's region
  std::size_t unmade_ = 0;         ///< how many there are
};

}  // namespace occlude::culler
