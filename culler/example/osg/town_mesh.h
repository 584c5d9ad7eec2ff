// SPDX-License-Identifier: MIT
// Coloured triangles from which the town is made.
#pragma once

#include <array>
#include <osg/Array>
#include <osg/Geometry>
#include <osg/Vec3>
#include <osg/ref_ptr>
#include <span>
#include <vector>

namespace occlude::example {

using Colour = osg::Vec3;

/// A rectangle in a wall, from its left lower corner.
struct Opening {
  float left, bottom, right, top;
};

class TownMesh {
 public:
  TownMesh();

  /// A quadrangle, counter-clockwise from outside.
  void quad(const std::array<osg::Vec3, 4>& corners, const Colour& colour);
  void triangle(const std::array<osg::Vec3, 3>& corners, const Colour& colour);
  void box(const osg::Vec3& low, const osg::Vec3& high, const Colour& colour);
  /// A wall from `from` to `to`, up to `height`, with holes.
  void wall(const osg::Vec3& from, const osg::Vec3& to, float height, const Colour& colour,
            std::span<const Opening> openings = {});

  /// Draws the mesh. The numbers are shared, so each object may have a geometry of its own.
  [[nodiscard]] osg::ref_ptr<osg::Geometry> geometry() const;

 private:
  osg::ref_ptr<osg::Vec3Array> corners_, normals_;
  osg::ref_ptr<osg::Vec3Array> colours_;
  osg::ref_ptr<osg::VertexBufferObject> buffer_;
};

}  // namespace occlude::example
