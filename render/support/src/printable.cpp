// SPDX-License-Identifier: MIT
#include "occlude/render/printable.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace occlude::render {
namespace {

// Bytes kept at each end: enough for a path at the start and the fault at the end, and less than a screen.
constexpr std::size_t kEnd = 1000;

/// The length of the first character of `text` in bytes; 0 for a control character or an invalid byte.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint32_t{0}; };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  std::uint32_t code = lead & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  // The first valid character of each length; for two bytes it follows the control characters U+0080 to U+009F. Smaller
  // codes are overlong forms or come from invalid lead bytes.
  const std::uint32_t least = length == 2 ? 0xa0 : length == 3 ? 0x800 : 0x10000;
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  return lead >= 0xc0 && lead < 0xf8 && code >= least && code <= 0x10ffff && !is_surrogate ? length : 0;
}

}  // namespace

std::string printable(std::string_view text) {
  if (text.size() > 2 * kEnd) {
    return printable(text.substr(0, kEnd)) + " ... " + printable(text.substr(text.size() - kEnd));
  }
  std::string result;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    if (length == 0) result += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(text[0]));
    result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace occlude::render
