// SPDX-License-Identifier: MIT
// What is kept of a view from frame to frame, and memory that its frames use again.
#pragma once

#include <cstdint>
#include <vector>

#include "candidate_order.h"
#include "cover_buffer.h"
#include "cover_group.h"
#include "followed_silhouettes.h"
#include "frame_view.h"
#include "occlude/culler/view.h"
#include "occlude/kernel/half_space.h"
#include "occluder_history.h"

namespace occlude::culler {

/// A leaf that a frame by cover has not culled, and where it is in the coarse picture.
struct SeenLeaf {
  std::uint32_t leaf;
  CoverBuffer::Footprint footprint;
};

/// What came of trying to take an occluder.
enum class Trial : std::uint8_t { none, taken, refused };

struct View::Memory {
  CullResult result;
  FrameView view;  ///< of the frame, for all that its half-spaces are about
  OccluderHistory history;
  CandidateOrder order;
  FollowedSilhouettes silhouettes;

  std::vector<Candidate> candidates;
  std::vector<kernel::ShadowFrustum> spare;  ///< frusta of earlier frames
  std::vector<kernel::Vec3> loop;
  std::vector<std::uint32_t> tried;  ///< occluders that the frame has tried to take
  std::vector<Trial> trials;         ///< of each occluder, what came of it
  std::vector<kernel::HalfSpace> planes;
  std::vector<Occluder> probes;        ///< of the frame, which hide nothing
  std::vector<std::uint32_t> holding;  ///< the traversal's stacks
  std::vector<std::uint32_t> active;

  CoverBuffer cover;                          ///< what the last frame closed, if it was culled so
  CoverGroup group;                           ///< what is being drawn into it
  std::vector<std::uint32_t> polygon_frames;  ///< of each polygon, the last frame that drew it there
  std::uint32_t frame = 0;
  std::vector<std::uint32_t> taken;  ///< leaves whose polygons are drawn next
  std::vector<SeenLeaf> seen;        ///< what a frame by cover has not culled so far

  /// Makes planes of the result's view.
  void take_planes();
  /// Empties the result for the next frame; its frusta become spare. Makes room for all that a frame may draw or cull of a
  /// tree of so many nodes, so that no frame after the first has to: what is never written to takes addresses alone.
  void begin_frame(std::size_t nodes);
};

}  // namespace occlude::culler
