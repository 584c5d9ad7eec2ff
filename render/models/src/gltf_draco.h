// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression. Only gltf_draco.cpp knows the library.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "gltf_accessor.h"
#include "gltf_document.h"

namespace occlude::render::gltf {

struct DracoMesh {
  struct Attribute {
    Accessor::Layout layout;  ///< never normalized: the file's accessor knows
    std::vector<std::byte> bytes;
  };

  std::vector<std::byte> triangles;  ///< three 32-bit indices each; nothing is known of these
  std::map<std::string, Attribute> attributes;

  static constexpr Accessor::Layout kTriangles{Component::uint32, false, 1};
};

/// As primitives call the colours of their vertices.
inline constexpr const char* kColours = "COLOR_0";

/// Decodes the attributes that the extension names and that say where points are, and colours if they are asked for. Refuses
/// what the library does.
[[nodiscard]] DracoMesh decode_draco(const json& extension, std::span<const std::byte> bytes, bool with_colours);

}  // namespace occlude::render::gltf
