// SPDX-License-Identifier: MIT
// What one or several frames of a region draw, to be culled by the view of each frame that they hold for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera/frame_view.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/held_cull.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

/// The leaves that frames draw, in the order of the tree, eight to a block. Eight blocks have a block of their boxes: leaves
/// that follow each other lie close together.
class DrawnLeaves {
 public:
  /// Begins anew with those that any of the frames draw. REQUIRES: the ranges of each are in ascending order.
  void keep(const Hierarchy& hierarchy, std::span<const std::vector<PolygonRange>> drawn);
  /// Replaces the result with those that are not beyond any of the planes. REQUIRES: at most ViewPlanes::kMostPlanes.
  void list(std::span<const kernel::HalfSpace> planes, HeldResult& result) const;

 private:
  static constexpr std::size_t kBoxes = kernel::BoxBlock::kBoxes;
  struct Block {
    kernel::BoxBlock boxes;
    std::array<PolygonRange, kBoxes> ranges;
    std::uint32_t count = 0;
  };
  struct Above {
    kernel::BoxBlock boxes;
    std::uint32_t count = 0;
  };

  void add(const HierarchyNode& leaf);
  void list(const Block& block, std::span<const kernel::HalfSpace> planes, std::uint32_t straddled,
            HeldResult& result) const;

  std::vector<Block> blocks_;
  std::vector<Above> above_;  ///< of eight blocks each
};

/// A region that was culled: by one frame, or by six whose pictures hold all directions.
class HeldRegion {
 public:
  /// Culls for the cameras, which have the same region. `view` is what the frames use.
  void cull(const Culler& culler, std::span<const Camera> cameras, const CullOptions& options, View& view);
  /// Whether it draws all that the camera shows.
  [[nodiscard]] bool holds_for(const Camera& camera) const;
  [[nodiscard]] bool holds_for(const MatrixCamera& camera) const;

  [[nodiscard]] const DrawnLeaves& leaves() const { return leaves_; }

 private:
  template <class AnyCamera>
  [[nodiscard]] bool holds_for_any(const AnyCamera& camera) const;
  template <class AnyCamera>
  [[nodiscard]] bool holds_around(const AnyCamera& camera) const;

  std::vector<FrameView> frames_;
  std::vector<std::vector<PolygonRange>> drawn_;  ///< of each frame
  DrawnLeaves leaves_;
};

/// No point that the camera clips at its near plane, however it rounds, is so far from its eye. None if there is no such
/// distance, or rays are parallel.
[[nodiscard]] std::optional<double> near_around(const Camera& camera, double depth);
[[nodiscard]] std::optional<double> near_around(const MatrixCamera& camera, double depth);

/// Six cameras with the eye and the eyes of this one, whose pictures hold all directions. They overlap by more than rounding
/// turns them.
[[nodiscard]] std::array<Camera, 6> all_around(const Camera& camera, double near);

}  // namespace occlude::culler
