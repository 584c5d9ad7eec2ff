// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "colours.h"
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

/// The colour of each vertex or face of an element that has one.
class ColourReader {
 public:
  ColourReader(ValueReader& values, const Element& element, bool with_colours)
      : values_(values), is_there_(with_colours && std::ranges::all_of(kChannels, [&](const char* channel) {
                                     const Property* const property = element.find(channel);
                                     return property != nullptr && !property->count;
                                   })) {}

  [[nodiscard]] bool is_there() const { return is_there_; }
  /// Reads the property, if it is of the colour.
  [[nodiscard]] bool takes(const Property& property) {
    if (!is_there_) return false;
    const auto* const channel = std::ranges::find(kChannels, property.name);
    if (channel == kChannels.end()) return false;
    colour_[static_cast<int>(channel - kChannels.begin())] = values_.real(property.type) / most(property.type);
    return true;
  }
  /// Of what was read last.
  [[nodiscard]] Rgb colour() const { return is_there_ ? rgb_of(colour_) : kWhite; }

 private:
  /// What all light is in this type.
  static double most(ply::Scalar type) {
    if (!ply::is_integer(type)) return 1;
    return ply::size_of(type) == 2 ? 65535 : 255;
  }
  static constexpr std::array<const char*, 3> kChannels = {"red", "green", "blue"};

  ValueReader& values_;
  const bool is_there_;
  glm::dvec3 colour_{1};
};

/// Adds the vertices, and their colours to `colours`.
void read_vertices(ValueReader& values, const Element& element, ModelBuilder& builder, ColourReader colour,
                   std::vector<Rgb>& colours) {
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    glm::dvec3 v{0, 0, 0};
    for (const Property& property : element.properties) {
      const char axis = property.name.size() == 1 ? property.name[0] : '\0';
      if (axis >= 'x' && axis <= 'z') {
        v[axis - 'x'] = values.real(property.type);
      } else if (!colour.takes(property)) {
        values.skip(property);
      }
    }
    if (colour.is_there()) colours.push_back(colour.colour());
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

/// Calls add(loop, colour) for each face of an element of faces or strips.
template <class Add>
void read_faces(ValueReader& values, const Element& element, std::size_t vertices, ColourReader colour, const Add& add) {
  const Property* const indices = element.loop();
  const bool is_strip = element.name == ply::kStrips;
  LoopReader loops(values, vertices, is_strip);
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    std::span<const std::uint32_t> loop;
    for (const Property& property : element.properties) {
      if (&property == indices) {
        loop = loops.read(property);
      } else if (!colour.takes(property)) {
        values.skip(property);
      }
    }
    const auto add_face = [&](std::span<const std::uint32_t> face) { add(face, colour.colour()); };
    if (is_strip) {
      ply::for_each_triangle(loop, add_face);
    } else {
      add_face(loop);
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

Model read_ply(const std::filesystem::path& file, bool with_colours) {
  const std::string bytes = read_input(file);
  const Header header = ply::read_header(file, bytes);
  require_declarations(file, header);
  ValueReader values(file, header, bytes);
  ModelBuilder builder(with_colours);
  std::vector<Rgb> colours;  // of vertices
  const auto add = [&](std::span<const std::uint32_t> loop, const Rgb& colour) {
    builder.add_face(loop, {.colour = colours.empty() || loop.empty() ? colour : mean_colour(loop, colours)});
  };
  // Elements may come in any order, and faces need their vertices.
  const std::size_t vertices = header.find("vertex")->count;
  struct Face {
    std::vector<std::uint32_t> loop;
    Rgb colour;
  };
  std::vector<Face> waiting;
  for (const Element& element : header.elements) {
    values.expect_room_for(element);
    const ColourReader colour(values, element, with_colours);
    if (element.name == "vertex") {
      builder.reserve(element.count, 0);
      read_vertices(values, element, builder, colour, colours);
    } else if (!element.has_faces()) {
      skip_element(values, element);
    } else if (builder.vertices() == vertices) {
      builder.reserve(0, element.count);
      read_faces(values, element, vertices, colour, add);
    } else {
      read_faces(values, element, vertices, colour, [&](std::span<const std::uint32_t> loop, const Rgb& of_face) {
        waiting.push_back({{loop.begin(), loop.end()}, of_face});
      });
    }
  }
  values.expect_end();
  for (const Face& face : waiting) add(face.loop, face.colour);
  return builder.finish(file);
}

}  // namespace occlude::render
