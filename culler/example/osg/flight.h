// SPDX-License-Identifier: MIT
// The way of the camera through the town.
#pragma once

#include <osg/Matrixd>
#include <osg/Vec3d>

namespace occlude::example {

/// Along a street to the east, with a bus ahead; round a corner to the north; and up, to look over the roofs.
class Flight {
 public:
  explicit Flight(int side);

  [[nodiscard]] double seconds() const;
  [[nodiscard]] osg::Vec3d eye(double time) const;
  [[nodiscard]] osg::Matrixd view(double time) const;

 private:
  osg::Vec3d start_, corner_, end_;
};

}  // namespace occlude::example
