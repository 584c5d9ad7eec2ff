// SPDX-License-Identifier: MIT
// The scene graph of a glTF file.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "gltf_document.h"

namespace occlude::render::gltf {

// The members of a node that place it below its parent: a matrix, or what gltf_transform.h makes one of.

[[nodiscard]] glm::dvec3 translation_of(const json& node);
[[nodiscard]] glm::dvec4 rotation_of(const json& node);
[[nodiscard]] glm::dvec3 scale_of(const json& node);
/// Nothing if the node has none.
[[nodiscard]] std::optional<glm::dmat4> matrix_of(const json& node);

/// All nodes, as trees. Refuses a node with two parents or among its own ancestors.
class Nodes {
 public:
  explicit Nodes(const Document& document);

  /// From the node's coordinates to those of the scene.
  [[nodiscard]] const glm::dmat4& world(std::uint64_t index) const { return nodes_[index].world; }
  /// The nodes that a member of an object lists.
  [[nodiscard]] std::vector<std::uint64_t> listed_in(const json& object, const char* name) const;
  /// The visible nodes of the scene that is shown, or of all trees if none is said to be, each before its children, in the
  /// order of the file.
  [[nodiscard]] std::vector<std::uint64_t> shown() const;

 private:
  struct Node {
    std::vector<std::uint64_t> children;
    bool has_parent = false;
    bool is_visible = true;
    glm::dmat4 world{1};
  };

  void read(std::uint64_t index);
  [[nodiscard]] std::vector<std::uint64_t> roots() const;
  [[nodiscard]] std::vector<std::uint64_t> roots_of_scene(std::uint64_t scene) const;
  [[nodiscard]] std::vector<std::uint64_t> trees_of(const std::vector<std::uint64_t>& roots) const;

  const Document& document_;
  std::vector<Node> nodes_;
};

}  // namespace occlude::render::gltf
