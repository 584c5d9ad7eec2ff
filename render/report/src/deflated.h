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

}  // namespace occlude::render
