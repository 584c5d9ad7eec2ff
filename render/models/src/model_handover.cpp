// SPDX-License-Identifier: MIT
#include "model_handover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model_check.h"

namespace occlude::render {
namespace {

using culler::PolygonSoup;

/// The arrays of a model, and the numbers of its notes, in the order in which they are handed over. Arrays are written as
/// their length and their items.
template <class SomeModel, class Array, class Number>
void each_part(SomeModel& model, const Array& array, const Number& number) {
  array(model.soup.vertices), array(model.soup.indices), array(model.soup.first);
  array(model.soup.faces), array(model.soup.see_through);
  auto& notes = model.notes;
  number(notes.file.metres), number(notes.file.up), number(notes.rounding);
  number(notes.triangulated), number(notes.crossing), number(notes.without_area), number(notes.few_corners);
  number(notes.points_and_lines), number(notes.unused_vertices), number(notes.unsound_vertices), number(notes.tiny_numbers);
}

bool are_faces(std::span<const std::uint32_t> faces, std::size_t polygons) {
  if (faces.empty()) return true;
  const auto does_not_follow = [](std::uint32_t before, std::uint32_t face) { return face - before > 1; };
  return faces.size() == polygons && faces[0] == 0 && std::ranges::adjacent_find(faces, does_not_follow) == faces.end();
}

bool is_well_formed(const Convention& convention) {
  const glm::dvec3& up = convention.up;
  return convention.metres >= 0 && std::isfinite(convention.metres) &&
         (up == glm::dvec3(0) || parse_up(up_in_words(up)) == up);
}

bool is_well_formed(const PolygonSoup& soup) {
  const auto is_short = [](std::uint32_t begin, std::uint32_t end) { return end < begin || end - begin < 3; };
  return !soup.first.empty() && soup.first.front() == 0 && soup.first.back() == soup.indices.size() &&
         std::ranges::adjacent_find(soup.first, is_short) == soup.first.end() &&
         std::ranges::all_of(soup.indices, [&](std::uint32_t index) { return index < soup.vertices.size(); }) &&
         std::ranges::none_of(soup.vertices, [](const glm::dvec3& v) { return vertex_fault(v).has_value(); }) &&
         are_faces(soup.faces, soup.size()) &&
         (soup.see_through.empty() || (soup.see_through.size() == soup.size() &&
                                       std::ranges::all_of(soup.see_through, [](auto mark) { return mark <= 1; })));
}

}  // namespace

void hand_over(const Model& model, HandoverWriter& writer) {
  each_part(
      model, [&](const auto& items) { writer.put(items); }, [&](const auto& number) { writer.put_number(number); });
  writer.put_number(model.notes.warnings.size());
  for (const std::string& warning : model.notes.warnings) writer.put(warning);
}

void take_over(Model& model, HandoverReader& reader) {
  each_part(
      model, [&](auto& items) { reader.take(items); }, [&](auto& number) { reader.take_number(number); });
  std::size_t warnings = 0;
  reader.take_number(warnings);
  for (; warnings > 0; --warnings) reader.take(model.notes.warnings.emplace_back());
  if (!is_well_formed(model.soup) || !is_well_formed(model.notes.file)) refuse_damage();
}

}  // namespace occlude::render
