// SPDX-License-Identifier: MIT
#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <glm/mat4x4.hpp>
#include <limits>
#include <new>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "model_check.h"
#include "model_readers.h"
#include "occlude/render/child_process.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/model_io.h"
#include "occlude/render/printable.h"
#include "occlude/render/resource_limits.h"

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
    // An explicit stack: the file decides how deep the tree is.
    std::vector<Placed> stack = {{scene_.mRootNode, glm::dmat4(1)}};
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      const glm::dmat4 transform = parent * to_double(node->mTransformation);
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add_mesh(node->mMeshes[i], transform);
      for (unsigned i = node->mNumChildren; i-- > 0;) stack.push_back({node->mChildren[i], transform});
    }
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

  /// False for points and lines.
  static bool is_polygon(const aiFace& face) { return face.mNumIndices >= 3; }

  void add_mesh(unsigned index, const glm::dmat4& transform) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) check_face(index, i);
    add_vertices(index, transform);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_face(mesh.mFaces[i]);
  }

  void check_face(unsigned mesh, unsigned index) const {
    const aiFace& face = scene_.mMeshes[mesh]->mFaces[index];
    if (!is_polygon(face)) return;
    const std::vector<std::int64_t> loop(face.mIndices, face.mIndices + face.mNumIndices);
    if (const auto fault = loop_fault(loop, scene_.mMeshes[mesh]->mNumVertices)) fail(mesh, "face", index, *fault);
  }

  /// Only the vertices that polygons use: an importer can create any number of others from a short file.
  void add_vertices(unsigned index, const glm::dmat4& transform) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    places_.assign(mesh.mNumVertices, kNowhere);
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      if (!is_polygon(face)) continue;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) places_[vertex] = 0;
    }
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      if (places_[i] == kNowhere) continue;
      if (soup_.vertices.size() > std::numeric_limits<std::uint32_t>::max())
        throw InputError(file_.string() + ": too many vertices");
      const aiVector3D& v = mesh.mVertices[i];
      const glm::dvec3 placed(transform * glm::dvec4(v.x, v.y, v.z, 1));
      if (const auto fault = vertex_fault(placed)) fail(index, "vertex", i, *fault);
      places_[i] = static_cast<std::int64_t>(soup_.vertices.size());
      soup_.vertices.push_back(placed);
    }
  }

  void add_face(const aiFace& face) {
    if (!is_polygon(face)) return;
    loop_.clear();
    for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) loop_.push_back(places_[vertex]);
    add_polygon(soup_, loop_);
  }

  static constexpr std::int64_t kNowhere = -1;

  const std::filesystem::path& file_;
  const aiScene& scene_;
  PolygonSoup soup_;
  std::vector<std::int64_t> places_;  ///< indices of the mesh's vertices in the soup
  std::vector<std::int64_t> loop_;
};

// Limits of the import library. Importers need about twenty times the size of a file (3MF, which is compressed, a hundred
// times), and read megabytes per second.
constexpr std::uint64_t kMemory = std::uint64_t{256} << 20U, kMemoryPerByte = 128;
constexpr std::uint64_t kSeconds = 20, kBytesPerSecond = 100'000;

ChildLimits limits_for(std::uint64_t content) {
  // Half of the memory: this process holds the model too, once it is handed over.
  return {std::min(kMemory + kMemoryPerByte * content, most_memory() / 2), kSeconds + content / kBytesPerSecond};
}

/// Tells files apart, whatever names they are opened by.
std::pair<dev_t, ino_t> identity(const char* file) {
  struct stat status {};
  if (stat(file, &status) != 0)
    throw InputError(std::string(file) + ": cannot read: " + std::generic_category().message(errno));
  return {status.st_dev, status.st_ino};
}

/// Opens files for an importer: regular files only, because a pipe would keep it waiting. Raises the limits with each file
/// opened, because a model may refer to larger files. A file counts once, and blanks and zeros do not count: else a file
/// without content, or one that refers to another by many names, could ask for any amount.
class CountedFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* file) const override {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
  }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    try {
      require_readable(file);
      if (seen_.insert(identity(file)).second) change_limits(limits_for(content_ += content_of(file)));
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
  std::set<std::pair<dev_t, ino_t>> seen_;
  std::uint64_t content_ = 0;
  std::string fault_;
};

