// SPDX-License-Identifier: MIT
// The values after the header of a PLY file, in any of the three encodings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ply_header.h"

namespace occlude::render::ply {

/// Reads one value after another. Throws InputError, naming the file and, in text, the line, if there is none.
class ValueReader {
 public:
  ValueReader(const std::filesystem::path& file, const Header& header, std::string_view bytes);

  [[nodiscard]] double real(Scalar type);
  /// REQUIRES: is_integer(type).
  [[nodiscard]] std::int64_t integer(Scalar type);
  /// Reads so many integers into `to`. REQUIRES: is_integer(type).
  void integers(Scalar type, std::int64_t count, std::vector<std::int64_t>& to);
  /// Skips `property` of one element.
  void skip(const Property& property);

  /// The bytes that are not read yet.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  /// Throws if the rest of the file is too short for `element`. Call this before allocating memory for it.
  void expect_room_for(const Element& element) const;
  /// Throws if anything follows, except blanks in text.
  void expect_end();
  /// Sets what is being read, for messages: "face 17".
  void enter(const Element& element, std::size_t index) { element_ = &element, index_ = index; }
  /// The file and the place in it: "model.ply: face 17" or, in text, "model.ply:40: face 17".
  [[nodiscard]] std::string place() const;
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  template <class T>
  T take();
  template <class T>
  T take_text();
  template <class T>
  T take_binary();
  void skip_blanks();
  [[nodiscard]] std::string_view token();

  const std::filesystem::path& file_;
  const Element* element_ = nullptr;
  std::size_t index_ = 0;
  Encoding encoding_;
  std::string_view rest_;
  std::size_t line_;
};

}  // namespace occlude::render::ply
