// SPDX-License-Identifier: MIT
#include "gltf_primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "gltf_transform.h"

namespace occlude::render::gltf {
namespace {

/// Whether one sees through a surface, wholly or in places.
bool lets_light_through(const json& material) {
  if (text_in(material, "alphaMode", "OPAQUE") != "OPAQUE") return true;
  for (const char* const name : {"KHR_materials_transmission", "ADOBE_materials_thin_transparency"}) {
    const json* const extension = find_extension(material, name);
    if (extension != nullptr && number_in(*extension, "transmissionFactor", 0) > 0) return true;
  }
  return false;
}

}  // namespace

Primitive::Primitive(const Document& document, Buffers& buffers, const json& primitive, bool with_colours) {
  const std::uint64_t mode = find_whole(primitive, "mode").value_or(static_cast<std::uint64_t>(Mode::triangles));
  if (mode > static_cast<std::uint64_t>(Mode::triangle_fan)) refuse(fmt::format("mode: {} is not one of glTF", mode));
  mode_ = static_cast<Mode>(mode);
  read_material(document, primitive);
  read_compressed(buffers, primitive, with_colours);
  const json& attributes = object_in(primitive, "attributes");
  positions_ = attribute(document, buffers, attributes, "POSITION", 3, compressed_.get());
  if (!positions_) return;
  position_accessor_ = whole_in(attributes, "POSITION");
  if (const auto indices = find_whole(primitive, "indices"); indices && !indices_) {
    at([] { return "indices"; },
       [&] {
         indices_.emplace(document, buffers, *indices, 1);
         if (!indices_->is_unsigned()) refuse("expected unsigned integers");
       });
  }
  read_targets(document, buffers, primitive);
  read_influences(document, buffers, attributes);
  if (with_colours) read_colours(document, buffers, attributes);
}

void Primitive::read_material(const Document& document, const json& primitive) {
  material_ = find_whole(primitive, "material");
  if (!material_) return;
  const json& material = document.item(kMaterials, *material_);
  is_opaque_ = at([&] { return document.label(kMaterials, *material_); }, [&] { return !lets_light_through(material); });
}

void Primitive::read_compressed(Buffers& buffers, const json& primitive, bool with_colours) {
  const json* const extension = find_extension(primitive, "KHR_draco_mesh_compression");
  if (extension == nullptr) return;
  at([] { return "KHR_draco_mesh_compression"; },
     [&] {
       compressed_ = std::make_shared<const DracoMesh>(
           decode_draco(*extension, buffers.view(whole_in(*extension, "bufferView")).bytes, with_colours));
     });
  indices_.emplace(DracoMesh::kTriangles, compressed_->triangles);
  mode_ = Mode::triangles;
}

std::optional<Accessor> Primitive::attribute(const Document& document, Buffers& buffers, const json& attributes,
                                             const std::string& name, unsigned width, const DracoMesh* compressed) const {
  const auto index = find_whole(attributes, name.c_str());
  if (!index) return std::nullopt;
  return at([&] { return name; },
            [&] {
              const auto read = [&] {
                if (compressed == nullptr || !compressed->attributes.contains(name))
                  return Accessor(document, buffers, *index, width);
                const auto& [layout, bytes] = compressed->attributes.at(name);
                if (layout.width != width) refuse(fmt::format("{} components instead of {}", layout.width, width));
                const bool is_normalized = flag_in(document.item(kAccessors, *index), "normalized", false);
                return Accessor({layout.component, is_normalized, width}, bytes);
              };
              Accessor accessor = read();
              if (positions_ && accessor.size() != vertices())
                refuse(fmt::format("{} elements for {} vertices", accessor.size(), vertices()));
              return std::optional(std::move(accessor));
            });
}

void Primitive::read_targets(const Document& document, Buffers& buffers, const json& primitive) {
  const json& targets = array_in(primitive, "targets");
  for (std::size_t i = 0; i < targets.size(); ++i) {
    at([&] { return fmt::format("target {}", i); },
       [&] {
         if (!targets[i].is_object()) refuse("expected an object");
         targets_.push_back(attribute(document, buffers, targets[i], "POSITION", 3, nullptr));
       });
  }
}

void Primitive::read_influences(const Document& document, Buffers& buffers, const json& attributes) {
  for (int set = 0;; ++set) {
    auto joints = attribute(document, buffers, attributes, fmt::format("JOINTS_{}", set), 4, compressed_.get());
    auto weights = attribute(document, buffers, attributes, fmt::format("WEIGHTS_{}", set), 4, compressed_.get());
    if (!joints || !weights) return;
    if (!joints->is_unsigned()) refuse(fmt::format("JOINTS_{}: expected unsigned integers", set));
    influences_.push_back({*std::move(joints), *std::move(weights)});
  }
}

void Primitive::read_colours(const Document& document, Buffers& buffers, const json& attributes) {
  const auto index = find_whole(attributes, kColours);
  if (!index) return;
  const std::string type =
      at([] { return kColours; }, [&] { return text_in(document.item(kAccessors, *index), "type", ""); });
  colours_ = attribute(document, buffers, attributes, kColours, type == "VEC4" ? 4 : 3, compressed_.get());
}

glm::dvec3 Primitive::light(std::span<const std::uint32_t> face) const {
  glm::dvec3 sum(0);
  for (const std::uint32_t vertex : face) sum += colours_->vec3(vertex);
  return sum / static_cast<double>(face.size());
}

glm::dvec3 Primitive::position(std::uint64_t vertex, const Pose& pose) const {
  glm::dvec3 position = positions_->vec3(vertex);
  for (std::size_t i = 0; i < std::min(targets_.size(), pose.weights.size()); ++i) {
    if (targets_[i] && pose.weights[i] != 0) position += pose.weights[i] * targets_[i]->vec3(vertex);
  }
  return pose.joints.empty() || !is_skinned() ? position : skinned(vertex, position, pose.joints);
}

glm::dvec3 Primitive::skinned(std::uint64_t vertex, const glm::dvec3& position, std::span<const glm::dmat4> joints) const {
  glm::dvec3 sum(0);
  double all = 0;
  for (const Influence& influence : influences_) {
    for (unsigned k = 0; k < 4; ++k) {
      const double weight = influence.weights.number(vertex, k);
      if (weight == 0) continue;
      const std::uint32_t joint = influence.joints.index(vertex, k);
      if (joint >= joints.size()) refuse(fmt::format("vertex {}: joint {} of {}", vertex, joint, joints.size()));
      sum += weight * placed(joints[joint], position);
      all += weight;
    }
  }
  if (all == 0) refuse(fmt::format("vertex {}: no joint has a weight", vertex));
  // Weights add up to 1 but for the digits that files have of them. What is missing must not move a vertex that is far out.
  return sum / all;
}

std::uint64_t Primitive::points_and_lines() const {
  const std::uint64_t count = corners();
  switch (mode_) {
    case Mode::points:
    case Mode::line_loop:
      return count;
    case Mode::lines:
      return count / 2;
    case Mode::line_strip:
      return count - std::min<std::uint64_t>(count, 1);
    default:
      return 0;
  }
}

std::uint64_t Primitive::faces() const {
  const std::uint64_t count = corners();
  switch (mode_) {
    case Mode::triangles:
      return count / 3 + (count % 3 == 0 ? 0 : 1);
    case Mode::triangle_strip:
    case Mode::triangle_fan:
      return count < 3 ? std::min<std::uint64_t>(count, 1) : count - 2;
    default:
      return 0;
  }
}

std::uint64_t Primitive::triangles() const {
  return vertices() == 0 || faces() == 0 || corners() < 3 ? 0 : mode_ == Mode::triangles ? corners() / 3 : faces();
}

std::span<std::uint32_t> Primitive::face(std::uint64_t i, std::span<std::uint32_t, 3> room) const {
  const std::uint64_t first = mode_ == Mode::triangles ? 3 * i : i;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(corners() - first, 3));
  for (std::size_t k = 0; k < count; ++k) room[k] = vertex_of(first + k);
  if (mode_ == Mode::triangle_strip && i % 2 == 1) std::swap(room[1], room[2]);
  if (mode_ == Mode::triangle_fan && count == 3) room[0] = vertex_of(0);
  return room.first(count);
}

std::uint32_t Primitive::vertex_of(std::uint64_t corner) const {
  if (indices_) {
    const std::uint32_t vertex = indices_->index(corner);
    if (vertex >= vertices()) refuse(fmt::format("indices: corner {} is vertex {} of {}", corner, vertex, vertices()));
    return vertex;
  }
  if (corner > std::numeric_limits<std::uint32_t>::max()) refuse("more than 2^32 vertices");
  return static_cast<std::uint32_t>(corner);
}

}  // namespace occlude::render::gltf
