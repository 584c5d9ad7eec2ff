// SPDX-License-Identifier: MIT
// Whether a camera path was made for a model.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {

/// Why the path is probably meant for another model than the one in `file`: it names another (the kind of file does not
/// matter), or it names none and every eye and target is farther from the model's box than that is large. Empty if neither
/// is so.
[[nodiscard]] std::string doubt_about(const CameraPath& path, const std::filesystem::path& file, culler::SoupView model);

}  // namespace occlude::render
