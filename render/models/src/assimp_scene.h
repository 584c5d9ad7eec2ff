// SPDX-License-Identifier: MIT
// A file as the import library reads it, in the child process of an import.
#pragma once

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <string_view>

#include "counted_files.h"
#include "occlude/render/convention.h"

namespace occlude::render {

/// As messages name it.
inline constexpr std::string_view kImportLibrary = "the import library";

class ImportedScene {
 public:
  /// Throws InputError if the library cannot read the file.
  ImportedScene(const std::filesystem::path& file, CountedFiles& counted);

  /// Its coordinates are those of the file.
  [[nodiscard]] const aiScene& scene() const { return *scene_; }
  /// What the file says of them.
  [[nodiscard]] const Convention& convention() const { return convention_; }

 private:
  Assimp::Importer importer_;
  const aiScene* scene_;
  Convention convention_;
};

}  // namespace occlude::render
