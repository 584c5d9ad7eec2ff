// SPDX-License-Identifier: MIT
// Why one polygon was drawn or culled in one frame: by which node, occluder and plane, and by what margin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/kernel/clearance.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/frames_along_path.h"
#include "occlude/render/image.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// A frame of a walk, culled as in the walk, after the frames before it; with a step also a frame that the walk does not
/// count. Throws InputError if the walk lacks this frame.
class ReplayedFrame {
 public:
  /// All arguments must outlive this object.
  ReplayedFrame(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options, std::size_t frame);

  [[nodiscard]] const culler::Culler& culler() const { return culler_; }
  [[nodiscard]] const WalkOptions& options() const { return options_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] const culler::Camera& camera() const { return camera_; }
  [[nodiscard]] const culler::CullResult& result() const { return *result_; }
  /// As FramesAlongPath::source().
  [[nodiscard]] CulledFor source() const { return along_.source(); }

 private:
  const culler::Culler& culler_;
  const WalkOptions& options_;
  std::size_t number_;
  culler::Camera camera_;
  FramesAlongPath along_;
  const culler::CullResult* result_ = nullptr;
};

/// The position of a box relative to the shadow of one of the frame's occluders.
struct AgainstShadow {
  std::uint32_t occluder = 0;  ///< index in CullResult::occluders
  kernel::Clearance clearance;
};

/// By how much a culled subtree is beyond the half-space that culled it. REQUIRES: culled by view.
[[nodiscard]] double beyond_view(const culler::Culler& culler, const culler::CullResult& frame,
                                 const culler::Culled& culled);
/// The box of a culled subtree against the one or two shadows that culled it. REQUIRES: culled by shadow.
[[nodiscard]] std::vector<AgainstShadow> against_shadows(const culler::Culler& culler, const culler::CullResult& frame,
                                                         const culler::Culled& culled);

/// The account of one polygon.
struct Account {
  std::uint32_t polygon = 0;           ///< index in the tree
  std::size_t pixels = 0;              ///< pixels that show it without culling
  std::uint32_t node = 0;              ///< the culled subtree, or the drawn leaf
  std::optional<culler::Culled> cull;  ///< none if it was drawn
  double beyond_view = 0;              ///< culled by view: beyond_view() of the node
  /// Culled by shadow: the node against the one or two shadows. Drawn: the polygon's own box against every shadow, those
  /// that most nearly contain it first.
  std::vector<AgainstShadow> shadows;
  std::vector<std::uint32_t> cover;  ///< culled by cover: the polygons of the tree that together hide the node
  std::optional<culler::MissedReasons::Answer> missed;  ///< hidden but drawn: the reason
};

/// REQUIRES: a polygon of the tree, and the item buffer of the whole model.
[[nodiscard]] Account account_for(const ReplayedFrame& frame, std::uint32_t polygon, const ItemBuffer& items);

}  // namespace occlude::render
