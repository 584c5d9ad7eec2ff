// SPDX-License-Identifier: MIT
#include "obj_materials.h"

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <optional>

#include "colours.h"
#include "obj_lines.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "text_number.h"

namespace occlude::render::obj {
namespace {

/// Whether a statement of a material says that it lets light through.
bool is_see_through(std::string_view keyword, std::string_view arguments) {
  if (keyword == "map_d" || keyword == "map_Tr") return true;
  if (keyword != "d" && keyword != "Tr") return false;
  std::string_view word = next_word(arguments);
  if (word == "-halo") word = next_word(arguments);
  const auto number = parse_number<double>(word);
  return number && (keyword == "d" ? *number < 1 : *number > 0);
}

/// Of the arguments of Kd: three numbers, or one for all. Nothing for other ways to name a colour.
std::optional<Rgb> colour_in(std::string_view arguments) {
  glm::dvec3 colour;
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view word = next_word(arguments);
    const auto number = parse_number<double>(word);
    if (channel == 1 && word.empty()) return rgb_of(glm::dvec3(colour.r));
    if (!number) return std::nullopt;
    colour[channel] = *number;
  }
  return rgb_of(colour);
}

}  // namespace

Surface Materials::surface(std::string_view name) const {
  const auto found = surfaces_.find(name);
  return found == surfaces_.end() ? Surface() : found->second;
}

void Materials::read(std::string_view names) {
  std::error_code error;
  const auto place = [&](std::string_view name) { return file_.parent_path() / std::filesystem::path(name); };
  if (std::filesystem::exists(place(names), error)) return read_file(place(names));
  for (std::string_view name = next_word(names); !name.empty(); name = next_word(names)) read_file(place(name));
}

void Materials::read_file(const std::filesystem::path& file) try {
  if (!read_.insert(file.string()).second) return;
  const std::string bytes = read_input(file);
  Lines lines(file, bytes);
  std::string material;
  while (!lines.are_over()) {
    std::string_view statement = lines.next();
    const std::string_view keyword = next_word(statement);
    if (keyword == "newmtl") {
      material = trimmed(statement);
    } else if (is_see_through(keyword, statement)) {
      surfaces_[material].is_opaque = false;
    } else if (keyword == "Kd") {
      if (const auto colour = colour_in(statement)) surfaces_[material].colour = *colour;
    }
  }
} catch (const InputError& error) {
  warnings_.push_back(fmt::format("materials are taken for opaque: {}", error.what()));
}

}  // namespace occlude::render::obj
