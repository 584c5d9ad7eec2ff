// SPDX-License-Identifier: MIT
// A solid seen from a viewpoint: the faces turned to it, the vertices of the silhouette, the sides of the shadow. All of it
// is found from planes and points. Nothing follows the edges of faces.
#pragma once

#include <vector>

#include "polytope.h"

namespace occlude::oracle {

/// For each face, whether it is turned to the viewpoint. A face seen edge-on is not. No face is turned to the eye exactly
/// when the eye is in the solid.
[[nodiscard]] std::vector<bool> turned_faces(const Viewpoint& view, const Solid& solid);

/// The `vertices`, in their order, that lie on a face turned to the viewpoint and on a face not turned to it. On the
/// way around such a vertex from the one face to the other, an edge of the silhouette is crossed.
[[nodiscard]] std::vector<Point> silhouette_vertices(const Solid& solid, const std::vector<bool>& is_turned,
                                                     const std::vector<Point>& vertices);

/// The half-spaces that contain the solid and whose plane passes through the viewpoint and two points of the solid. Their
/// intersection is the cone of rays that meet the solid. A half-space may occur more than once. REQUIRES: the eye is not in
/// the solid.
[[nodiscard]] std::vector<OrientedPlane> side_planes(const Viewpoint& view, const Solid& solid);

}  // namespace occlude::oracle
