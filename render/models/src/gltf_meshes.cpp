// SPDX-License-Identifier: MIT
#include "gltf_meshes.h"

#include <fmt/format.h>

#include <optional>

#include "gltf_transform.h"

namespace occlude::render::gltf {

const std::vector<Primitive>& Meshes::mesh(std::uint64_t index) {
  const auto [known, is_new] = meshes_.try_emplace(index);
  std::vector<Primitive>& read = known->second;
  if (!is_new) return read;
  const json& mesh = document_.item(kMeshes, index);
  at([&] { return document_.label(kMeshes, index); },
     [&] {
       const json& primitives = array_in(mesh, "primitives");
       for (std::size_t i = 0; i < primitives.size(); ++i) {
         at([&] { return fmt::format("primitive {}", i); },
            [&] {
              if (!primitives[i].is_object()) refuse("expected an object");
              read.emplace_back(document_, buffers_, primitives[i], with_colours_);
            });
       }
     });
  return read;
}

const std::vector<glm::dmat4>& Meshes::skin(std::uint64_t index) {
  const auto [known, is_new] = skins_.try_emplace(index);
  std::vector<glm::dmat4>& matrices = known->second;
  if (!is_new) return matrices;
  const json& skin = document_.item(kSkins, index);
  at([&] { return document_.label(kSkins, index); },
     [&] {
       const std::vector<std::uint64_t> joints = nodes_.listed_in(skin, "joints");
       if (joints.empty()) refuse("joints: there are none");
       for (const std::uint64_t joint : joints) matrices.push_back(nodes_.world(joint));
       const auto inverse = find_whole(skin, "inverseBindMatrices");
       if (!inverse) return;
       const Accessor inverses(document_, buffers_, *inverse, 16);
       if (inverses.size() < matrices.size())
         refuse(fmt::format("inverseBindMatrices: {} for {} joints", inverses.size(), matrices.size()));
       for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] = matrices[i] * inverses.mat4(i);
     });
  return matrices;
}

std::vector<glm::dmat4> Meshes::instances(const json& node) {
  const json* const extension = find_extension(node, "EXT_mesh_gpu_instancing");
  if (extension == nullptr) return {glm::dmat4(1)};
  return at([] { return "EXT_mesh_gpu_instancing"; },
            [&] {
              const json& attributes = object_in(*extension, "attributes");
              std::optional<std::uint64_t> count;
              const auto attribute = [&](const char* name, unsigned width) -> std::optional<Accessor> {
                const auto index = find_whole(attributes, name);
                if (!index) return std::nullopt;
                Accessor accessor(document_, buffers_, *index, width);
                if (count.value_or(accessor.size()) != accessor.size())
                  refuse(fmt::format("{}: {} instances instead of {}", name, accessor.size(), *count));
                count = accessor.size();
                return accessor;
              };
              const auto translation = attribute("TRANSLATION", 3), rotation = attribute("ROTATION", 4),
                         scale = attribute("SCALE", 3);
              std::vector<glm::dmat4> instances;
              for (std::uint64_t i = 0; i < count.value_or(0); ++i) {
                instances.push_back(placement(translation ? translation->vec3(i) : glm::dvec3(0),
                                              rotation ? rotation->vec4(i) : glm::dvec4(0, 0, 0, 1),
                                              scale ? scale->vec3(i) : glm::dvec3(1)));
              }
              return instances;
            });
}

}  // namespace occlude::render::gltf
