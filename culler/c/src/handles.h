// SPDX-License-Identifier: MIT
// What the handles of the C interface are.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "frames.h"
#include "occlude.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/occluder_mesh.h"
#include "occlude/culler/scene.h"

struct occlude_mesh {
  std::shared_ptr<const occlude::culler::OccluderMesh> mesh;
};

struct occlude_scene {
  occlude::culler::Scene scene;
};

struct occlude_view {
  occlude::culler::SceneView view;
  occlude::c::KeptFrame frame;  ///< the last one
  // How it was asked for.
  std::variant<std::monostate, occlude::culler::Camera, occlude::culler::MatrixCamera> camera;
  occlude::culler::SceneOptions options;
  // What the last fates refer to.
  std::vector<occlude_hiding> hiding;
  std::vector<double> corners;
};
