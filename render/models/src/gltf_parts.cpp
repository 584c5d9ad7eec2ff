// SPDX-License-Identifier: MIT
// Leaves triangles out of a glTF file: primitives get lists of indices of their own, and the JSON stays as it is otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gltf_buffers.h"
#include "gltf_document.h"
#include "gltf_file.h"
#include "gltf_meshes.h"
#include "gltf_nodes.h"
#include "gltf_primitive.h"
#include "gltf_scene.h"
#include "import_child.h"
#include "part_readers.h"

namespace occlude::render {
namespace gltf {
namespace {

/// A primitive of a mesh, by their numbers.
using Place = std::pair<std::uint64_t, std::size_t>;

std::string name_of(const json& object) {
  const json* const name = find(object, "name");
  return name != nullptr && name->is_string() ? name->get<std::string>() : std::string();
}

class PartLister {
 public:
  PartLister(const Document& document, Buffers& buffers)
      : document_(document), nodes_(document), meshes_(document, buffers, nodes_), parents_(document.count(kNodes)) {
    for (std::uint64_t node = 0; node < parents_.size(); ++node) {
      for (const std::uint64_t child : nodes_.listed_in(document.item(kNodes, node), "children")) parents_[child] = node;
    }
    find_shown_elsewhere();
  }

  FileParts list() {
    FileParts result;
    std::map<Place, std::uint64_t> shapes;
    std::uint64_t faces = 0;
    for_each_shown(document_, nodes_, meshes_, [&](const Shown& shown) {
      const std::uint64_t shape = shapes.emplace(Place(shown.mesh, shown.number), shapes.size()).first->second;
      const bool is_fixed = shown.primitive.is_compressed() || shown_elsewhere_.contains(shown.mesh);
      const std::uint64_t count = shown.primitive.triangles();
      result.parts.push_back(
          {document_.label(kNodes, shown.node), names_of(shown), faces, count, shown.node, shape, is_fixed});
      faces += count;
    });
    for (const char* const list : {"buffers", "images"}) {
      for (const json& item : array_in(document_.root(), list)) {
        const std::string uri = text_in(item, "uri", "data:");
        if (!uri.starts_with("data:")) result.files.push_back(uri);
      }
    }
    result.has_motion = !array_in(document_.root(), "animations").empty();
    return result;
  }

 private:
  /// Meshes of nodes that are not shown, or in another scene as well.
  void find_shown_elsewhere() {
    std::vector<std::uint64_t> elsewhere;
    std::vector<bool> is_shown(parents_.size());
    for (const std::uint64_t node : nodes_.shown()) is_shown[node] = true;
    for (std::uint64_t node = 0; node < is_shown.size(); ++node) {
      if (!is_shown[node]) elsewhere.push_back(node);
    }
    const auto scene = find_whole(document_.root(), "scene");
    for (std::uint64_t other = 0; scene && other < document_.count(kScenes); ++other) {
      if (other == *scene) continue;
      std::vector<std::uint64_t> of_scene = nodes_.listed_in(document_.item(kScenes, other), "nodes");
      while (!of_scene.empty()) {
        elsewhere.push_back(of_scene.back());
        of_scene.pop_back();
        const auto children = nodes_.listed_in(document_.item(kNodes, elsewhere.back()), "children");
        of_scene.insert(of_scene.end(), children.begin(), children.end());
      }
    }
    for (const std::uint64_t node : elsewhere) {
      if (const auto mesh = find_whole(document_.item(kNodes, node), "mesh")) shown_elsewhere_.insert(*mesh);
    }
  }

  [[nodiscard]] std::vector<std::string> names_of(const Shown& shown) const {
    const json& mesh = document_.item(kMeshes, shown.mesh);
    std::vector<std::string> names{name_of(mesh)};
    if (const auto material = find_whole(array_in(mesh, "primitives")[shown.number], "material")) {
      names.push_back(name_of(document_.item(kMaterials, *material)));
    }
    for (std::optional<std::uint64_t> node = shown.node; node; node = parents_[*node]) {
      names.push_back(name_of(document_.item(kNodes, *node)));
    }
    std::erase(names, "");
    return names;
  }

