// SPDX-License-Identifier: MIT
// What a viewpoint sees of a solid: the faces turned to it, the vertices of the silhouette, the sides of the shadow. All of
// it is found from planes and points; nothing follows the edges of faces.
#pragma once

#include <vector>

#include "polytope.h"

namespace occlude::oracle {

/// Of every face whether it is turned to the viewpoint. One seen edge-on is not; all are turned away when, and only when,
/// the eye lies in the solid.
[[nodiscard]] std::vector<bool> turned_faces(const Viewpoint& view, const Solid& solid);

/// Those of `vertices`, in their order, that lie on a turned face and on one that is not turned: going round such a vertex
/// from the one to the other, an edge of the silhouette is crossed.
[[nodiscard]] std::vector<Point> silhouette_vertices(const Solid& solid, const std::vector<bool>& is_turned,
                                                     const std::vector<Point>& vertices);

/// The half-spaces through the viewpoint and two points that hold the solid: their common part is the cone of the rays that
/// meet it. One of them may come several times. REQUIRES: the eye is not in the solid.
[[nodiscard]] std::vector<OrientedPlane> side_planes(const Viewpoint& view, const Solid& solid);

}  // namespace occlude::oracle
