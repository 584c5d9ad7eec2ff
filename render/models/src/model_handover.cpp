// SPDX-License-Identifier: MIT
#include "model_handover.h"

#include <algorithm>
#include <cmath>

#include "model_check.h"

namespace occlude::render {
namespace {

/// The arrays of a model, and the numbers of its notes, in the order in which they are handed over. Arrays are written as
/// their length and their items.
template <class SomeModel, class Array, class Number>
void each_part(SomeModel& model, const Array& array, const Number& number) {
  array(model.soup.vertices), array(model.soup.indices), array(model.soup.first);
  array(model.soup.faces), array(model.soup.see_through), array(model.colours);
  auto& notes = model.notes;
  number(notes.file.metres), number(notes.file.up), number(notes.rounding);
  number(notes.triangulated), number(notes.crossing), number(notes.without_area), number(notes.few_corners);
  number(notes.points_and_lines), number(notes.unused_vertices), number(notes.unsound_vertices), number(notes.tiny_numbers);
}

bool is_sound(const Convention& convention) {
  const glm::dvec3& up = convention.up;
  return convention.metres >= 0 && std::isfinite(convention.metres) &&
         (up == glm::dvec3(0) || parse_up(up_in_words(up)) == up);
}

bool is_sound(const culler::PolygonSoup& soup) {
  return culler::is_well_formed(soup) && std::ranges::all_of(soup.vertices, is_legal);
}

}  // namespace

void hand_over(const Model& model, HandoverWriter& writer) {
  each_part(
      model, [&](const auto& items) { writer.put(items); }, [&](const auto& number) { writer.put_number(number); });
  writer.put_texts(model.notes.warnings);
}

void take_over(Model& model, HandoverReader& reader) {
  each_part(
      model, [&](auto& items) { reader.take(items); }, [&](auto& number) { reader.take_number(number); });
  reader.take_texts(model.notes.warnings);
  const bool has_all_colours = model.colours.empty() || model.colours.size() == model.soup.size();
  if (!is_sound(model.soup) || !has_all_colours || !is_sound(model.notes.file)) refuse_damage();
}

}  // namespace occlude::render
