// SPDX-License-Identifier: MIT
// One reader of paths per format, and what they share.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "occlude/render/camera_path.h"

namespace occlude::render {

/// Nine hours at 30 frames per second. The readers check the camera of every frame, so the number must be bounded.
inline constexpr std::size_t kMostFrames = 1'000'000;

// Both throw as read_camera_path().
[[nodiscard]] CameraPath read_json_path(const std::filesystem::path& file, const PathDefaults& defaults);
/// A matrix a line: 16 or 12 numbers between commas, semicolons or blanks. Lines that begin with #, empty ones, and a first
/// one of words are skipped.
[[nodiscard]] CameraPath read_csv_path(const std::filesystem::path& file, const PathDefaults& defaults);

struct PathFault {
  std::string text;  ///< "in frame 3 ..."
  bool is_of_up;     ///< with another `up` there is none
};
/// The first frame that has no legal camera; nothing if all have.
[[nodiscard]] std::optional<PathFault> fault_of(const CameraPath& path);

}  // namespace occlude::render
