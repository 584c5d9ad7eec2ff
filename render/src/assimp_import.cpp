// SPDX-License-Identifier: MIT
#include "assimp_import.h"

#include <assimp/config.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <limits>
#include <string>
#include <vector>

#include "input_file.h"
#include "model_check.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

using culler::PolygonSoup;

glm::dmat4 to_double(const aiMatrix4x4& m) {
  // Assimp stores rows, glm columns.
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, const aiScene& scene) : file_(file), scene_(scene) {}

  PolygonSoup read() {
    // A stack of our own: the depth of the tree is up to the file.
    std::vector<Placed> stack = {{scene_.mRootNode, glm::dmat4(1)}};
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      const glm::dmat4 transform = parent * to_double(node->mTransformation);
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add_mesh(node->mMeshes[i], transform);
      for (unsigned i = node->mNumChildren; i-- > 0;) stack.push_back({node->mChildren[i], transform});
    }
    require_usable(file_, soup_);
    return std::move(soup_);
  }

 private:
  struct Placed {
    const aiNode* node;
    glm::dmat4 parent;
  };

  [[noreturn]] void fail(unsigned mesh, const char* what, unsigned index, const std::string& reason) const {
    throw InputError(fmt::format("{}: mesh {}: {} {}: {}", file_.string(), mesh, what, index, reason));
  }

  void add_mesh(unsigned index, const glm::dmat4& transform) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    const std::size_t base = soup_.vertices.size();
    if (mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max() - base)
      throw InputError(file_.string() + ": too many vertices");
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const glm::dvec3 placed(transform * glm::dvec4(v.x, v.y, v.z, 1));
      if (const auto fault = vertex_fault(placed)) fail(index, "vertex", i, *fault);
      soup_.vertices.push_back(placed);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_face(index, i, base);
  }

  void add_face(unsigned mesh, unsigned index, std::size_t base) {
    const aiFace& face = scene_.mMeshes[mesh]->mFaces[index];
    if (face.mNumIndices < 3) return;
    loop_.assign(face.mIndices, face.mIndices + face.mNumIndices);
    if (const auto fault = loop_fault(loop_, scene_.mMeshes[mesh]->mNumVertices)) fail(mesh, "face", index, *fault);
    for (std::int64_t& vertex : loop_) vertex += static_cast<std::int64_t>(base);
    add_polygon(soup_, loop_);
  }

  const std::filesystem::path& file_;
  const aiScene& scene_;
  PolygonSoup soup_;
  std::vector<std::int64_t> loop_;
};

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

PolygonSoup read_with_assimp(const std::filesystem::path& file) {
  require_readable(file);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  constexpr unsigned kNoPostProcessing = 0;  // above all no triangulation
  const aiScene* const scene = importer.ReadFile(file.string(), kNoPostProcessing);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw InputError(file.string() + ": cannot import: " + one_line(importer.GetErrorString()));
  return SceneReader(file, *scene).read();
}

}  // namespace occlude::render
