// SPDX-License-Identifier: MIT
// The cameras of a model's file as paths.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/render/camera_path.h"
#include "occlude/render/model.h"

namespace occlude::render {

/// The path of the camera of this name, in the coordinates of the model as read_model() reads it: at rest, or through the
/// first animation of the file that moves it, with about 30 frames a second. A camera is called as its node or, in glTF,
/// if that has no name, as the camera itself. `notes` are those of the model.
/// Throws InputError as read_model() does, for a camera that no path can have, and where there is none of this name, with
/// the names that there are.
[[nodiscard]] CameraPath read_model_camera(const std::filesystem::path& file, const std::string& name,
                                           const ModelNotes& notes);

}  // namespace occlude::render
