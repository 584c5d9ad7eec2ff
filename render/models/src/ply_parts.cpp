// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/render/input_file.h"
#include "part_readers.h"
#include "ply_header.h"
#include "ply_values.h"
#include "words.h"

namespace occlude::render {
namespace {

using ply::Element, ply::Header, ply::Property, ply::ValueReader;

/// The header with another number of faces.
std::string with_faces(std::string_view header, std::size_t count) {
  std::string text;
  while (!header.empty()) {
    const std::string_view line = header.substr(0, std::min(header.find('\n'), header.size() - 1) + 1);
    const auto words = words_of(line);
    if (words.size() == 3 && words[0] == "element" && words[1] == ply::kFaces) {
      const auto at = static_cast<std::size_t>(words[2].data() - line.data());
      text += line.substr(0, at);
      text += std::to_string(count);
      text += line.substr(at + words[2].size());
    } else {
      text += line;
    }
    header.remove_prefix(line.size());
  }
  return text;
}

/// Calls take(element, bytes, corners) for each item of each element, with all its bytes, and the vertices of a list of
/// them.
template <class Take>
void for_each_item(const std::filesystem::path& file, std::string_view bytes, const Header& header, const Take& take) {
  ValueReader values(file, header, bytes);
  std::vector<std::int64_t> corners;
  for (const Element& element : header.elements) {
    const Property* const loop = element.has_faces() ? element.loop() : nullptr;
    for (std::size_t i = 0; i < element.count; ++i) {
      values.enter(element, i);
      const std::size_t begin = bytes.size() - values.left();
      corners.clear();
      for (const Property& property : element.properties) {
        if (&property == loop) {
          values.integers(property.type, values.integer(*property.count), corners);
        } else {
          values.skip(property);
        }
      }
      take(element, bytes.substr(begin, bytes.size() - values.left() - begin), corners);
    }
  }
}

std::uint64_t triangles_of(const std::vector<std::int64_t>& strips) {
  std::uint64_t count = 0;
  ply::for_each_triangle(std::span(strips), [&](const auto&) { ++count; });
  return count;
}

}  // namespace

FileParts ply_parts(const std::filesystem::path& file) {
  const std::string bytes = read_input(file);
  const Header header = ply::read_header(file, bytes);
  FileParts result;
  std::uint64_t faces = 0;
  const auto part_of = [&](bool is_fixed) -> ModelPart& {
    if (result.parts.empty() || result.parts.back().is_fixed != is_fixed) {
      result.parts.push_back({{}, {}, faces, 0, 0, result.parts.size(), is_fixed});
    }
    return result.parts.back();
  };
  for_each_item(file, bytes, header,
                [&](const Element& element, std::string_view, const std::vector<std::int64_t>& corners) {
                  const bool is_strip = element.name == ply::kStrips;
                  const std::uint64_t count = is_strip                                             ? triangles_of(corners)
                                              : element.name == ply::kFaces && corners.size() >= 3 ? 1
                                                                                                   : 0;
                  if (count != 0) part_of(is_strip).count += count;
                  faces += count;
                });
  return result;
}

std::string ply_without(const std::filesystem::path& file, const std::vector<bool>& gone) {
  const std::string bytes = read_input(file);
  const Header header = ply::read_header(file, bytes);
  std::string kept;
  std::size_t face = 0, left = 0;
  for_each_item(file, bytes, header,
                [&](const Element& element, std::string_view all, const std::vector<std::int64_t>& corners) {
                  if (element.name == ply::kStrips) {
                    face += triangles_of(corners);
                  } else if (element.name == ply::kFaces) {
                    if (corners.size() >= 3 && gone[face++]) return;
                    ++left;
                  }
                  kept += all;
                });
  // In text, the blanks after the last item.
  return with_faces(std::string_view(bytes).substr(0, header.bytes), left) + kept +
         (header.encoding == ply::Encoding::ascii ? "\n" : "");
}

}  // namespace occlude::render
