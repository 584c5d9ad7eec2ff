// SPDX-License-Identifier: MIT
// Parts of models (model_parts.h), for each format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "occlude/render/model_parts.h"

namespace occlude::render {

[[nodiscard]] FileParts ply_parts(const std::filesystem::path& file);
[[nodiscard]] FileParts obj_parts(const std::filesystem::path& file);
[[nodiscard]] FileParts gltf_parts(const std::filesystem::path& file);

// REQUIRES: as without_faces().
[[nodiscard]] std::string ply_without(const std::filesystem::path& file, const std::vector<bool>& gone);
[[nodiscard]] std::string obj_without(const std::filesystem::path& file, const std::vector<bool>& gone);
[[nodiscard]] std::string gltf_without(const std::filesystem::path& file, const std::vector<bool>& gone);

}  // namespace occlude::render
