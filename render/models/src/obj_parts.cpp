// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "obj_lines.h"
#include "occlude/render/input_file.h"
#include "part_readers.h"

namespace occlude::render {
namespace {

using obj::next_word, obj::trimmed;

/// A face of fewer corners is none of the model.
bool is_of_model(std::string_view corners) {
  std::size_t count = 0;
  for (auto word = next_word(corners); !word.empty() && word[0] != '#'; word = next_word(corners)) ++count;
  return count >= 3;
}

/// Calls take(keyword, arguments, bytes) for each statement, with all its bytes in the file.
template <class Take>
void for_each_statement(const std::filesystem::path& file, std::string_view bytes, const Take& take) {
  obj::Lines lines(file, bytes);
  while (!lines.are_over()) {
    const std::size_t begin = bytes.size() - lines.left();
    std::string_view statement = lines.next();
    const std::size_t end = bytes.size() - lines.left();
    const std::string_view keyword = next_word(statement);
    take(keyword, statement, bytes.substr(begin, end - begin));
  }
}

}  // namespace

FileParts obj_parts(const std::filesystem::path& file) {
  const std::string bytes = read_input(file);
  FileParts result;
  std::string object, group, material;
  std::uint64_t faces = 0;
  bool is_new = true;
  const auto name = [&](std::string& what, std::string_view arguments) {
    what = trimmed(arguments);
    is_new = true;
  };
  const auto begin_part = [&] {
    ModelPart part{object.empty() ? group : object, {}, faces, 0, result.parts.size(), result.parts.size()};
    for (const std::string& known : {object, group, material}) {
      if (!known.empty()) part.names.push_back(known);
    }
    result.parts.push_back(part);
    is_new = false;
  };
  for_each_statement(file, bytes, [&](std::string_view keyword, std::string_view arguments, std::string_view) {
    if (keyword == "o") {
      name(object, arguments);
    } else if (keyword == "g") {
      name(group, arguments);
    } else if (keyword == "usemtl") {
      name(material, arguments);
    } else if (keyword == "mtllib") {
      result.files.emplace_back(trimmed(arguments));
    } else if (keyword == "f" && is_of_model(arguments)) {
      if (is_new) begin_part();
      ++result.parts.back().count;
      ++faces;
    }
  });
  return result;
}

std::string obj_without(const std::filesystem::path& file, const std::vector<bool>& gone) {
  const std::string bytes = read_input(file);
  std::string kept;
  std::size_t face = 0;
  for_each_statement(file, bytes, [&](std::string_view keyword, std::string_view arguments, std::string_view all) {
    const bool goes = keyword == "f" && is_of_model(arguments) && gone[face++];
    if (!goes) kept += all;
  });
  return kept;
}

}  // namespace occlude::render
