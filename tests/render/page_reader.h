// SPDX-License-Identifier: MIT
// Reads what a page holds, independently of the page's own script.
#pragma once

#include <zlib.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace occlude::render {

/// Whole numbers, one after another (bytes.h).
class PageNumbers {
 public:
  explicit PageNumbers(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t next() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.at(at_++));
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return value;
    }
  }
  std::int64_t difference() {
    const std::uint64_t folded = next();
    const auto half = static_cast<std::int64_t>(folded >> 1);
    return (folded & 1U) != 0 ? -half - 1 : half;
  }
  /// The bytes of a block.
  std::string_view block() {
    const std::size_t size = next();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  /// Numbers in planes of bytes.
  std::vector<float> floats(std::size_t count) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < sizeof bits; ++k) {
        bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_.at(at_ + k * count + i))) << 8 * k;
      }
      numbers.push_back(std::bit_cast<float>(bits));
    }
    at_ += sizeof(float) * count;
    return numbers;
  }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// All numbers of the bytes.
inline std::vector<std::uint64_t> page_numbers(std::string_view bytes) {
  std::vector<std::uint64_t> numbers;
  for (PageNumbers reader(bytes); !reader.is_at_end();) numbers.push_back(reader.next());
  return numbers;
}

/// The letters of RFC 4648 as bytes.
inline std::string from_base64(std::string_view letters) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char letter : letters) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kLetters.find(letter));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFU);
  }
  return bytes;
}

inline std::string inflated(std::string_view bytes, std::size_t most) {
  std::string result(most, '\0');
  uLongf size = most;
  if (uncompress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                 static_cast<uLong>(bytes.size())) != Z_OK) {
    return "not deflated";
  }
  result.resize(size);
  return result;
}

}  // namespace occlude::render
