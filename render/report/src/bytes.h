// SPDX-License-Identifier: MIT
// Whole numbers as bytes, small ones in one byte: what a page holds of a model and of its frames.
#pragma once

#include <cstdint>
#include <string>

namespace occlude::render {

/// Seven bits a byte, the lowest first; the highest bit says that more follow (LEB128). page/unpack.js reads them.
class Bytes {
 public:
  void number(std::uint64_t n) {
    for (; n > 0x7F; n >>= 7) text_ += static_cast<char>((n & 0x7F) | 0x80);
    text_ += static_cast<char>(n);
  }
  /// A number of either sign: 0, -1, 1, -2, ... are stored as 0, 1, 2, 3, ...
  void difference(std::int64_t d) {
    number(d < 0 ? ~(static_cast<std::uint64_t>(d) << 1) : static_cast<std::uint64_t>(d) << 1);
  }
  /// The bytes of another text, after their number.
  void block(const Bytes& bytes) {
    number(bytes.text_.size());
    text_ += bytes.text_;
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace occlude::render
