// SPDX-License-Identifier: MIT
#include <string>

#include "model_check.h"
#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "ply_header.h"
#include "ply_values.h"

namespace occlude::render {
namespace {

using culler::PolygonSoup;
using ply::Element;
using ply::Header;
using ply::Property;
using ply::ValueReader;

void read_vertices(ValueReader& values, const Element& element, PolygonSoup& soup) {
  soup.vertices.reserve(element.count);
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
    if (const auto fault = vertex_fault(v)) values.fail(*fault);
    soup.vertices.push_back(v);
  }
}

void read_loop(ValueReader& values, const Property& property, std::vector<std::int64_t>& loop) {
  const std::int64_t count = values.integer(*property.count);
  if (count < 0) values.fail("the list has a negative length");
  loop.clear();
  for (std::int64_t i = 0; i < count; ++i) loop.push_back(values.integer(property.type));
}

const Property* loop_property(const Element& face) {
  const Property* plural = face.find("vertex_indices");
  return plural != nullptr ? plural : face.find("vertex_index");
}

void read_faces(ValueReader& values, const Element& element, std::size_t vertices, PolygonSoup& soup) {
  const Property* const indices = loop_property(element);
  std::vector<std::int64_t> loop;
  soup.first.reserve(element.count + 1);
  for (std::size_t i = 0; i < element.count; ++i) {
    values.enter(element, i);
    for (const Property& property : element.properties) {
      if (&property == indices) {
        read_loop(values, property, loop);
      } else {
        values.skip(property);
      }
    }
    if (const auto fault = loop_fault(loop, vertices)) values.fail(*fault);
    add_polygon(soup, loop);
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
  const Element* const face = header.find("face");
  if (face == nullptr) throw InputError(file.string() + ": no polygons");
  const Property* const indices = loop_property(*face);
  if (indices == nullptr || !indices->count || !ply::is_integer(indices->type))
    throw InputError(file.string() + ": element face has no list of integers vertex_indices");
}

}  // namespace

PolygonSoup read_ply(const std::filesystem::path& file) {
  const std::string bytes = read_input(file);
  const Header header = ply::read_header(file, bytes);
  require_declarations(file, header);
  ValueReader values(file, header, bytes);
  PolygonSoup soup;
  for (const Element& element : header.elements) {
    values.expect_room_for(element);
    if (element.name == "vertex") {
      read_vertices(values, element, soup);
    } else if (element.name == "face") {
      read_faces(values, element, header.find("vertex")->count, soup);
    } else {
      skip_element(values, element);
    }
  }
  values.expect_end();
  require_usable(file, soup);
  return soup;
}

}  // namespace occlude::render
