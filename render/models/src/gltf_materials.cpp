// SPDX-License-Identifier: MIT
#include "gltf_materials.h"

#include <algorithm>
#include <vector>

#include "colours.h"

namespace occlude::render::gltf {
namespace {

/// Nothing where there is no picture that can be read.
std::optional<glm::dvec3> mean_light(const Document& document, Buffers& buffers, std::uint64_t texture) try {
  return mean_light_of_png(buffers.image(whole_in(document.item(kTextures, texture), "source")));
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace

glm::dvec3 Materials::light(std::optional<std::uint64_t> index) {
  if (!index) return glm::dvec3(1);
  const auto [known, is_new] = materials_.try_emplace(*index);
  if (is_new) {
    known->second = at([&] { return document_.label(kMaterials, *index); },
                       [&] { return light_of(document_.item(kMaterials, *index)); });
  }
  return known->second;
}

glm::dvec3 Materials::light_of(const json& material) {
  if (find(material, "pbrMetallicRoughness") == nullptr) return glm::dvec3(1);
  const json& surface = object_in(material, "pbrMetallicRoughness");
  const auto factor = find_numbers(surface, "baseColorFactor", 4);
  const glm::dvec3 base = factor ? glm::dvec3((*factor)[0], (*factor)[1], (*factor)[2]) : glm::dvec3(1);
  if (find(surface, "baseColorTexture") == nullptr) return base;
  return base * light_of_texture(whole_in(object_in(surface, "baseColorTexture"), "index"));
}

glm::dvec3 Materials::light_of_texture(std::uint64_t index) {
  const auto [known, is_new] = textures_.try_emplace(index);
  if (is_new) known->second = mean_light(document_, buffers_, index);
  return known->second.value_or(glm::dvec3(1));
}

std::size_t Materials::unread() const {
  const auto is_unread = [](const auto& texture) { return !texture.second; };
  return static_cast<std::size_t>(std::ranges::count_if(textures_, is_unread));
}

}  // namespace occlude::render::gltf
