// SPDX-License-Identifier: MIT
// What files are called by.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace occlude::render {

/// The extension of a file's name in small letters: ".dae".
[[nodiscard]] inline std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

/// Whether it is read by the reader of glTF.
[[nodiscard]] inline bool is_gltf(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return extension == ".gltf" || extension == ".glb";
}

}  // namespace occlude::render
