// SPDX-License-Identifier: MIT
#include "obj_materials.h"

#include <fmt/format.h>

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

}  // namespace

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
      see_through_.insert(material);
    }
  }
} catch (const InputError& error) {
  warnings_.push_back(fmt::format("materials are taken for opaque: {}", error.what()));
}

}  // namespace occlude::render::obj
