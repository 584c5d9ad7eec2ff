// SPDX-License-Identifier: MIT
// The numbers of a glTF file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "gltf_buffers.h"
#include "gltf_document.h"

namespace occlude::render::gltf {

/// What components are, by the numbers that glTF has for them.
enum class Component { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

[[nodiscard]] std::size_t size_of(Component component);

template <class T>
[[nodiscard]] T component_at(const std::byte* element, unsigned component) {
  T value;
  std::memcpy(&value, element + component * sizeof(T), sizeof(T));
  return value;
}

/// A list of numbers, vectors or matrices. All of it is known to be there. Bytes are those of `buffers`, or of what has
/// decoded them, which must be there as long.
class Accessor {
 public:
  struct Layout {
    Component component = Component::float32;
    bool is_normalized = false;
    unsigned width = 1;  ///< components of an element
  };

  /// Refuses an accessor that has elements of other than `width` components, or that does not fit its bytes.
  Accessor(const Document& document, Buffers& buffers, std::uint64_t index, unsigned width);
  /// All of `bytes`, closely.
  Accessor(const Layout& layout, std::span<const std::byte> bytes);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] unsigned width() const { return layout_.width; }
  /// Whether components can be indices.
  [[nodiscard]] bool is_unsigned() const;

  // REQUIRES: i < size(), and the width that the type has.
  /// Floats and integers as they are, normalized integers as the doubles that glTF's formulas give.
  [[nodiscard]] double number(std::uint64_t i, unsigned component) const { return number_at(element(i), component); }
  [[nodiscard]] glm::dvec3 vec3(std::uint64_t i) const;
  [[nodiscard]] glm::dvec4 vec4(std::uint64_t i) const;
  [[nodiscard]] glm::dmat4 mat4(std::uint64_t i) const;
  /// REQUIRES: is_unsigned().
  [[nodiscard]] std::uint32_t index(std::uint64_t i, unsigned component = 0) const {
    const std::byte* const from = element(i);
    switch (layout_.component) {
      case Component::uint8:
        return component_at<std::uint8_t>(from, component);
      case Component::uint16:
        return component_at<std::uint16_t>(from, component);
      default:
        return component_at<std::uint32_t>(from, component);
    }
  }

 private:
  void read_bytes(const json& accessor, Buffers& buffers);
  void read_sparse(const json& sparse, Buffers& buffers);
  [[nodiscard]] std::size_t element_size() const { return size_of(layout_.component) * layout_.width; }
  [[nodiscard]] const std::byte* element(std::uint64_t i) const {
    if (!replaced_.empty()) {
      if (const std::byte* const other = replacement(i)) return other;
    }
    return bytes_ == nullptr ? kZeros.data() : bytes_ + i * stride_;
  }
  /// What is in place of the element; null: nothing.
  [[nodiscard]] const std::byte* replacement(std::uint64_t i) const;
  [[nodiscard]] double number_at(const std::byte* element, unsigned component) const;

  /// As long as an element of the widest kind: sixteen numbers of four bytes.
  static constexpr std::array<std::byte, 64> kZeros{};

  Layout layout_;
  std::uint64_t size_ = 0, stride_ = 0;
  const std::byte* bytes_ = nullptr;     ///< null: all is zero
  std::vector<std::uint32_t> replaced_;  ///< elements that have others in their place, ascending
  const std::byte* replacements_ = nullptr;
};

}  // namespace occlude::render::gltf
