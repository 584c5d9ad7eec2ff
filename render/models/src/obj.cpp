// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model_builder.h"
#include "model_readers.h"
#include "obj_lines.h"
#include "obj_materials.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "text_number.h"

namespace occlude::render {
namespace {

using obj::next_word, obj::trimmed;

constexpr int kBase = 1;  // OBJ counts vertices from 1

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, bool with_colours)
      : file_(file), bytes_(read_input(file)), lines_(file, bytes_), builder_(with_colours), materials_(file) {}

  Model read() {
    while (!lines_.are_over()) read_statement();
    add_faces();
    builder_.notes().warnings = materials_.warnings();
    return builder_.finish(file_);
  }

 private:
  /// A face may use vertices that follow it, so faces are checked at the end.
  struct Face {
    std::size_t line, first;  ///< its first index is indices_[first]
    Surface surface;
  };

  [[nodiscard]] std::string place(std::size_t line) const { return fmt::format("{}:{}", file_.string(), line); }
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw InputError(place(line) + ": " + reason);
  }

  void read_statement() {
    std::string_view statement = lines_.next();
    line_ = lines_.number();
    const std::string_view keyword = next_word(statement);
    if (keyword == "v") {
      read_vertex(statement);
    } else if (keyword == "f") {
      read_face(statement);
    } else if (keyword == "p" || keyword == "l") {
      ++builder_.notes().points_and_lines;
    } else if (keyword == "mtllib") {
      materials_.read(trimmed(statement));
    } else if (keyword == "usemtl") {
      surface_ = materials_.surface(trimmed(statement));
    }
  }

  /// Four numbers have a weight, by which the first three are divided. More are a colour.
  void read_vertex(std::string_view arguments) {
    std::array<double, 4> numbers{0, 0, 0, 1};
    std::size_t count = 0;
    for (auto word = next_word(arguments); !word.empty() && word[0] != '#'; word = next_word(arguments), ++count) {
      if (count >= numbers.size()) continue;
      const auto number = parse_number<double>(word);
      if (!number) fail(line_, "expected a number");
      numbers[count] = *number;
    }
    if (count < 3) fail(line_, "expected a number");
    const glm::dvec3 v{numbers[0], numbers[1], numbers[2]};
    builder_.add_vertex(count == 4 ? v / numbers[3] : v, [&] { return place(line_); });
  }

  void read_face(std::string_view arguments) {
    faces_.push_back({line_, indices_.size(), surface_});
    for (auto word = next_word(arguments); !word.empty() && word[0] != '#'; word = next_word(arguments)) {
      // After a slash come indices of texture coordinates and normals.
      const auto number = parse_number<std::int64_t>(word.substr(0, word.find('/')));
      if (!number) fail(line_, "expected a vertex index, an integer of at most 64 bits");
      indices_.push_back(from_zero(*number));
    }
  }

  /// Indices count from 1. Negative indices count backwards: -1 is the last vertex so far.
  [[nodiscard]] std::int64_t from_zero(std::int64_t index) const {
    if (index > 0) return index - kBase;
    const std::int64_t resolved = static_cast<std::int64_t>(builder_.vertices()) + index;
    if (index == 0 || resolved < 0)
      fail(line_, fmt::format("vertex index {} is out of range ({} vertices so far)", index, builder_.vertices()));
    return resolved;
  }

  void add_faces() {
    std::vector<std::uint32_t> loop;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t end = i + 1 < faces_.size() ? faces_[i + 1].first : indices_.size();
      loop.clear();
      for (std::size_t k = faces_[i].first; k < end; ++k) {
        if (std::cmp_greater_equal(indices_[k], builder_.vertices())) {
          fail(faces_[i].line,
               fmt::format("vertex index {} is out of range ({} vertices)", indices_[k] + kBase, builder_.vertices()));
        }
        loop.push_back(static_cast<std::uint32_t>(indices_[k]));
      }
      builder_.add_face(loop, faces_[i].surface);
    }
  }

  const std::filesystem::path& file_;
  std::string bytes_;
  obj::Lines lines_;
  std::size_t line_ = 0;
  ModelBuilder builder_;
  obj::Materials materials_;
  Surface surface_;  ///< of the material in use
  std::vector<std::int64_t> indices_;
  std::vector<Face> faces_;
};

}  // namespace

Model read_obj(const std::filesystem::path& file, bool with_colours) { return ObjReader(file, with_colours).read(); }

}  // namespace occlude::render
