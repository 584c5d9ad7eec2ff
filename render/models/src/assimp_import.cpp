// SPDX-License-Identifier: MIT
#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assimp_scene.h"
#include "colours.h"
#include "import_child.h"
#include "model_builder.h"
#include "model_check.h"
#include "model_readers.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

/// Whether the material lets light through: an opacity below 1, or a picture of it. Where the importer cannot tell, it does
/// not.
bool is_see_through(const aiMaterial& material) {
  float opacity = 1;
  aiString mode;
  return (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity < 1) ||
         material.GetTextureCount(aiTextureType_OPACITY) > 0 ||
         (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS && mode != aiString("OPAQUE"));
}

/// White where the importer cannot tell.
Rgb colour_of(const aiMaterial& material) {
  aiColor4D colour(1, 1, 1, 1);
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  return rgb_of({colour.r, colour.g, colour.b});
}

/// Where a node is, in the coordinates of the scene, and how exactly: the library gives its own placement and those above it
/// in single precision.
struct Placement {
  glm::dmat4 matrix{1}, magnitude{1};  ///< magnitude: the product of the magnitudes of what the matrix is the product of
  unsigned roundings = 0;

  [[nodiscard]] Placement then(const glm::dmat4& local) const {
    if (local == glm::dmat4(1)) return *this;
    glm::dmat4 sizes;
    for (int i = 0; i < 4; ++i) sizes[i] = glm::abs(local[i]);
    return {matrix * local, magnitude * sizes, roundings + 1};
  }
  [[nodiscard]] glm::dvec3 of(const glm::dvec3& v) const { return glm::dvec3(matrix * glm::dvec4(v, 1)); }
  /// By how much a vertex may be off that has no coordinate above those of `most`, each number rounded once.
  [[nodiscard]] double error(const glm::dvec3& most) const {
    constexpr double kRounding = 0x1p-24;
    const glm::dvec4 reached = magnitude * glm::dvec4(most, 1);
    return (roundings + 1) * kRounding * std::max({reached.x, reached.y, reached.z});
  }
};

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, const ImportedScene& imported, bool with_colours)
      : file_(file), scene_(imported.scene()), builder_(with_colours) {
    builder_.notes().file = imported.convention();
  }

  Model read() {
    // An explicit stack: the file decides how deep the tree is.
    std::vector<std::pair<const aiNode*, Placement>> stack = {{scene_.mRootNode, {}}};
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      const Placement placement = parent.then(placement_of(*node));
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add_mesh(node->mMeshes[i], placement);
      for (unsigned i = node->mNumChildren; i-- > 0;) stack.emplace_back(node->mChildren[i], placement);
    }
    Model model = builder_.finish(file_);
    warn_of_rounding(model);
    return model;
  }

 private:
  /// Of an error that may show: parts that fit no longer.
  static void warn_of_rounding(Model& model) {
    constexpr double kShows = 0x1p-20;  // of the size of the model: sixteen times what single precision costs at its origin
    glm::dvec3 low = model.soup.vertices.front(), high = low;
    for (const glm::dvec3& v : model.soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
    const glm::dvec3 size = high - low;
    if (model.notes.rounding > kShows * std::max({size.x, size.y, size.z}))
      model.notes.warnings.push_back(
          fmt::format("the import library has single precision: coordinates may be off by {:.1g}", model.notes.rounding));
  }

  static bool is_polygon(const aiFace& face) { return face.mNumIndices >= 3; }

  [[nodiscard]] std::string place(unsigned mesh, const char* what, unsigned index) const {
    return fmt::format("{}: mesh {}: {} {}", file_.string(), mesh, what, index);
  }

  void add_mesh(unsigned index, const Placement& placement) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) check_face(index, i);
    add_vertices(index, placement);
    const Surface surface = surface_of(mesh);
    const std::span<const aiFace> faces(mesh.mFaces, mesh.mNumFaces);
    // The library does not tell a line from a face of two corners. Who writes lines makes a mesh of them.
    ModelNotes& notes = builder_.notes();
    std::size_t& others = std::ranges::any_of(faces, is_polygon) ? notes.few_corners : notes.points_and_lines;
    for (const aiFace& face : faces) {
      if (is_polygon(face)) {
        add_face(face, surface);
      } else {
        ++others;
      }
    }
  }

  [[nodiscard]] Surface surface_of(const aiMesh& mesh) const {
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) return {};
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    return {!is_see_through(material), colour_of(material)};
  }

  void check_face(unsigned mesh, unsigned index) const {
    const aiFace& face = scene_.mMeshes[mesh]->mFaces[index];
    const unsigned vertices = scene_.mMeshes[mesh]->mNumVertices;
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
      if (vertex >= vertices) {
        throw InputError(
            fmt::format("{}: vertex index {} is out of range ({} vertices)", place(mesh, "face", index), vertex, vertices));
      }
    }
  }

  /// Only the vertices that polygons use: an importer can create any number of others from a short file.
  void add_vertices(unsigned index, const Placement& placement) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    std::vector<bool> is_used(mesh.mNumVertices);
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      if (!is_polygon(face)) continue;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) is_used[vertex] = true;
    }
    places_.resize(mesh.mNumVertices);
    glm::dvec3 most(0);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      if (!is_used[i]) {
        ++builder_.notes().unused_vertices;
        continue;
      }
      const glm::dvec3 v(mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
      most = glm::max(most, glm::abs(v));
      places_[i] = builder_.add_vertex(placement.of(v), [&] { return place(index, "vertex", i); });
    }
    double& rounding = builder_.notes().rounding;
    rounding = std::max(rounding, placement.error(most));
  }

  void add_face(const aiFace& face, const Surface& surface) {
    loop_.clear();
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) loop_.push_back(places_[vertex]);
    builder_.add_face(loop_, surface);
  }

  const std::filesystem::path& file_;
  const aiScene& scene_;
  ModelBuilder builder_;
  std::vector<std::uint32_t> places_;  ///< indices of the mesh's vertices in the soup
  std::vector<std::uint32_t> loop_;
};

}  // namespace

Model import_with_assimp(const std::filesystem::path& file, CountedFiles& files, bool with_colours) {
  const ImportedScene imported(file, files);
  return SceneReader(file, imported, with_colours).read();
}

Model read_with_assimp(const std::filesystem::path& file, bool with_colours) {
  Model model = import_in_child(file, kImportLibrary,
                                [&](CountedFiles& files) { return import_with_assimp(file, files, with_colours); });
  require_usable(file, model.soup);
  return model;
}

}  // namespace occlude::render