PolygonSoup import(const std::filesystem::path& file) {
  Assimp::Importer importer;
  auto* const files = new CountedFiles;  // owned by the importer
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

// The child process hands over four arrays, each as its length and its items: the message of an InputError, empty if there
// was none, and the three arrays of a soup.

template <class Items>
void put(std::FILE* out, const Items& items) {
  const std::uint64_t count = items.size();
  bool is_written = std::fwrite(&count, sizeof(count), 1, out) == 1;
  if (count != 0) is_written = is_written && std::fwrite(items.data(), sizeof(items[0]), count, out) == count;
  if (!is_written) throw std::runtime_error("a temporary file cannot be written");
}

/// Reads the result of a child that may have corrupted its own memory.
class Handover {
 public:
  explicit Handover(std::FILE* file) : file_(file) {
    std::fseek(file_, 0, SEEK_END);
    left_ = static_cast<std::uint64_t>(std::ftell(file_));
    std::rewind(file_);
  }

  template <class Items>
  Items take() {
    std::uint64_t count = 0;
    take(&count, sizeof(count));
    if (count > left_ / sizeof(typename Items::value_type)) fail();
    Items items;
    items.resize(static_cast<std::size_t>(count));
    take(items.data(), items.size() * sizeof(items[0]));
    return items;
  }

  [[noreturn]] static void fail() { throw ChildFailure("returns damaged data", false); }

 private:
  void take(void* to, std::size_t bytes) {
    if (bytes == 0) return;  // `to` may be null
    if (bytes > left_ || std::fread(to, 1, bytes, file_) != bytes) fail();
    left_ -= bytes;
  }

  std::FILE* file_;
  std::uint64_t left_;  ///< bytes left in the file
};

void hand_over(const std::filesystem::path& file, std::FILE* out) {
  std::string failure;
  PolygonSoup soup;
  try {
    soup = import(file);
  } catch (const InputError& error) {
    failure = error.what();
  }
  put(out, failure);
  put(out, soup.vertices);
  put(out, soup.indices);
  put(out, soup.first);
}

PolygonSoup take_over(std::FILE* in) {
  Handover handover(in);
  if (const auto failure = handover.take<std::string>(); !failure.empty()) throw InputError(failure);
  // The soup is rebuilt polygon by polygon, with every check.
  PolygonSoup soup;
  soup.vertices = handover.take<std::vector<glm::dvec3>>();
  if (std::ranges::any_of(soup.vertices, [](const glm::dvec3& v) { return vertex_fault(v).has_value(); })) Handover::fail();
  const auto indices = handover.take<std::vector<std::uint32_t>>();
  const auto first = handover.take<std::vector<std::uint32_t>>();
  std::vector<std::int64_t> loop;
  for (std::size_t p = 0; p + 1 < first.size(); ++p) {
    if (first[p] > first[p + 1] || first[p + 1] > indices.size()) Handover::fail();
    loop.assign(indices.begin() + first[p], indices.begin() + first[p + 1]);
    if (loop_fault(loop, soup.vertices.size())) Handover::fail();
    add_polygon(soup, loop);
  }
  return soup;
}

}  // namespace

std::string import_limits() {
  return fmt::format(
      "{} of memory and {} s of processor time, and {} bytes and {} us more for each byte that it reads but zeros "
      "and blanks",
      in_mebibytes(kMemory), kSeconds, kMemoryPerByte, 1'000'000 / kBytesPerSecond);
}

PolygonSoup read_with_assimp(const std::filesystem::path& file) {
  require_readable(file);
  try {
    const File handed_over = run_in_child(limits_for(0), [&](std::FILE* out) { hand_over(file, out); });
    PolygonSoup soup = take_over(handed_over.get());
    require_usable(file, soup);
    return soup;
  } catch (const ChildFailure& failure) {
    throw InputError(fmt::format("{}: cannot import: the import library {}{}", file.string(), failure.what(),
                                 failure.at_limit ? ": " + import_limits() : ""));
  }
}

}  // namespace occlude::render
