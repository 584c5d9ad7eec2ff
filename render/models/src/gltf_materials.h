// SPDX-License-Identifier: MIT
// How the materials of a glTF file look.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>

#include "gltf_buffers.h"
#include "gltf_document.h"

namespace occlude::render::gltf {

/// Reads each picture when it is first asked for.
class Materials {
 public:
  Materials(const Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

  /// The light of its base colour, times the mean of its texture. White where it has none, and for no material.
  [[nodiscard]] glm::dvec3 light(std::optional<std::uint64_t> index);
  /// How many textures were asked for that cannot be read, and are white.
  [[nodiscard]] std::size_t unread() const;

 private:
  [[nodiscard]] glm::dvec3 light_of(const json& material);
  [[nodiscard]] glm::dvec3 light_of_texture(std::uint64_t index);

  const Document& document_;
  Buffers& buffers_;
  std::map<std::uint64_t, glm::dvec3> materials_;
  std::map<std::uint64_t, std::optional<glm::dvec3>> textures_;
};

}  // namespace occlude::render::gltf
