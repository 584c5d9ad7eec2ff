// SPDX-License-Identifier: MIT
// Whole numbers as bytes, small ones in one byte: what a page holds of a model and of its frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace occlude::render {

/// A number that is small for a small difference of either sign: 0, 1, 2, 3, ... of 0, -1, 1, -2, ...
[[nodiscard]] constexpr std::uint64_t folded(std::uint64_t difference) {
  return difference << 1 ^ (difference >> 63 == 0 ? 0 : ~std::uint64_t{0});
}

/// Appends `count` numbers of `size` bytes each: first the lowest byte of all, then the next ones. number(i) is called once,
/// in order.
template <class Number>
void append_planes(std::string& text, std::size_t count, std::size_t size, const Number& number) {
  const std::size_t start = text.size();
  text.resize(start + size * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t n = number(i);
    for (std::size_t k = 0; k < size; ++k) text[start + k * count + i] = static_cast<char>(n >> 8 * k & 0xFFU);
  }
}

/// Seven bits a byte, the lowest first; the highest bit says that more follow (LEB128). page/unpack.js reads them.
class Bytes {
 public:
  void number(std::uint64_t n) {
    for (; n > 0x7F; n >>= 7) text_ += static_cast<char>((n & 0x7F) | 0x80);
    text_ += static_cast<char>(n);
  }
  /// A number of either sign, folded.
  void difference(std::int64_t d) { number(folded(static_cast<std::uint64_t>(d))); }
  /// The bytes of another text, after their number.
  void block(const Bytes& bytes) {
    number(bytes.text_.size());
    text_ += bytes.text_;
  }

  /// append_planes() of these numbers.
  template <class Number>
  void planes(std::size_t count, std::size_t size, const Number& number) {
    append_planes(text_, count, size, number);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace occlude::render
