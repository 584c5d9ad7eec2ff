// SPDX-License-Identifier: MIT
#include "gltf_draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <utility>

namespace occlude::render::gltf {
namespace {

std::unique_ptr<draco::Mesh> decode_mesh(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) refuse(fmt::format("the data is damaged: {}", mesh.status().error_msg_string()));
  return std::move(mesh).value();
}

Component component_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return Component::int8;
    case draco::DT_UINT8:
      return Component::uint8;
    case draco::DT_INT16:
      return Component::int16;
    case draco::DT_UINT16:
      return Component::uint16;
    case draco::DT_UINT32:
      return Component::uint32;
    case draco::DT_FLOAT32:
      return Component::float32;
    default:
      refuse("its numbers have a type that glTF has not");
  }
}

/// The attribute of each point.
DracoMesh::Attribute attribute_of(const draco::Mesh& mesh, std::uint64_t id) {
  const draco::PointAttribute* const attribute =
      id <= UINT32_MAX ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id)) : nullptr;
  if (attribute == nullptr) refuse(fmt::format("attribute {}: there is none", id));
  const bool is_of_all = attribute->is_mapping_identity() || attribute->indices_map_size() >= mesh.num_points();
  if (attribute->buffer() == nullptr || !is_of_all) refuse("the data is damaged");
  const Component component = component_of(attribute->data_type());
  DracoMesh::Attribute result{{component, false, attribute->num_components()}, {}};
  const std::size_t size = size_of(component) * result.layout.width;
  const draco::DataBuffer& buffer = *attribute->buffer();
  result.bytes.resize(mesh.num_points() * size);
  for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
    const auto from = static_cast<std::uint64_t>(attribute->GetBytePos(attribute->mapped_index(draco::PointIndex(point))));
    if (from > buffer.data_size() || size > buffer.data_size() - from) refuse("the data is damaged");
    buffer.Read(static_cast<std::int64_t>(from), result.bytes.data() + point * size, size);
  }
  return result;
}

std::vector<std::byte> triangles_of(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    for (const draco::PointIndex& point : mesh.face(draco::FaceIndex(i))) indices.push_back(point.value());
  }
  const auto bytes = std::as_bytes(std::span(indices));
  return {bytes.begin(), bytes.end()};
}

bool is_of_points(std::string_view name) {
  return name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
}

}  // namespace

DracoMesh decode_draco(const json& extension, std::span<const std::byte> bytes, bool with_colours) {
  const std::unique_ptr<draco::Mesh> mesh = decode_mesh(bytes);
  DracoMesh result{triangles_of(*mesh), {}};
  const json& attributes = object_in(extension, "attributes");
  for (const auto& [name, id] : attributes.items()) {
    if (is_of_points(name) || (with_colours && name == kColours))
      result.attributes.emplace(name, attribute_of(*mesh, whole_in(attributes, name.c_str())));
  }
  return result;
}

}  // namespace occlude::render::gltf
