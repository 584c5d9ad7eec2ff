// SPDX-License-Identifier: MIT
// A model as an engine would have it in a scene.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "camera_picture.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"

namespace occlude::cli {

/// Each leaf of the tree is an object, and all polygons are one occluder.
class ModelScene {
 public:
  /// REQUIRES: `hierarchy` outlives this.
  explicit ModelScene(const culler::Hierarchy& hierarchy);

  /// Culls a frame by cover with these options, and appends a witness for each object that is culled.
  void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const proof::AnyCamera& camera,
                        const culler::CullOptions& options);

 private:
  const culler::Hierarchy& hierarchy_;
  culler::Scene scene_;
  std::vector<culler::PolygonRange> objects_;  ///< the polygons of each, by slots
  culler::SceneView view_;
};

}  // namespace occlude::cli
