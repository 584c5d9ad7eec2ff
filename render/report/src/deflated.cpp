// SPDX-License-Identifier: MIT
#include "deflated.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

namespace occlude::render {

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  // The room is enough and the level exists, so only memory can be short.
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();
  }
  result.resize(size);
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> std::uint32_t {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    const std::array<std::uint32_t, 4> letters{three >> 18, three >> 12, three >> 6, three};
    for (std::size_t k = 0; k < 4; ++k) result += i + k <= bytes.size() ? kLetters[letters[k] & 63U] : '=';
  }
  return result;
}

std::string page_part(std::string_view name, std::string_view bytes) {
  return fmt::format("<script type=\"application/octet-stream\" id=\"part-{}\">{}</script>\n", name,
                     base64(deflated(bytes)));
}

}  // namespace occlude::render
