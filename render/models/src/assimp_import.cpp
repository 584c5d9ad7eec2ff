// SPDX-License-Identifier: MIT
#include <assimp/DefaultIOSystem.h>
#include <assimp/GltfMaterial.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cstdint>
#include <exception>
#include <glm/mat4x4.hpp>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "counted_files.h"
#include "import_child.h"
#include "model_builder.h"
#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/printable.h"

namespace occlude::render {
namespace {

glm::dmat4 to_double(const aiMatrix4x4& m) {
  // Assimp stores rows, glm columns.
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

/// Whether the material lets light through: an opacity below 1, or a picture of it. Where the importer cannot tell, it does
/// not.
bool is_see_through(const aiMaterial& material) {
  float opacity = 1;
  aiString mode;
  return (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity < 1) ||
         material.GetTextureCount(aiTextureType_OPACITY) > 0 ||
         (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS && mode != aiString("OPAQUE"));
}

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, const aiScene& scene) : file_(file), scene_(scene) {}

  Model read() {
    // An explicit stack: the file decides how deep the tree is.
    std::vector<Placed> stack = {{scene_.mRootNode, glm::dmat4(1)}};
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      const glm::dmat4 transform = parent * to_double(node->mTransformation);
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add_mesh(node->mMeshes[i], transform);
      for (unsigned i = node->mNumChildren; i-- > 0;) stack.push_back({node->mChildren[i], transform});
    }
    return builder_.finish(file_);
  }

 private:
  struct Placed {
    const aiNode* node;
    glm::dmat4 parent;
  };

  /// False for points and lines.
  static bool is_polygon(const aiFace& face) { return face.mNumIndices >= 3; }

  [[nodiscard]] std::string place(unsigned mesh, const char* what, unsigned index) const {
    return fmt::format("{}: mesh {}: {} {}", file_.string(), mesh, what, index);
  }

  void add_mesh(unsigned index, const glm::dmat4& transform) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) check_face(index, i);
    add_vertices(index, transform);
    const bool is_opaque =
        mesh.mMaterialIndex >= scene_.mNumMaterials || !is_see_through(*scene_.mMaterials[mesh.mMaterialIndex]);
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) add_face(face, is_opaque);
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
  void add_vertices(unsigned index, const glm::dmat4& transform) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    std::vector<bool> is_used(mesh.mNumVertices);
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      if (!is_polygon(face)) continue;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) is_used[vertex] = true;
    }
    places_.resize(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      if (!is_used[i]) continue;
      const aiVector3D& v = mesh.mVertices[i];
      places_[i] = builder_.add_vertex(glm::dvec3(transform * glm::dvec4(v.x, v.y, v.z, 1)),
                                       [&] { return place(index, "vertex", i); });
    }
  }

  void add_face(const aiFace& face, bool is_opaque) {
    if (!is_polygon(face)) {
      ++builder_.notes().points_and_lines;
      return;
    }
    loop_.clear();
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) loop_.push_back(places_[vertex]);
    builder_.add_face(loop_, is_opaque);
  }

  const std::filesystem::path& file_;
  const aiScene& scene_;
  ModelBuilder builder_;
  std::vector<std::uint32_t> places_;  ///< indices of the mesh's vertices in the soup
  std::vector<std::uint32_t> loop_;
};

/// Opens files for an importer.
class ImporterFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ImporterFiles(CountedFiles& files) : files_(files) {}

  bool Exists(const char* file) const override {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
  }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    try {
      files_.count(file);
    } catch (const InputError& error) {
      // Importers can do without missing files.
      if (fault_.empty() && Exists(file)) fault_ = error.what();
      return nullptr;
    }
    return DefaultIOSystem::Open(file, mode);
  }

  /// Why an existing file could not be opened; empty if all could.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  CountedFiles& files_;
  std::string fault_;
};

}  // namespace

Model import_with_assimp(const std::filesystem::path& file, CountedFiles& counted) {
  Assimp::Importer importer;
  auto* const files = new ImporterFiles(counted);  // owned by the importer
  importer.SetIOHandler(files);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  constexpr unsigned kNoPostProcessing = 0;  // in particular no triangulation
  const aiScene* const scene = importer.ReadFile(file.string(), kNoPostProcessing);
  try {
    // Assimp stores what importers throw. Running out of memory is our error, not one of the file.
    if (importer.GetException()) std::rethrow_exception(importer.GetException());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string reason = printable(files->fault().empty() ? importer.GetErrorString() : files->fault());
    throw InputError(file.string() +
                     ": cannot import: " + (reason.empty() ? "the import library does not say why" : reason));
  }
  return SceneReader(file, *scene).read();
}

Model read_with_assimp(const std::filesystem::path& file) {
  return import_in_child(file, "the import library", [&](CountedFiles& files) { return import_with_assimp(file, files); });
}

}  // namespace occlude::render
