// SPDX-License-Identifier: MIT
// What the scene of a glTF file shows, in the order in which its triangles are numbered.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "gltf_document.h"
#include "gltf_meshes.h"
#include "gltf_nodes.h"
#include "gltf_primitive.h"

namespace occlude::render::gltf {

/// A primitive of the mesh of a node, at one of its instances.
struct Shown {
  std::uint64_t node, mesh;
  std::size_t number;  ///< of the primitive in the mesh
  const Primitive& primitive;
  const glm::dmat4& instance;
};

/// Calls take(shown) for each. An InputError gets the names of node, mesh and primitive.
template <class Take>
void for_each_shown(const Document& document, const Nodes& nodes, Meshes& meshes, const Take& take) {
  const auto visit = [&](std::uint64_t node) {
    const json& object = document.item(kNodes, node);
    const std::uint64_t mesh = whole_in(object, "mesh");
    const std::vector<Primitive>& primitives = meshes.mesh(mesh);
    for (const glm::dmat4& instance : meshes.instances(object)) {
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        at([&] { return fmt::format("{}: primitive {}", document.label(kMeshes, mesh), i); },
           [&] {
             take(Shown{node, mesh, i, primitives[i], instance});
           });
      }
    }
  };
  for (const std::uint64_t node : nodes.shown()) {
    if (find(document.item(kNodes, node), "mesh") == nullptr) continue;
    at([&] { return document.label(kNodes, node); }, [&] { visit(node); });
  }
}

}  // namespace occlude::render::gltf
