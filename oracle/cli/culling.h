// SPDX-License-Identifier: MIT
// Frames of a walk, culled anew to be proved.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "camera_picture.h"
#include "model_scene.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/view_along_path.h"
#include "occlude/render/walk.h"

namespace occlude::cli {

/// The model, the path, and the options for culling its frames anew.
struct Walked {
  const culler::Culler& culler;
  const render::CameraPath& path;
  const render::WalkOptions& options;
  bool by_matrix = false;  ///< by the matrix of each camera, as an engine has it
  bool as_scene = false;   ///< of the model as a scene

  /// The camera by which a frame is culled. Throws InputError if it is to be a matrix, and that cannot be used.
  [[nodiscard]] proof::AnyCamera camera(std::size_t frame) const;
};

/// Culls frames of a walk, each as it is after those before it.
class Culling {
 public:
  explicit Culling(const Walked& walked);

  /// REQUIRES: a frame after that of the last call.
  [[nodiscard]] const culler::CullResult& cull(std::size_t frame);
  /// Adds the witnesses of a frame, which is then culled.
  void append_witnesses(std::vector<std::string>& lines, std::size_t frame);

 private:
  const Walked& walked_;
  render::ViewAlongPath along_;
  std::optional<ModelScene> scene_;
};

}  // namespace occlude::cli
