// SPDX-License-Identifier: MIT
#include "cases/json_input.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>

#include "occlude/render/input_limits.h"
#include "occlude/render/json_text.h"

namespace occlude::cases {

using Json = nlohmann::json;

namespace {

LineError wrong(const char* member, const std::string& what) { return LineError('"' + std::string(member) + "\": " + what); }

std::uint32_t index(const Json& value) {
  if (!value.is_number_unsigned()) throw wrong("faces", "expected indices, which are whole numbers from 0");
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(value.get<std::uint64_t>(), kLast));
}

std::vector<std::vector<std::uint32_t>> faces(const Json& value) {
  constexpr const char* kExpected = "expected an array of arrays of indices";
  if (!value.is_array()) throw wrong("faces", kExpected);
  std::vector<std::vector<std::uint32_t>> result;
  for (const Json& loop : value) {
    if (!loop.is_array()) throw wrong("faces", kExpected);
    std::ranges::transform(loop, std::back_inserter(result.emplace_back()), index);
  }
  return result;
}

std::size_t corners(const kernel::Polytope& polytope) {
  std::size_t sum = polytope.vertices.size();
  for (const auto& face : polytope.faces) sum += face.size();
  return sum;
}

kernel::Obb oriented_box(const Json& value) {
  const auto half_edges = vec3s(member(value, "half_edges"), "half_edges");
  if (half_edges.size() != 3) throw wrong("half_edges", "expected three of them");
  return {vec3(member(value, "center"), "center"), {half_edges[0], half_edges[1], half_edges[2]}};
}

}  // namespace

const Json& member(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw LineError('"' + std::string(name) + "\" is missing");
  return *found;
}

double number(const Json& value, const char* name) {
  if (const auto number = render::number_of(value)) return *number;
  throw wrong(name, "expected a number");
}

kernel::Vec3 vec3(const Json& value, const char* name) {
  if (!value.is_array() || value.size() != 3) throw wrong(name, "expected [x, y, z]");
  return {number(value[0], name), number(value[1], name), number(value[2], name)};
}

std::vector<kernel::Vec3> vec3s(const Json& value, const char* name) {
  if (!value.is_array()) throw wrong(name, "expected an array of [x, y, z]");
  std::vector<kernel::Vec3> points;
  for (const Json& point : value) points.push_back(vec3(point, name));
  return points;
}

kernel::Viewpoint viewpoint(const Json& object) {
  if (object.contains("direction") && object.contains("eye")) throw LineError("both \"eye\" and \"direction\"");
  if (object.contains("direction")) return kernel::Viewpoint::direction(vec3(object["direction"], "direction"));
  return kernel::Viewpoint::eye(vec3(member(object, "eye"), "eye"));
}

Box box(const Json& object) {
  const Json& value = member(object, "box");
  if (!value.is_object()) throw wrong("box", "expected an object");
  const bool oriented = value.contains("center") || value.contains("half_edges");
  if (oriented && (value.contains("min") || value.contains("max"))) throw wrong("box", "both \"min\" and \"center\"");
  if (!oriented) return kernel::Aabb{vec3(member(value, "min"), "min"), vec3(member(value, "max"), "max")};
  return oriented_box(value);
}

kernel::ViewRegion view_region(const Json& object) {
  const bool are_directions = object.contains("directions");
  for (const char* other : {are_directions ? "eyes" : "directions", "eye", "direction"}) {
    if (object.contains(other)) throw LineError("a region of viewpoints and \"" + std::string(other) + '"');
  }
  const char* const name = are_directions ? "directions" : "eyes";
  const Json& value = member(object, name);
  if (!value.is_object()) throw wrong(name, "expected an object");
  if (value.contains("radius")) throw wrong(name, "expected a box, by \"center\" and \"half_edges\"");
  const kernel::Obb box = oriented_box(value);
  return are_directions ? kernel::ViewRegion::directions(box) : kernel::ViewRegion::eyes(box);
}

Occluder occluder(const Json& value) {
  if (!value.is_object()) throw LineError("expected an occluder to be an object");
  if (value.contains("cover")) throw wrong("cover", "an occluder of several polygons is for occlude classify");
  const bool has_faces = value.contains("vertices") || value.contains("faces");
  if (has_faces && value.contains("polygon")) throw LineError("both \"polygon\" and \"vertices\"");
  if (!has_faces) return vec3s(member(value, "polygon"), "polygon");
  kernel::Polytope polytope{vec3s(member(value, "vertices"), "vertices"), faces(member(value, "faces"))};
  if (corners(polytope) > kMostCorners) {
    throw wrong("occluder",
                "a polytope with more than " + std::to_string(kMostCorners) + " vertices, those of its faces counted");
  }
  return polytope;
}

std::vector<Polygon> cover(const Json& value) {
  if (!value.is_array()) throw wrong("cover", "expected an array of polygons");
  std::vector<Polygon> polygons;
  std::size_t vertices = 0;
  for (const Json& polygon : value) {
    polygons.push_back(vec3s(polygon, "cover"));
    vertices += polygons.back().size();
    if (vertices > render::kMostCoverVertices)
      throw wrong("cover", "more than " + std::to_string(render::kMostCoverVertices) + " vertices");
  }
  return polygons;
}

}  // namespace occlude::cases
