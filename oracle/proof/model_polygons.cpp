// SPDX-License-Identifier: MIT
#include "model_polygons.h"

#include <fmt/format.h>

#include "occlude/render/input_limits.h"

namespace occlude::proof {
namespace {

using Json = nlohmann::json;

oracle::Point point(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Adds a polygon to a cover. `vertices` are those of the line so far.
void add(oracle::Loop loop, std::vector<oracle::Loop>& cover, std::size_t& vertices) {
  vertices += loop.size();
  if (vertices > render::kMostWitnessVertices)
    throw LineError(fmt::format("\"polygons\": more than {} vertices", render::kMostWitnessVertices));
  cover.push_back(std::move(loop));
}

}  // namespace

std::array<std::size_t, 2> run_of(const Json& run, const char* name) {
  if (!run.is_array() || run.size() != 2 || !run[0].is_number_unsigned() || !run[1].is_number_unsigned())
    throw LineError(fmt::format("\"{}\": expected [first, count]", name));
  return {run[0].get<std::size_t>(), run[1].get<std::size_t>()};
}

ModelPolygons::ModelPolygons(const culler::Hierarchy& hierarchy) : hierarchy_(hierarchy) {
  const auto size = static_cast<std::uint32_t>(hierarchy.soup().size());
  place_.resize(size);
  for (std::uint32_t p = 0; p < size; ++p) place_[hierarchy.original(p)] = p;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (i == 0 || hierarchy.face(place_[i]) != hierarchy.face(place_[i - 1])) first_piece_.push_back(i);
  }
  first_piece_.push_back(size);
}

std::optional<std::uint32_t> ModelPolygons::named(const Json& name) const {
  const bool is_piece = name.is_array() && name.size() == 2;
  const Json& number = is_piece ? name[0] : name;
  if (!number.is_number_unsigned() || (is_piece && !name[1].is_number_unsigned())) {
    throw LineError("\"polygons\": expected a list of numbers of polygons, or of [number, piece]");
  }
  const auto face = number.get<std::size_t>();
  if (face >= faces()) return std::nullopt;
  const std::size_t piece = is_piece ? name[1].get<std::size_t>() : 0;
  if (is_piece ? piece >= pieces(face).size() : pieces(face).size() > 1) return std::nullopt;
  return pieces(face)[piece];
}

std::optional<culler::FanTriangle> ModelPolygons::named_triangle(const Json& name) const {
  if (!name.is_array() || name.size() != 2 || !name[1].is_number_unsigned())
    throw LineError("\"triangles\": expected a list of [polygon, corner]");
  const std::optional<std::uint32_t> p = named(name[0]);
  const auto corner = name[1].get<std::size_t>();
  if (!p || corner == 0 || corner + 1 >= hierarchy_.soup().loop(*p).size()) return std::nullopt;
  return culler::FanTriangle{*p, static_cast<std::uint32_t>(corner)};
}

CoverOrFault ModelPolygons::cover(const Json& names, std::size_t& vertices) const {
  if (!names.is_array()) throw LineError("\"polygons\": expected a list of numbers of polygons");
  std::vector<oracle::Loop> cover;
  for (const Json& name : names) {
    const std::optional<std::uint32_t> p = named(name);
    if (!p) return {{}, "no such polygon"};
    if (!hierarchy_.soup().is_opaque(*p)) return {{}, "a see-through polygon hides nothing"};
    add(loop(*p), cover, vertices);
  }
  return {std::move(cover), ""};
}

std::string ModelPolygons::append_triangles(const Json& names, std::vector<oracle::Loop>& cover,
                                            std::size_t& vertices) const {
  if (!names.is_array()) throw LineError("\"triangles\": expected a list of [polygon, corner]");
  for (const Json& name : names) {
    const std::optional<culler::FanTriangle> t = named_triangle(name);
    if (!t) return "no such triangle";
    if (!hierarchy_.soup().is_opaque(t->polygon)) return "a see-through polygon hides nothing";
    const oracle::Triangle corners = triangle(*t);
    add({corners.begin(), corners.end()}, cover, vertices);
  }
  return "";
}

oracle::Loop ModelPolygons::loop(std::uint32_t p) const {
  oracle::Loop loop;
  for (const std::uint32_t index : hierarchy_.soup().loop(p)) loop.push_back(point(hierarchy_.soup().vertices[index]));
  return loop;
}

oracle::Triangle ModelPolygons::triangle(const culler::FanTriangle& t) const {
  const auto loop = hierarchy_.soup().loop(t.polygon);
  const auto at = [&](std::size_t i) { return point(hierarchy_.soup().vertices[loop[i]]); };
  return {at(0), at(t.corner), at(t.corner + std::size_t{1})};
}

}  // namespace occlude::proof