  const Document& document_;
  const Nodes nodes_;
  Meshes meshes_;
  std::vector<std::optional<std::uint64_t>> parents_;
  std::set<std::uint64_t> shown_elsewhere_;  ///< meshes
};

class Cutter {
 public:
  Cutter(const Document& document, Buffers& buffers)
      : document_(document), nodes_(document), meshes_(document, buffers, nodes_), root_(document.root()) {}

  std::string cut(const std::vector<ModelPart>& parts, const std::vector<bool>& gone) {
    const std::vector<bool> goes = owners_gone(parts, gone);
    for (std::uint64_t node = 0; node < goes.size(); ++node) {
      if (goes[node]) hide(root_["nodes"][node]);
    }
    std::map<Place, std::uint64_t> firsts;  // the first face of a primitive, where it stays
    auto part = parts.begin();
    for_each_shown(document_, nodes_, meshes_, [&](const Shown& shown) {
      if (!goes[shown.node]) firsts.emplace(Place(shown.mesh, shown.number), part->first);
      ++part;
    });
    // From behind: where a primitive goes, those before it keep their numbers.
    for (auto at = firsts.rbegin(); at != firsts.rend(); ++at) {
      cut(at->first, gone.begin() + static_cast<std::ptrdiff_t>(at->second));
    }
    return written();
  }

 private:
  void cut(const Place& place, std::vector<bool>::const_iterator gone) {
    const auto& [mesh, number] = place;
    const Primitive& primitive = meshes_.mesh(mesh)[number];
    std::vector<std::uint32_t> kept;
    std::array<std::uint32_t, 3> room{};
    const std::uint64_t count = primitive.triangles();
    for (std::uint64_t i = 0; i < count; ++i) {
      if (gone[static_cast<std::ptrdiff_t>(i)]) continue;
      for (const std::uint32_t corner : primitive.face(i, room)) kept.push_back(corner);
    }
    if (kept.size() == 3 * count) return;
    json& primitives = root_["meshes"][mesh]["primitives"];
    if (kept.empty()) {
      primitives.erase(number);
    } else {
      primitives[number]["indices"] = accessor_of(kept);
      primitives[number].erase("mode");
    }
  }

  static void hide(json& node) {
    for (const char* const member : {"mesh", "skin", "weights"}) node.erase(member);
    if (!node.contains("extensions")) return;
    node["extensions"].erase("EXT_mesh_gpu_instancing");
    if (node["extensions"].empty()) node.erase("extensions");
  }

  /// A new accessor of indices.
  [[nodiscard]] std::size_t accessor_of(const std::vector<std::uint32_t>& indices) {
    constexpr std::uint32_t kElementArrayBuffer = 34963;
    const bool is_short = *std::ranges::max_element(indices) < std::numeric_limits<std::uint16_t>::max();
    const std::size_t size = is_short ? sizeof(std::uint16_t) : sizeof(std::uint32_t), offset = added_.size();
    for (const std::uint32_t index : indices) added_.append(reinterpret_cast<const char*>(&index), size);  // little-endian
    added_.resize((added_.size() + 3) / 4 * 4);
    root_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", indices.size() * size}, {"target", kElementArrayBuffer}});
    views_.push_back(root_["bufferViews"].size() - 1);
    root_["accessors"].push_back({{"bufferView", views_.back()},
                                  {"componentType", static_cast<int>(is_short ? Component::uint16 : Component::uint32)},
                                  {"count", indices.size()},
                                  {"type", "SCALAR"}});
    return root_["accessors"].size() - 1;
  }

