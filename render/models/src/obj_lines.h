// SPDX-License-Identifier: MIT
// The statements of an OBJ or MTL file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace occlude::render::obj {

/// Removes the first word of `text` and returns it; empty at the end.
[[nodiscard]] std::string_view next_word(std::string_view& text);
/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Reads a text statement by statement.
class Lines {
 public:
  /// REQUIRES: `file` and `bytes` outlive the object.
  Lines(const std::filesystem::path& file, std::string_view bytes);

  [[nodiscard]] bool are_over() const { return rest_.empty(); }
  /// The bytes that are not read yet.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  /// The next statement, until the next call. Lines that end in a backslash continue on the next line. Throws InputError for
  /// a zero byte.
  [[nodiscard]] std::string_view next();
  /// The number of its first line.
  [[nodiscard]] std::size_t number() const { return line_; }

 private:
  std::string_view take();

  const std::filesystem::path& file_;
  std::string_view rest_;
  std::string joined_;
  std::size_t line_ = 0, next_line_ = 1;
};

}  // namespace occlude::render::obj
