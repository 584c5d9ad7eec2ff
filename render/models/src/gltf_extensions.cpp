// SPDX-License-Identifier: MIT
#include "gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace occlude::render::gltf {
namespace {

constexpr std::array<std::string_view, 5> kRead = {"EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
                                                   "KHR_draco_mesh_compression", "KHR_mesh_quantization",
                                                   "KHR_node_visibility"};

/// They say how surfaces look, how they are lit, how they move or what they mean.
constexpr std::array<std::string_view, 50> kWithoutGeometry = {"ADOBE_materials_clearcoat_specular",
                                                               "ADOBE_materials_clearcoat_tint",
                                                               "ADOBE_materials_thin_transparency",
                                                               "AGI_stk_metadata",
                                                               "CESIUM_primitive_outline",
                                                               "EXT_feature_metadata",
                                                               "EXT_instance_features",
                                                               "EXT_lights_ies",
                                                               "EXT_lights_image_based",
                                                               "EXT_mesh_features",
                                                               "EXT_mesh_manifold",
                                                               "EXT_structural_metadata",
                                                               "EXT_texture_avif",
                                                               "EXT_texture_webp",
                                                               "FB_geometry_metadata",
                                                               "FB_ngon_encoding",
                                                               "GRIFFEL_bim_data",
                                                               "KHR_animation_pointer",
                                                               "KHR_lights_punctual",
                                                               "KHR_materials_anisotropy",
                                                               "KHR_materials_clearcoat",
                                                               "KHR_materials_diffuse_transmission",
                                                               "KHR_materials_dispersion",
                                                               "KHR_materials_emissive_strength",
                                                               "KHR_materials_ior",
                                                               "KHR_materials_iridescence",
                                                               "KHR_materials_pbrSpecularGlossiness",
                                                               "KHR_materials_sheen",
                                                               "KHR_materials_specular",
                                                               "KHR_materials_transmission",
                                                               "KHR_materials_unlit",
                                                               "KHR_materials_variants",
                                                               "KHR_materials_volume",
                                                               "KHR_technique_webgl",
                                                               "KHR_techniques_webgl",
                                                               "KHR_texture_basisu",
                                                               "KHR_texture_transform",
                                                               "KHR_xmp",
                                                               "KHR_xmp_json_ld",
                                                               "MPEG_material_haptic",
                                                               "MSFT_lod",
                                                               "MSFT_packing_normalRoughnessMetallic",
                                                               "MSFT_packing_occlusionRoughnessMetallic",
                                                               "MSFT_texture_dds",
                                                               "NV_materials_mdl",
                                                               "OMI_physics_body",
                                                               "OMI_physics_shape",
                                                               "VRM",
                                                               "VRMC_materials_mtoon",
                                                               "VRMC_vrm"};

bool is_known(const std::string& name) {
  return std::ranges::binary_search(kRead, name) || std::ranges::binary_search(kWithoutGeometry, name);
}

std::vector<std::string> unknown_in(const Document& document, const char* list) {
  std::vector<std::string> unknown;
  for (const json& name : array_in(document.root(), list)) {
    if (!name.is_string()) refuse(fmt::format("{}: expected an array of strings", list));
    if (!is_known(name.get_ref<const std::string&>())) unknown.push_back(name.get<std::string>());
  }
  return unknown;
}

}  // namespace

std::vector<std::string> check_extensions(const Document& document) {
  static_assert(std::ranges::is_sorted(kRead) && std::ranges::is_sorted(kWithoutGeometry));
  for (const std::string& name : unknown_in(document, "extensionsRequired"))
    refuse(fmt::format("extensionsRequired: {} is not supported", name));
  const std::vector<std::string> unknown = unknown_in(document, "extensionsUsed");
  if (unknown.empty()) return {};
  return {fmt::format("what these extensions say is left out: {}", fmt::join(unknown, ", "))};
}

}  // namespace occlude::render::gltf
