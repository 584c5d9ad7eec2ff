// SPDX-License-Identifier: MIT
// A camera path through a model: keyframes and their interpolation.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

struct CameraPath {
  struct Keyframe {
    glm::dvec3 eye, target;
    std::optional<glm::dvec3> up = std::nullopt;  ///< of a camera that is tilted; else that of the path
  };
  enum class Interpolation { linear, smooth };

  std::string model;  ///< file name of the model that the path was made for; may be empty
  std::size_t frames = 0;
  std::vector<Keyframe> keyframes;  ///< at least two
  Interpolation interpolation = Interpolation::linear;
  culler::Projection projection = culler::Projection::perspective;
  double fov_y_deg = 60;
  double height = 100;  ///< orthographic only, model units
  double near = 0.1;
  double far = std::numeric_limits<double>::infinity();
  glm::dvec3 up{0, 0, 1};
  culler::EyeRegion eyes{};  ///< of each frame, relative to its eye; not part of a file
  std::size_t noise = 0;     ///< numbers of the file that are nearer to 0 than 2^-100, which were taken as 0

  /// The camera of `frame`. Eye and target move from the first keyframe (frame 0) to the last (frame frames - 1). Keyframes
  /// are equally spaced in time. `linear` joins them by straight lines, `smooth` by a Catmull-Rom spline. What rounding
  /// leaves of a coordinate that is zero is 0.
  [[nodiscard]] culler::Camera camera(std::size_t frame, double aspect) const;
  /// The cameras of its frames: all of them or, if they are more than a hundred, so many, from the first to the last.
  [[nodiscard]] std::vector<culler::Camera> views(double aspect) const;
};

/// The order in which a matrix is written: row by row, or column by column.
enum class MatrixOrder { row, column };

/// What a file of a path may leave open.
struct PathDefaults {
  glm::dvec3 up{0, 0, 1};
  std::optional<MatrixOrder> order;
};

/// Reads keyframes (JSON) or matrices (JSON, or CSV in a file *.csv or *.txt), which place the camera: it looks along its
/// -z axis, with its y axis upwards. Numbers nearer to 0 than 2^-100 are taken as 0 beside large ones.
/// Throws InputError, naming the file and the member, for anything that the format does not allow: fewer than two keyframes,
/// fewer than two or more than a million frames, coordinates that read_model would refuse, a frame whose eye equals its
/// target or whose up direction is parallel to the line of sight, near <= 0, far <= near, an unknown interpolation or
/// projection, orthographic without height, matrices of which nothing tells the order. Unknown members are ignored.
[[nodiscard]] CameraPath read_camera_path(const std::filesystem::path& file, const PathDefaults& defaults = {});

/// The path as a JSON file: the same bytes on every machine; numbers read back to the same double.
[[nodiscard]] std::string json_of(const CameraPath& path);
/// Writes that. The caller commits the file.
void write_camera_path(OutputFile& output, const CameraPath& path);

}  // namespace occlude::render
