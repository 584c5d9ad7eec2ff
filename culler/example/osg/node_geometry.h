// SPDX-License-Identifier: MIT
// What a subtree of a scene graph fills and what of it hides. Reading order: 1.
#pragma once

#include <occlude/culler/polygon_soup.h>

#include <osg/BoundingBox>
#include <osg/Node>

namespace occlude::example {

/// In the coordinates below the node's own transform, if it is one. So the geometry of a node that moves as a whole is found
/// once.
struct NodeGeometry {
  /// Holds everything that the subtree may ever draw, whatever its switches and levels of detail show. Not valid if it draws
  /// nothing.
  osg::BoundingBoxd bounds;
  /// False if it has parts that `bounds` cannot hold: places that depend on the camera, as billboards; what moves or changes
  /// within the subtree; and what changes how others are drawn, as lights.
  bool is_bounded = true;
  /// The triangles that are drawn in each frame and are certainly opaque. Corners at the same place are one vertex, so that
  /// no seam is open between the triangles.
  culler::PolygonSoup opaque;
};

/// Whether a node says that it changes: by its data variance, DYNAMIC, or an update callback.
[[nodiscard]] bool may_change(const osg::Node& node);

/// REQUIRES: the subtree does not change while it is read. Opaque is what neither the node nor anything below it has
/// blended, discarded, culled by its facing or drawn by a shader or a callback; state that the node inherits is not looked
/// at.
[[nodiscard]] NodeGeometry geometry_of(osg::Node& node);

}  // namespace occlude::example
