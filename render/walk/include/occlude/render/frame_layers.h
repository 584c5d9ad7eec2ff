// SPDX-License-Identifier: MIT
// What became of the polygons in one frame, as layers of a plate.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/render/plate_renderer.h"

namespace occlude::render {

/// The polygons of a frame, by what became of them. Of the tree, in ascending order.
struct FrameLayers {
  std::vector<culler::PolygonRange> occluders;  ///< drawn or not; none by cover
  std::vector<culler::PolygonRange> seen;       ///< drawn, and seen in the picture
  std::vector<culler::PolygonRange> missed;     ///< drawn, but hidden
  std::vector<culler::PolygonRange> culled;     ///< culled by shadow or by cover
  std::vector<culler::PolygonRange> out_of_view;

  /// All of them, the occluders first, each in its style.
  [[nodiscard]] std::vector<PlateLayer> all() const;
  /// Names the styles of all(), with numbers of polygons, but for those that have none.
  [[nodiscard]] std::vector<LegendEntry> legend() const;
};

/// `renderer` holds the polygons of the tree. What its plates show counts as seen.
[[nodiscard]] FrameLayers layers_of(const culler::Culler& culler, const culler::Camera& camera,
                                    const culler::CullResult& result, PlateRenderer& renderer);

/// How many polygons there are.
[[nodiscard]] std::size_t count(const std::vector<culler::PolygonRange>& ranges);

}  // namespace occlude::render
