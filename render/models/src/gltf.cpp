// SPDX-License-Identifier: MIT
// glTF 2.0. The library that loads it for others, tinygltf, refuses files that are legal (compressed ones with a buffer that
// is not there, indices that are all zero), and reads what no triangle needs.
#include <fmt/format.h>

#include <array>
#include <map>
#include <span>
#include <vector>

#include "colours.h"
#include "gltf_buffers.h"
#include "gltf_document.h"
#include "gltf_extensions.h"
#include "gltf_file.h"
#include "gltf_materials.h"
#include "gltf_meshes.h"
#include "gltf_nodes.h"
#include "gltf_primitive.h"
#include "gltf_scene.h"
#include "gltf_transform.h"
#include "import_child.h"
#include "model_builder.h"
#include "model_check.h"
#include "model_readers.h"

namespace occlude::render {
namespace gltf {
namespace {

/// Where the vertices of what is being added are in the model. A model may have any number of others beside them.
class Places {
 public:
  explicit Places(const ModelBuilder& builder) : builder_(builder) {}

  /// From now on none is there.
  void forget() { first_ = builder_.vertices(); }
  /// Calls add(), which adds the vertex, if it is not there yet.
  template <class Add>
  std::uint32_t place(std::uint32_t vertex, const Add& add) {
    if (vertex >= ends_.size()) ends_.resize(std::size_t{vertex} + 1);
    if (ends_[vertex] <= first_) ends_[vertex] = add() + 1;
    return ends_[vertex] - 1;
  }

 private:
  const ModelBuilder& builder_;
  std::size_t first_ = 0;
  /// One more than the vertex's index in the model. The vertex is there if that is above first_.
  std::vector<std::uint32_t> ends_;
};

class SceneReader {
 public:
  SceneReader(const Document& document, Buffers& buffers, ModelBuilder& builder, bool with_colours)
      : document_(document),
        nodes_(document),
        meshes_(document, buffers, nodes_, with_colours),
        materials_(document, buffers),
        with_colours_(with_colours),
        builder_(builder) {}

  void read() {
    ModelNotes& notes = builder_.notes();
    notes.file = {1, {0, 1, 0}};
    notes.warnings = check_extensions(document_);
    for_each_shown(document_, nodes_, meshes_, [&](const Shown& shown) { add(shown); });
    for (const auto& [accessor, used] : used_) notes.unused_vertices += used.unused();
    if (const std::size_t unread = materials_.unread(); unread != 0) {
      notes.warnings.push_back(fmt::format("{} {} taken for white: only pictures in PNG are read", unread,
                                           unread == 1 ? "texture is" : "textures are"));
    }
  }

 private:
  /// Which vertices of an accessor are used. Primitives may share it.
  struct Used {
    std::uint64_t vertices = 0, count = 0;
    std::vector<bool> is_used;

    void use(std::uint32_t vertex) {
      if (vertex >= is_used.size()) is_used.resize(std::size_t{vertex} + 1);
      if (!is_used[vertex]) ++count;
      is_used[vertex] = true;
    }
    [[nodiscard]] std::uint64_t unused() const { return vertices - count; }
  };

  void add(const Shown& shown) {
    const json& node = document_.item(kNodes, shown.node);
    const std::vector<double> weights = weights_of(node, shown.mesh);
    const auto skin = find_whole(node, "skin");
    const Pose pose{weights, skin ? std::span(meshes_.skin(*skin)) : std::span<const glm::dmat4>()};
    // What joints move is where they say, wherever the node is.
    const bool is_skinned = skin && shown.primitive.is_skinned();
    add_primitive(shown.primitive, is_skinned ? shown.instance : nodes_.world(shown.node) * shown.instance, pose);
  }

  [[nodiscard]] std::vector<double> weights_of(const json& node, std::uint64_t mesh) const {
    auto weights = find_numbers(node, "weights");
    if (!weights) weights = find_numbers(document_.item(kMeshes, mesh), "weights");
    return weights.value_or(std::vector<double>());
  }

  void add_primitive(const Primitive& primitive, const glm::dmat4& matrix, const Pose& pose) {
    if (primitive.vertices() == 0) return;
    builder_.notes().points_and_lines += primitive.points_and_lines();
    Used& used = used_[primitive.position_accessor()];
    used.vertices = primitive.vertices();
    const auto add_vertex = [&](std::uint32_t vertex) {
      used.use(vertex);
      return builder_.add_vertex(placed(matrix, primitive.position(vertex, pose)),
                                 [&] { return fmt::format("vertex {}", vertex); });
    };
    const glm::dvec3 base = with_colours_ ? materials_.light(primitive.material()) : glm::dvec3(1);
    Surface surface{primitive.is_opaque(), rgb_of_light(base)};
    places_.forget();
    std::array<std::uint32_t, 3> room{};
    for (std::uint64_t i = 0, faces = primitive.faces(); i < faces; ++i) {
      const std::span<std::uint32_t> face = primitive.face(i, room);
      if (primitive.is_coloured()) surface.colour = rgb_of_light(base * primitive.light(face));
      for (std::uint32_t& corner : face) corner = places_.place(corner, [&, vertex = corner] { return add_vertex(vertex); });
      builder_.add_face(face, surface);
    }
  }

  const Document& document_;
  const Nodes nodes_;
  Meshes meshes_;
  Materials materials_;
  const bool with_colours_;
  ModelBuilder& builder_;
  Places places_{builder_};
  std::map<std::uint64_t, Used> used_;  ///< by accessor
};

}  // namespace
}  // namespace gltf

Model read_gltf(const std::filesystem::path& file, bool with_colours) {
  Model model = import_in_child(file, gltf::kReader, [&](CountedFiles& files) {
    ModelBuilder builder(with_colours);
    try {
      gltf::of_file(file, files, [&](const gltf::Document& document, gltf::Buffers& buffers) {
        gltf::SceneReader(document, buffers, builder, with_colours).read();
      });
    } catch (const gltf::OldVersion&) {
      return import_with_assimp(file, files, with_colours);
    }
    return builder.finish(file);
  });
  require_usable(file, model.soup);
  return model;
}

}  // namespace occlude::render
