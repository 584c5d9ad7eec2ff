// SPDX-License-Identifier: MIT
// Bytes as a page holds them: compressed, in letters.
#pragma once

#include <string>
#include <string_view>

namespace occlude::render {

/// Compressed by zlib (RFC 1950), which a browser calls "deflate".
[[nodiscard]] std::string deflated(std::string_view bytes);

/// In the letters of RFC 4648, padded.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Both, as the part of a page that page/unpack.js finds by this name.
[[nodiscard]] std::string page_part(std::string_view name, std::string_view bytes);

}  // namespace occlude::render
