// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model_builder.h"
#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "ply_header.h"
#include "ply_values.h"

namespace occlude::render {
namespace {

using ply::Element;
using ply::Header;
using ply::Property;
using ply::ValueReader;

void read_vertices(ValueReader& values, const Element& element, ModelBuilder& builder) {
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    glm::dvec3 v{0, 0, 0};
    for (const Property& property : element.properties) {
      const char axis = property.name.size() == 1 ? property.name[0] : '\0';
      if (axis >= 'x' && axis <= 'z') {
        v[axis - 'x'] = values.real(property.type);
      } else {
        values.skip(property);
      }
    }
    builder.add_vertex(v, [&] { return values.place(); });
  }
}

/// A list of vertices, each checked: of a face, or, with -1 where one ends, of strips of triangles.
class LoopReader {
 public:
  LoopReader(ValueReader& values, std::size_t vertices, bool is_strip)
      : values_(values), vertices_(vertices), is_strip_(is_strip) {}

  std::span<const std::uint32_t> read(const Property& property) {
    const std::int64_t count = values_.integer(*property.count);
    if (count < 0) values_.fail("the list has a negative length");
    values_.integers(property.type, count, items_);
    loop_.resize(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) loop_[i] = vertex(items_[i]);
    return loop_;
  }

 private:
  [[nodiscard]] std::uint32_t vertex(std::int64_t index) const {
    if (index >= 0 && std::cmp_less(index, vertices_)) return static_cast<std::uint32_t>(index);
    if (!is_strip_ || index != -1)
      values_.fail(fmt::format("vertex index {} is out of range ({} vertices)", index, vertices_));
    return ply::kEndOfStrip<std::uint32_t>;
  }

  ValueReader& values_;
  const std::size_t vertices_;
  const bool is_strip_;
  std::vector<std::int64_t> items_;
  std::vector<std::uint32_t> loop_;
};

/// Calls add(loop) for each face of an element of faces or strips.
template <class Add>
void read_faces(ValueReader& values, const Element& element, std::size_t vertices, const Add& add) {
  const Property* const indices = element.loop();
  const bool is_strip = element.name == ply::kStrips;
  LoopReader loops(values, vertices, is_strip);
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    std::span<const std::uint32_t> loop;
    for (const Property& property : element.properties) {
      if (&property == indices) {
        loop = loops.read(property);
      } else {
        values.skip(property);
      }
    }
    if (is_strip) {
      ply::for_each_triangle(loop, add);
    } else {
      add(loop);
    }
  }
}

void skip_element(ValueReader& values, const Element& element) {
  if (element.properties.empty()) return;
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    for (const Property& property : element.properties) values.skip(property);
  }
}

/// Checks that the header declares the properties of `vertex` and `face` that we read.
void require_declarations(const std::filesystem::path& file, const Header& header) {
  const Element* const vertex = header.find("vertex");
  if (vertex == nullptr) throw InputError(file.string() + ": no element vertex");
  for (const char* const axis : {"x", "y", "z"}) {
    const Property* const property = vertex->find(axis);
    if (property == nullptr || property->count) throw InputError(file.string() + ": element vertex has no number " + axis);
  }
  for (const Element& element : header.elements) {
    const Property* const indices = element.loop();
    if (element.has_faces() && (indices == nullptr || !indices->count || !ply::is_integer(indices->type)))
      throw InputError(fmt::format("{}: element {} has no list of integers vertex_indices", file.string(), element.name));
  }
}

}  // namespace

Model read_ply(const std::filesystem::path& file) {
  const std::string bytes = read_input(file);
  const Header header = ply::read_header(file, bytes);
  require_declarations(file, header);
  ValueReader values(file, header, bytes);
  ModelBuilder builder;
  const auto add = [&](std::span<const std::uint32_t> loop) { builder.add_face(loop); };
  // Elements may come in any order, and faces need their vertices.
  const std::size_t vertices = header.find("vertex")->count;
  std::vector<std::vector<std::uint32_t>> waiting;
  for (const Element& element : header.elements) {
    values.expect_room_for(element);
    if (element.name == "vertex") {
      builder.reserve(element.count, 0);
      read_vertices(values, element, builder);
    } else if (!element.has_faces()) {
      skip_element(values, element);
    } else if (builder.vertices() == vertices) {
      builder.reserve(0, element.count);
      read_faces(values, element, vertices, add);
    } else {
      read_faces(values, element, vertices,
                 [&](std::span<const std::uint32_t> loop) { waiting.emplace_back(loop.begin(), loop.end()); });
    }
  }
  values.expect_end();
  for (const std::vector<std::uint32_t>& loop : waiting) add(loop);
  return builder.finish(file);
}

}  // namespace occlude::render
