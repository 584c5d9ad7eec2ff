// SPDX-License-Identifier: MIT
// The header of a PLY file: the elements that follow and the encoding of their values.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace occlude::render::ply {

enum class Encoding { ascii, binary_little_endian, binary_big_endian };
enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The size of a value in the binary encodings, bytes.
[[nodiscard]] std::size_t size_of(Scalar type);
[[nodiscard]] bool is_integer(Scalar type);

struct Property {
  std::string name;
  Scalar type;                  ///< of the value, or of the items of a list
  std::optional<Scalar> count;  ///< type of a list's length; none for a single value
};

/// Elements of lists of vertices: of each a face, or three in a row a triangle, as scanners write them.
inline constexpr std::string_view kFaces = "face", kStrips = "tristrips";

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  [[nodiscard]] const Property* find(std::string_view property) const;
  [[nodiscard]] bool has_faces() const { return name == kFaces || name == kStrips; }
  /// The list of vertices of a face or of strips.
  [[nodiscard]] const Property* loop() const;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t bytes = 0;  ///< length of the header; the data starts there
  std::size_t lines = 0;  ///< of the header

  [[nodiscard]] const Element* find(std::string_view element) const;
};

/// Where a strip ends, in a list of them: -1.
template <class Index>
inline constexpr Index kEndOfStrip = static_cast<Index>(-1);

/// Calls add(corners) for each triangle of a list of strips. One with two corners in one vertex only joins others.
template <class Index, class Add>
void for_each_triangle(std::span<const Index> strips, const Add& add) {
  for (std::size_t i = 0; i + 2 < strips.size(); ++i) {
    const Index a = strips[i], b = strips[i + 1], c = strips[i + 2];
    const bool is_end = a == kEndOfStrip<Index> || b == kEndOfStrip<Index> || c == kEndOfStrip<Index>;
    if (!is_end && a != b && b != c && c != a) add(std::array{a, b, c});
  }
}

/// Throws InputError, naming `file` and the line, unless the header is well-formed.
[[nodiscard]] Header read_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace occlude::render::ply
