// SPDX-License-Identifier: MIT
// A file as the import library reads it, in the child process of an import.
#pragma once

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <string_view>

#include "counted_files.h"
#include "occlude/render/convention.h"

namespace occlude::render {

/// As messages name it.
inline constexpr std::string_view kImportLibrary = "the import library";

/// Below its parent, in doubles.
[[nodiscard]] inline glm::dmat4 placement_of(const aiNode& node) {
  const aiMatrix4x4& m = node.mTransformation;  // stores rows, glm columns
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

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
