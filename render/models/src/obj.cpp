// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model_check.h"
#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "text_number.h"

namespace occlude::render {
namespace {

constexpr int kBase = 1;  // OBJ counts vertices from 1

/// Removes the first word of `text` and returns it; empty at the end.
std::string_view next_word(std::string_view& text) {
  constexpr std::string_view kBlank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlank));
  text.remove_prefix(word.size());
  return word;
}

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& file) : file_(file), bytes_(read_input(file)), rest_(bytes_) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // some editors write it at the start
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }

  culler::PolygonSoup read() {
    while (!rest_.empty()) read_statement();
    add_faces();
    require_usable(file_, soup_);
    return std::move(soup_);
  }

 private:
  /// A face may use vertices that follow it, so faces are checked at the end.
  struct Face {
    std::size_t line, first;  ///< its first index is indices_[first]
  };

  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), line, reason));
  }

  /// The next statement. Lines that end in a backslash continue on the next line. line_ is the first line.
  std::string_view next_statement() {
    line_ = next_line_;
    std::string_view part = take_line();
    if (!part.ends_with('\\')) return part;
    joined_.clear();
    while (part.ends_with('\\')) {
      part.remove_suffix(1);
      joined_.append(part).push_back(' ');
      part = take_line();
    }
    return joined_.append(part);
  }

  /// Lines end in LF, CR LF or CR.
  std::string_view take_line() {
    const std::string_view line = rest_.substr(0, rest_.find_first_of("\r\n"));
    rest_.remove_prefix(line.size());
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
    if (line.find('\0') != line.npos) fail(next_line_, "zero byte: this is not a text file");
    ++next_line_;
    return line;
  }

  void read_statement() {
    std::string_view statement = next_statement();
    const std::string_view keyword = next_word(statement);
    if (keyword == "v") {
      read_vertex(statement);
    } else if (keyword == "f") {
      read_face(statement);
    }
  }

  void read_vertex(std::string_view arguments) {
    glm::dvec3 v{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = parse_number<double>(next_word(arguments));
      if (!number) fail(line_, "expected a number");
      v[axis] = *number;
    }
    if (const auto fault = vertex_fault(v)) fail(line_, *fault);
    soup_.vertices.push_back(v);
  }

  void read_face(std::string_view arguments) {
    faces_.push_back({line_, indices_.size()});
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
    const std::int64_t resolved = static_cast<std::int64_t>(soup_.vertices.size()) + index;
    if (index == 0 || resolved < 0)
      fail(line_, fmt::format("vertex index {} is out of range ({} vertices so far)", index, soup_.vertices.size()));
    return resolved;
  }

  void add_faces() {
    const std::span<const std::int64_t> all(indices_);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t end = i + 1 < faces_.size() ? faces_[i + 1].first : indices_.size();
      const auto loop = all.subspan(faces_[i].first, end - faces_[i].first);
      if (const auto fault = loop_fault(loop, soup_.vertices.size(), kBase)) fail(faces_[i].line, *fault);
      add_polygon(soup_, loop);
    }
  }

  const std::filesystem::path& file_;
  std::string bytes_, joined_;
  std::string_view rest_;
  std::size_t line_ = 0, next_line_ = 1;
  culler::PolygonSoup soup_;
  std::vector<std::int64_t> indices_;
  std::vector<Face> faces_;
};

}  // namespace

culler::PolygonSoup read_obj(const std::filesystem::path& file) { return ObjReader(file).read(); }

}  // namespace occlude::render
