// SPDX-License-Identifier: MIT
// The JSON of a glTF file. Everything else about the file asks for its members here, so what has the wrong kind is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/render/errors.h"

namespace occlude::render::gltf {

using nlohmann::json;

/// Throws InputError. What is thrown below the whole file does not name the file.
[[noreturn]] void refuse(const std::string& reason);

/// What `work` returns, with `place()` before the message of an InputError that it throws.
template <class Place, class Work>
decltype(auto) at(const Place& place, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    refuse(std::string(place()) + ": " + error.what());
  }
}

// The members of an object. All throw InputError, with the name of the member, where its value has another kind.

/// Null if there is no such member.
[[nodiscard]] const json* find(const json& object, const char* name);
[[nodiscard]] const json& object_in(const json& object, const char* name);
/// An array, which is empty if there is no such member.
[[nodiscard]] const json& array_in(const json& object, const char* name);
[[nodiscard]] std::optional<std::uint64_t> find_whole(const json& object, const char* name);
[[nodiscard]] std::uint64_t whole_in(const json& object, const char* name);
[[nodiscard]] bool flag_in(const json& object, const char* name, bool otherwise);
[[nodiscard]] double number_in(const json& object, const char* name, double otherwise);
[[nodiscard]] std::string text_in(const json& object, const char* name, const char* otherwise);
/// An array of numbers; nothing if there is no such member.
[[nodiscard]] std::optional<std::vector<double>> find_numbers(const json& object, const char* name);
/// The same, of `count` numbers.
[[nodiscard]] std::optional<std::vector<double>> find_numbers(const json& object, const char* name, std::size_t count);
/// The object's extension; null if it has none of that name.
[[nodiscard]] const json* find_extension(const json& object, const char* name);

/// A list of the file, and what one of its items is called.
struct List {
  const char* name;
  const char* one;
};
inline constexpr List kAccessors{"accessors", "accessor"}, kBuffers{"buffers", "buffer"};
inline constexpr List kBufferViews{"bufferViews", "bufferView"}, kMaterials{"materials", "material"};
inline constexpr List kImages{"images", "image"}, kTextures{"textures", "texture"};
inline constexpr List kMeshes{"meshes", "mesh"}, kNodes{"nodes", "node"}, kScenes{"scenes", "scene"},
    kSkins{"skins", "skin"};

/// The bytes of a .glb file of these two chunks.
[[nodiscard]] std::string container_of(std::string text, std::string binary);

/// The file is of glTF 1, which is another format.
struct OldVersion : InputError {
  OldVersion() : InputError("glTF 1.0 is not supported, but 2.0") {}
};

class Document {
 public:
  /// Takes the bytes of a .gltf or .glb file. Refuses other versions of glTF than 2. Throws OldVersion for a .gltf file of
  /// version 1.
  explicit Document(std::string bytes);

  [[nodiscard]] const json& root() const { return root_; }
  /// The binary chunk of a .glb file; nothing if it has none.
  [[nodiscard]] std::optional<std::span<const std::byte>> binary() const { return binary_; }

  [[nodiscard]] std::size_t count(const List& list) const { return array_in(root_, list.name).size(); }
  /// An object. Refuses an index that the list does not have.
  [[nodiscard]] const json& item(const List& list, std::uint64_t index) const;
  /// The item for messages: `mesh 3 "wall"`.
  [[nodiscard]] std::string label(const List& list, std::uint64_t index) const;

 private:
  void open_container();
  void parse(std::string_view text);
  void check_version() const;

  std::string bytes_;
  std::optional<std::span<const std::byte>> binary_;
  json root_;
};

}  // namespace occlude::render::gltf
