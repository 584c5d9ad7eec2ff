// SPDX-License-Identifier: MIT
#include "occlude/render/model_parts.h"

#include <algorithm>
#include <cstddef>

#include "extension.h"
#include "occlude/render/errors.h"
#include "part_readers.h"

namespace occlude::render {
namespace {

[[noreturn]] void refuse_format(const std::filesystem::path& file) {
  throw InputError(file.string() + ": faces are left out of PLY, OBJ and glTF, not of this format");
}

}  // namespace

FileParts parts_of(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".ply") return ply_parts(file);
  if (extension == ".obj") return obj_parts(file);
  if (is_gltf(file)) return gltf_parts(file);
  refuse_format(file);
}

std::vector<bool> owners_gone(const std::vector<ModelPart>& parts, const std::vector<bool>& gone) {
  std::vector<bool> goes;
  for (const ModelPart& part : parts) {
    goes.resize(std::max<std::size_t>(goes.size(), part.owner + 1));
    goes[part.owner] = true;
  }
  for (const ModelPart& part : parts) {
    const auto first = gone.begin() + static_cast<std::ptrdiff_t>(part.first),
               end = first + static_cast<std::ptrdiff_t>(part.count);
    if (part.count == 0 || std::find(first, end, false) != end) goes[part.owner] = false;
  }
  return goes;
}

std::string without_faces(const std::filesystem::path& file, const std::vector<bool>& gone) {
  const std::string extension = extension_of(file);
  if (extension == ".ply") return ply_without(file, gone);
  if (extension == ".obj") return obj_without(file, gone);
  if (is_gltf(file)) return gltf_without(file, gone);
  refuse_format(file);
}

}  // namespace occlude::render
