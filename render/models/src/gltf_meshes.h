// SPDX-License-Identifier: MIT
// The meshes, skins and instances that nodes refer to. Each is read once.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <vector>

#include "gltf_buffers.h"
#include "gltf_document.h"
#include "gltf_nodes.h"
#include "gltf_primitive.h"

namespace occlude::render::gltf {

class Meshes {
 public:
  Meshes(const Document& document, Buffers& buffers, const Nodes& nodes, bool with_colours = false)
      : document_(document), buffers_(buffers), nodes_(nodes), with_colours_(with_colours) {}

  /// The primitives of a mesh.
  [[nodiscard]] const std::vector<Primitive>& mesh(std::uint64_t index);
  /// What takes a vertex with each joint of a skin from where it is in the mesh to where it is in the scene.
  [[nodiscard]] const std::vector<glm::dmat4>& skin(std::uint64_t index);
  /// The placements of what a node shows, in the node's coordinates: one, or those of EXT_mesh_gpu_instancing.
  [[nodiscard]] std::vector<glm::dmat4> instances(const json& node);

 private:
  const Document& document_;
  Buffers& buffers_;
  const Nodes& nodes_;
  const bool with_colours_;
  std::map<std::uint64_t, std::vector<Primitive>> meshes_;
  std::map<std::uint64_t, std::vector<glm::dmat4>> skins_;
};

}  // namespace occlude::render::gltf
