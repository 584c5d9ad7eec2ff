// SPDX-License-Identifier: MIT
// One primitive of a mesh: where its vertices are, and which triangles they make.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gltf_accessor.h"
#include "gltf_document.h"
#include "gltf_draco.h"

namespace occlude::render::gltf {

/// How a node shows its mesh.
struct Pose {
  std::span<const double> weights;     ///< of morph targets; empty: none is applied
  std::span<const glm::dmat4> joints;  ///< from where vertices are to where their joints take them; empty: no skin
};

class Primitive {
 public:
  /// Refuses what does not fit together. Colours of vertices are read if they are asked for.
  Primitive(const Document& document, Buffers& buffers, const json& primitive, bool with_colours);

  /// The number of vertices; 0 if the primitive has no positions.
  [[nodiscard]] std::uint64_t vertices() const { return positions_ ? positions_->size() : 0; }
  /// The accessor of the positions. REQUIRES: vertices() > 0.
  [[nodiscard]] std::uint64_t position_accessor() const { return position_accessor_; }
  [[nodiscard]] bool is_skinned() const { return !influences_.empty(); }
  [[nodiscard]] bool is_opaque() const { return is_opaque_; }
  [[nodiscard]] std::optional<std::uint64_t> material() const { return material_; }
  /// Whether vertices have colours.
  [[nodiscard]] bool is_coloured() const { return colours_.has_value(); }
  [[nodiscard]] bool is_compressed() const { return compressed_ != nullptr; }

  /// In the coordinates of the mesh or, with a skin, in those of the scene. Refuses a joint that the skin does not have.
  /// REQUIRES: vertex < vertices().
  [[nodiscard]] glm::dvec3 position(std::uint64_t vertex, const Pose& pose) const;

  /// The mean of the light of vertices. REQUIRES: is_coloured(); at least one, all below vertices().
  [[nodiscard]] glm::dvec3 light(std::span<const std::uint32_t> face) const;

  /// Points and lines, which are not drawn.
  [[nodiscard]] std::uint64_t points_and_lines() const;
  /// Triangles, and at the end a face of one or two corners where some are left over.
  [[nodiscard]] std::uint64_t faces() const;
  /// Those of three corners, which come first.
  [[nodiscard]] std::uint64_t triangles() const;
  /// The vertices of face i < faces(), in `room`. Refuses an index that is out of range.
  [[nodiscard]] std::span<std::uint32_t> face(std::uint64_t i, std::span<std::uint32_t, 3> room) const;

 private:
  enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };
  /// Up to four joints of a vertex, and how much each counts.
  struct Influence {
    Accessor joints, weights;
  };

  void read_compressed(Buffers& buffers, const json& primitive, bool with_colours);
  void read_targets(const Document& document, Buffers& buffers, const json& primitive);
  void read_influences(const Document& document, Buffers& buffers, const json& attributes);
  void read_material(const Document& document, const json& primitive);
  void read_colours(const Document& document, Buffers& buffers, const json& attributes);
  /// The attribute, which is one of each vertex, from what is compressed if it is there. Nothing if there is none of that
  /// name.
  [[nodiscard]] std::optional<Accessor> attribute(const Document& document, Buffers& buffers, const json& attributes,
                                                  const std::string& name, unsigned width,
                                                  const DracoMesh* compressed) const;
  [[nodiscard]] glm::dvec3 skinned(std::uint64_t vertex, const glm::dvec3& position,
                                   std::span<const glm::dmat4> joints) const;
  [[nodiscard]] std::uint64_t corners() const { return indices_ ? indices_->size() : vertices(); }
  [[nodiscard]] std::uint32_t vertex_of(std::uint64_t corner) const;

  Mode mode_ = Mode::triangles;
  bool is_opaque_ = true;
  std::shared_ptr<const DracoMesh> compressed_;  ///< what accessors refer to; null: they refer to buffers
  std::optional<std::uint64_t> material_;
  std::optional<Accessor> positions_, indices_, colours_;
  std::uint64_t position_accessor_ = 0;
  std::vector<std::optional<Accessor>> targets_;  ///< how morph targets move vertices; nothing: not at all
  std::vector<Influence> influences_;
};

}  // namespace occlude::render::gltf
