// SPDX-License-Identifier: MIT
// A model's file without some of its faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace occlude::render {

/// Faces of a file that belong together: those of a primitive of a node in glTF, of an object, group and material in OBJ,
/// all of PLY. Faces are numbered as in Model.
struct ModelPart {
  std::string node;                ///< what shows them, for people: a node, an object, a group; or empty
  std::vector<std::string> names;  ///< of the node and those above it, its mesh and its material, as far as they have one
  std::uint64_t first = 0, count = 0;
  std::uint64_t owner = 0;  ///< the number of the node; nothing of it is left where all parts of it go
  std::uint64_t shape = 0;  ///< parts with the same shape show the same faces of the file, one by one in the same order
  bool is_fixed = false;    ///< none of its faces can be left out
};

/// What a file has beside geometry.
struct FileParts {
  std::vector<ModelPart> parts;    ///< in the order of the faces
  std::vector<std::string> files;  ///< that it names: pictures, buffers, materials
  bool has_motion = false;         ///< it has animations, too
};

/// Of a PLY, OBJ or glTF file. Throws InputError for other files, and as read_model().
[[nodiscard]] FileParts parts_of(const std::filesystem::path& file);

/// Whether all of an owner goes: it has no part without faces, and `gone` has all faces of each.
[[nodiscard]] std::vector<bool> owners_gone(const std::vector<ModelPart>& parts, const std::vector<bool>& gone);

/// The bytes of the file without these faces: everything else is as it is there, vertices too. In glTF a primitive without
/// faces goes, and a node of which all goes shows no mesh.
/// Throws as parts_of(). REQUIRES: `gone` has a value for each face; none is of a part that is fixed, and parts with the
/// same shape have the same, but for those of owners that go.
[[nodiscard]] std::string without_faces(const std::filesystem::path& file, const std::vector<bool>& gone);

}  // namespace occlude::render
