// SPDX-License-Identifier: MIT
// What became of one polygon in one frame, and why: drawn or culled, by which node, occluder and plane, by what margin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/culler/missed.h"
#include "occlude/kernel/clearance.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/image.h"
#include "occlude/render/view_along_path.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// A frame of a walk, culled as the walk does: after the frames before it. Throws InputError when the walk does not come by.
class ReplayedFrame {
 public:
  /// All of these must outlive this.
  ReplayedFrame(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options, std::size_t frame);

  [[nodiscard]] const culler::Culler& culler() const { return culler_; }
  [[nodiscard]] const WalkOptions& options() const { return options_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] const culler::Camera& camera() const { return camera_; }
  [[nodiscard]] const culler::CullResult& result() const { return along_.view().result(); }

 private:
  const culler::Culler& culler_;
  const WalkOptions& options_;
  std::size_t number_;
  culler::Camera camera_;
  ViewAlongPath along_;
};

/// How a box lies to the shadow of one of the frame's occluders.
struct AgainstShadow {
  std::uint32_t occluder = 0;  ///< in CullResult::occluders
  kernel::Clearance clearance;
};

/// What became of a polygon.
struct Account {
  std::uint32_t polygon = 0;           ///< of the tree
  std::size_t pixels = 0;              ///< that show it, were nothing culled
  std::uint32_t node = 0;              ///< the subtree that was culled, or the leaf that was drawn
  std::optional<culler::Culled> cull;  ///< none: drawn
  double beyond_view = 0;              ///< by view: how far the node is beyond the half-space
  /// Of a cull by shadow: the node to each of the one or two shadows. Of a drawn polygon: its own box to every shadow, those
  /// that it is nearest to being in first.
  std::vector<AgainstShadow> shadows;
  std::vector<std::uint32_t> cover;  ///< of a cull by cover: the polygons of the tree that hide the node together
  std::optional<culler::MissedReasons::Answer> missed;  ///< hidden and drawn: why
};

/// REQUIRES: a polygon of the tree, and the item buffer of the whole model.
[[nodiscard]] Account account_for(const ReplayedFrame& frame, std::uint32_t polygon, const ItemBuffer& items);

}  // namespace occlude::render
