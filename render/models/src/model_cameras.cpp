// SPDX-License-Identifier: MIT
#include "occlude/render/model_cameras.h"

#include <fmt/format.h>

#include "camera_motion.h"
#include "extension.h"
#include "matrix_poses.h"
#include "occlude/render/errors.h"
#include "occlude/render/store.h"
#include "path_readers.h"

namespace occlude::render {
namespace {

CameraMotion motion_of(const std::filesystem::path& file, const std::string& name) {
  if (is_store(file)) throw InputError(file.string() + ": a store has no cameras; the model that it was made of may have");
  return is_gltf(file) ? gltf_camera(file, name) : imported_camera(file, name);
}

/// Turns and scales the camera as the model was.
void convert(CameraMotion& motion, const ModelNotes& notes) {
  const Convention &from = notes.file, &to = notes.convention;
  const double scale = from.metres == to.metres ? 1 : from.metres / to.metres;
  for (double* const length : {&motion.lens.height, &motion.lens.near, &motion.lens.far}) *length *= scale;
  for (glm::dmat4& pose : motion.poses) {
    for (int column = 0; column < 4; ++column) {
      glm::dvec3 vector(pose[column]);
      if (from.up != to.up) vector = turned_to_z_up(vector, from.up);
      pose[column] = glm::dvec4(column == 3 ? scale * vector : vector, pose[column].w);
    }
  }
}

/// "camera:A, camera:B"
std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "camera:" : ", camera:") + name;
  return list;
}

}  // namespace

CameraPath read_model_camera(const std::filesystem::path& file, const std::string& name, const ModelNotes& notes) {
  CameraMotion motion = motion_of(file, name);
  if (motion.names.empty()) throw InputError(file.string() + ": there is no camera in it");
  if (motion.poses.empty()) {
    const std::string none = name.empty() ? "its cameras are" : fmt::format("it has no camera \"{}\", but", name);
    throw InputError(fmt::format("{}: {} {}", file.string(), none, listed(motion.names)));
  }
  convert(motion, notes);
  using enum culler::Projection;
  CameraPath path;
  path.up = up_of(notes);
  path.projection = motion.lens.is_perspective ? perspective : orthographic;
  path.fov_y_deg = motion.lens.fov_y_deg;
  path.height = motion.lens.height;
  path.near = motion.lens.near;
  path.far = motion.lens.far;
  const std::string place = fmt::format("{}: camera \"{}\"", file.string(), name);
  for (const glm::dmat4& pose : motion.poses) add_keyframe(path, pose, place);
  if (path.keyframes.size() == 1) path.keyframes.push_back(path.keyframes.front());  // it stands still
  path.frames = path.keyframes.size();
  if (const auto fault = fault_of(path)) throw InputError(fmt::format("{}: {}", place, fault->text));
  return path;
}

}  // namespace occlude::render
