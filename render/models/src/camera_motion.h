// SPDX-License-Identifier: MIT
// The cameras of a file, and how the one that is asked for moves.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <limits>
#include <string>
#include <vector>

#include "counted_files.h"
#include "handover.h"

namespace occlude::render {

struct CameraMotion {
  /// As in CameraPath.
  struct Lens {
    bool is_perspective = true;
    double fov_y_deg = 60, height = 100, near = 0.1, far = std::numeric_limits<double>::infinity();
  };

  std::vector<std::string> names;  ///< of all cameras, each once
  Lens lens;
  std::vector<glm::dmat4> poses;  ///< of each frame; empty if there is no camera of the name
};

// Both throw InputError.
/// The scene of a .gltf or .glb file.
[[nodiscard]] CameraMotion gltf_camera(const std::filesystem::path& file, const std::string& name);
/// By the import library.
[[nodiscard]] CameraMotion imported_camera(const std::filesystem::path& file, const std::string& name);
/// The same in the child process of an import (import_child.h).
[[nodiscard]] CameraMotion import_camera_with_assimp(const std::filesystem::path& file, const std::string& name,
                                                     CountedFiles& files);

/// On its way from that process.
void hand_over(const CameraMotion& motion, HandoverWriter& writer);
/// Throws ChildFailure for what no import can have handed over.
void take_over(CameraMotion& motion, HandoverReader& reader);

/// Adds the name of a camera, with its number behind it if there is one of that name. Returns how it is called.
std::string add_name(CameraMotion& motion, const std::string& name);

}  // namespace occlude::render
