// SPDX-License-Identifier: MIT
// Boxes inside of closed parts of a model: occluders of few large polygons, made of what is drawn and proven to lie in it.
// Reading order: 13.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A part of a soup is what is connected over shared corners; corners with equal coordinates count as one. A part is closed
/// if every edge runs along an even number of its sides. A point off its polygons is inside of it if a ray from there
/// crosses an odd number of its triangles. Which way polygons are turned does not matter, nor what other parts do.
///
/// An inner box is exactly within a closed part: no triangle of the part, as it is drawn, has a point in the box without its
/// borders, and one point of the box is inside of the part. So all of it is. It may touch the triangles.
///
/// Every segment from an eye outside of the part to a point of the box meets the part. So from there the box hides only what
/// the part hides, as long as both sides of the part are drawn, or its polygons are turned outwards.
///
/// FROM AN EYE INSIDE OF THE PART, but outside of the box, this is not so: nothing need be drawn between the two, and the
/// box would hide what is seen. Use inner boxes of parts in which no eye ever is. The room of a house may be such an inside:
/// where the inner faces of its walls share no corner with the outer ones, they are another part, and the outer part holds
/// the room.
struct InnerBox {
  kernel::Aabb box;
  std::uint32_t polygon = 0;  ///< the first of the part
};

struct InnerBoxOptions {
  std::size_t boxes = 4;  ///< of a part, at most
  /// Of the grid in which boxes are looked for, along each axis of a part's own box; 3 to 64, else the nearest of these.
  /// Finer grids find boxes in narrower parts.
  std::size_t cells = 16;
};

/// What find_inner_boxes() found.
struct InnerBoxes {
  std::vector<InnerBox> boxes;  ///< ascending by polygon; of a part the largest first, more or less
  std::size_t parts = 0, closed_parts = 0, filled_parts = 0;  ///< all; the closed ones; those of them that have a box
  /// Volume of the first box of each part, all together, divided by that of the smallest boxes that hold the closed parts.
  double share = 0;
};

/// Finds boxes in every closed part of the soup. The first is the largest in a grid of cells, the next the largest in what
/// is left of them, until there are enough, or the next would be small. Then each face is moved outwards until it touches
/// the part; so boxes of one part may overlap, and leave no seams. A box that cannot be proven is not given: parts that are
/// thin and slanting, or have less than some thousand doubles across, may have none.
///
/// Runs on all processors; the result does not depend on their number. With n triangles in a part and c cells along an axis
/// it takes time in proportion to n c^2, less for triangles that are small or lie where others do, and to c^4 at most for
/// each box, and then to n for each of seven moves, with some hundred exact questions. Throws as the constructor of Culler.
/// Calls progress(done, all), if given, after each of all parts: on any thread, one call at a time. What it or `checkpoint`
/// throws stops the work and is thrown on.
[[nodiscard]] InnerBoxes find_inner_boxes(SoupView soup, const InnerBoxOptions& options = {},
                                          const std::function<void(std::size_t done, std::size_t all)>& progress = {},
                                          const Checkpoint& checkpoint = {});

/// The boxes as six quadrilaterals each, counter-clockwise seen from outside: what an OccluderMesh is made of.
[[nodiscard]] PolygonSoup soup_of(std::span<const InnerBox> boxes);

}  // namespace occlude::culler
