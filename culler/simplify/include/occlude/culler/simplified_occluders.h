// SPDX-License-Identifier: MIT
// Occluders of few triangles, made of what is drawn: its flat regions without what divides them, boxes inside of its closed
// parts, and of these what hides most. Reading order: 13.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/inner_boxes.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

struct SimplifyOptions {
  std::size_t triangles = 10'000;  ///< at most
  /// What the camera will see: some views of a walk, or from the rooms in which one walks, where six of 90 degrees look all
  /// around. The triangles are chosen that hide most of the soup in these views, all together, and then those that look
  /// largest from there. None: those with the largest area.
  std::span<const Camera> views = {};
  /// InnerBoxOptions::boxes is 0 where no boxes are wanted. Boxes hide for eyes alone that are never inside of a closed part
  /// (inner_boxes.h); all other occluders hide for every eye.
  InnerBoxOptions boxes = {.boxes = 0};
  /// By how much regions of closed parts may differ from flat ones and be merged still: each is moved inwards, until it is
  /// flat and the part all beyond it. 0: what is exactly flat is merged, and stays where it is. Hides as boxes do.
  double inset = 0;
};

/// Where a triangle comes from.
struct OccluderOrigin {
  static constexpr std::uint32_t kNoBox = ~std::uint32_t{0};

  std::uint32_t polygon = 0;   ///< one of those on which it lies, or the first of the part inside of which it lies
  std::uint32_t box = kNoBox;  ///< the box of which it is half a face (SimplifiedOccluders::boxes), or none
  bool is_inside = false;      ///< whether it lies inside of a closed part (inner_boxes.h), not on it

  friend bool operator==(const OccluderOrigin&, const OccluderOrigin&) = default;
};

/// Triangles that may hide for a soup, such that
/// 1. *on faces:* a triangle that is not inside lies on the soup: each of its points is a point of an opaque polygon, as it
///    is drawn, in the same plane. Its corners are vertices of the soup, and it turns as those polygons do;
/// 2. *inside:* a triangle with a box is half a face of an inner box of the soup (inner_boxes.h), and turns
///    counter-clockwise seen from outside of the box. Another one that is inside has no point in common with the polygons of
///    the closed part, as they are drawn, and all its points are inside of the part;
/// 3. *whole:* if `triangles` is not less than `flat_triangles`, and neither boxes nor an inset are wanted, then the
///    triangles cover all that the opaque polygons cover. If no polygon is repeated and every edge of the soup runs along an
///    even number of sides, then so does every edge of the triangles: what is closed stays closed;
/// 4. *best first:* they descend by what they are chosen for, so that the first n are those for n triangles.
///
/// Why 1 and 3 hold. Triangles of the soup's fans are joined where they share an edge, lie exactly in one plane on either
/// side of the edge and turn the same way. Then vertices are taken out, one at a time. The triangles around a vertex, as
/// joined, are fans. A fan is taken out whose loop goes all around the vertex, or begins and ends at two neighbours with the
/// vertex exactly on the line between them, if the same two are the ends of all such fans there. The fan's loop is divided
/// into other triangles, without the vertex: in the plane none is turned over, and their directed edges are the loop's, once
/// each, and others, once in each direction. So they cover each point as often as the fan did (triangles_of_face,
/// polygon_soup.h), and what lies along the edges from the one neighbour over the vertex to the other lies now along one
/// edge, on all sides of it.
///
/// So no seam opens along an edge. All predicates are exact: nothing is taken for flat or straight that is so up to
/// rounding.
struct SimplifiedOccluders {
  PolygonSoup soup;                     ///< the triangles; no vertex of it is unused or repeated
  std::vector<OccluderOrigin> origins;  ///< of each triangle
  std::vector<InnerBox> boxes;          ///< of which at least half a face is used
  std::size_t drawn_triangles = 0;      ///< of the soup: opaque, with three corners, not repeated
  std::size_t flat_triangles = 0;       ///< that do for all of them: to choose from, beside those of boxes
};

/// Makes occluders of a soup. Objects that come and go by themselves are soups of their own: a flat region may go over
/// polygons of several. The result does not depend on the number of processors. Takes time n log n in the triangles, a
/// few times that of a cull for each view, and what find_inner_boxes() takes. Throws as the constructor of Culler,
/// std::invalid_argument for a view with a fault(), and what `checkpoint` throws.
[[nodiscard]] SimplifiedOccluders simplified_occluders(SoupView soup, const SimplifyOptions& options = {},
                                                       const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
