// SPDX-License-Identifier: MIT
#include "occlude/render/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "extension.h"
#include "noise.h"
#include "path_readers.h"

namespace occlude::render {
namespace {

using glm::dvec3;

/// The straight line from a (t = 0) to b (t = 1), exact at both ends.
dvec3 linear(const dvec3& a, const dvec3& b, double t) { return (1 - t) * a + t * b; }

/// The uniform Catmull-Rom segment from b (t = 0) to c (t = 1), with neighbours a and d: a cubic Hermite curve with the
/// tangents (c - a) / 2 and (d - b) / 2. Exact at both ends.
dvec3 catmull_rom(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, double t) {
  const double u = 1 - t;
  const dvec3 tangent_b = 0.5 * (c - a), tangent_c = 0.5 * (d - b);
  return (1 + 2 * t) * u * u * b + t * u * u * tangent_b + t * t * (3 - 2 * t) * c - t * t * u * tangent_c;
}

/// The keyframe at `index_plus_one` - 1, which may be one beyond either end. There the path continues as the mirror image of
/// its first or last segment, so that two keyframes give a straight line.
CameraPath::Keyframe extended(const std::vector<CameraPath::Keyframe>& keys, std::size_t index_plus_one) {
  if (index_plus_one == 0) return {2.0 * keys[0].eye - keys[1].eye, 2.0 * keys[0].target - keys[1].target};
  if (index_plus_one <= keys.size()) return keys[index_plus_one - 1];
  const auto &last = keys.back(), &before = keys[keys.size() - 2];
  return {2.0 * last.eye - before.eye, 2.0 * last.target - before.target};
}

/// Whether the camera has a fault with its `up` alone.
bool is_up_at_fault(culler::Camera camera) {
  return std::ranges::any_of(std::array{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}, [&](const dvec3& other) {
    camera.up = other;
    return culler::fault(camera).empty();
  });
}

}  // namespace

culler::Camera CameraPath::camera(std::size_t frame, double aspect) const {
  // In integers, so that a frame on a keyframe is exactly there.
  const std::size_t steps = frame * (keyframes.size() - 1);
  const std::size_t segment = std::min(steps / (frames - 1), keyframes.size() - 2);
  const double t = static_cast<double>(steps - segment * (frames - 1)) / static_cast<double>(frames - 1);
  const Keyframe &from = keyframes[segment], &to = keyframes[segment + 1];

  culler::Camera camera;
  if (interpolation == Interpolation::linear) {
    camera.eye = linear(from.eye, to.eye, t);
    camera.target = linear(from.target, to.target, t);
  } else {
    const Keyframe before = extended(keyframes, segment), after = extended(keyframes, segment + 3);
    camera.eye = catmull_rom(before.eye, from.eye, to.eye, after.eye, t);
    camera.target = catmull_rom(before.target, from.target, to.target, after.target, t);
  }
  drop_noise({&camera.eye, &camera.target});
  camera.up = up;
  if (from.up || to.up) {
    camera.up = linear(from.up.value_or(up), to.up.value_or(up), t);
    drop_noise({&camera.up});
  }
  camera.projection = projection;
  camera.fov_y_deg = fov_y_deg;
  camera.height = height;
  camera.aspect = aspect;
  camera.near_plane = near;
  camera.far_plane = far;
  camera.eyes = eyes;
  return camera;
}

std::vector<culler::Camera> CameraPath::views(double aspect) const {
  constexpr std::size_t kMost = 100;
  std::vector<culler::Camera> cameras;
  for (std::size_t i = 0, count = std::min(kMost, frames); i < count; ++i) {
    cameras.push_back(camera(i * (frames - 1) / (count - 1), aspect));
  }
  return cameras;
}

std::optional<PathFault> fault_of(const CameraPath& path) {
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    const culler::Camera camera = path.camera(frame, 1);
    const std::string fault = culler::fault(camera);
    if (!fault.empty()) return PathFault{fmt::format("in frame {} {}", frame, fault), is_up_at_fault(camera)};
  }
  return std::nullopt;
}

CameraPath read_camera_path(const std::filesystem::path& file, const PathDefaults& defaults) {
  const std::string last = extension_of(file);
  const std::string extension = last == ".gz" ? extension_of(file.stem()) : last;
  const bool is_table = extension == ".csv" || extension == ".txt";
  return is_table ? read_csv_path(file, defaults) : read_json_path(file, defaults);
}

}  // namespace occlude::render