  /// The file, with what was added: in the binary chunk of a container, or in a buffer of its own.
  [[nodiscard]] std::string written() {
    if (!document_.binary()) {
      if (!added_.empty()) add_buffer();
      return root_.dump();
    }
    const auto binary = *document_.binary();
    std::string chunk(reinterpret_cast<const char*>(binary.data()), binary.size());
    const bool is_first = document_.count(kBuffers) > 0 && find(document_.item(kBuffers, 0), "uri") == nullptr;
    if (!added_.empty() && is_first) {
      chunk.resize((chunk.size() + 3) / 4 * 4);
      for (const std::size_t view : views_) {
        json& offset = root_["bufferViews"][view]["byteOffset"];
        offset = offset.get<std::size_t>() + chunk.size();
      }
      chunk += added_;
      root_["buffers"][0]["byteLength"] = chunk.size();
    } else if (!added_.empty()) {
      add_buffer();
    }
    return container_of(root_.dump(), std::move(chunk));
  }

  void add_buffer() {
    const std::size_t buffer = document_.count(kBuffers);
    root_["buffers"].push_back(
        {{"byteLength", added_.size()}, {"uri", "data:application/octet-stream;base64," + to_base64(added_)}});
    for (const std::size_t view : views_) root_["bufferViews"][view]["buffer"] = buffer;
  }

  const Document& document_;
  const Nodes nodes_;
  Meshes meshes_;
  json root_;
  std::string added_;               ///< bytes of new lists of indices
  std::vector<std::size_t> views_;  ///< of them
};

/// What a child process hands over.
struct Listed {
  FileParts listed;
};

void hand_over(const Listed& made, HandoverWriter& writer) {
  writer.put_number(made.listed.parts.size());
  for (const ModelPart& part : made.listed.parts) {
    writer.put(part.node);
    writer.put_texts(part.names);
    for (const std::uint64_t number : {part.first, part.count, part.owner, part.shape, std::uint64_t{part.is_fixed}}) {
      writer.put_number(number);
    }
  }
  writer.put_texts(made.listed.files);
  writer.put_number(made.listed.has_motion);
}

void take_over(Listed& made, HandoverReader& reader) {
  std::size_t count = 0;
  for (reader.take_number(count); count > 0; --count) {
    ModelPart& part = made.listed.parts.emplace_back();
    reader.take(part.node);
    reader.take_texts(part.names);
    std::uint64_t is_fixed = 0;
    for (std::uint64_t* const number : {&part.first, &part.count, &part.owner, &part.shape, &is_fixed})
      reader.take_number(*number);
    part.is_fixed = is_fixed != 0;
  }
  reader.take_texts(made.listed.files);
  reader.take_number(made.listed.has_motion);
}

struct Written {
  std::string bytes;
};
void hand_over(const Written& made, HandoverWriter& writer) { writer.put(made.bytes); }
void take_over(Written& made, HandoverReader& reader) { reader.take(made.bytes); }

/// What work(document, buffers) returns of the file, in a child process.
template <class Work>
auto in_child(const std::filesystem::path& file, const Work& work) {
  return import_in_child(file, kReader, [&](CountedFiles& files) {
    try {
      return of_file(file, files, work);
    } catch (const OldVersion& error) {
      throw InputError(file.string() + ": " + error.what());
    }
  });
}

}  // namespace
}  // namespace gltf

FileParts gltf_parts(const std::filesystem::path& file) {
  return gltf::in_child(file,
                        [](const gltf::Document& document, gltf::Buffers& buffers) {
                          return gltf::Listed{gltf::PartLister(document, buffers).list()};
                        })
      .listed;
}

std::string gltf_without(const std::filesystem::path& file, const std::vector<bool>& gone) {
  return gltf::in_child(file,
                        [&](const gltf::Document& document, gltf::Buffers& buffers) {
                          return gltf::Written{
                              gltf::Cutter(document, buffers).cut(gltf::PartLister(document, buffers).list().parts, gone)};
                        })
      .bytes;
}

}  // namespace occlude::render
