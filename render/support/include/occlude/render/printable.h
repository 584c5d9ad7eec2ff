// SPDX-License-Identifier: MIT
// Untrusted text, such as file names, made safe for messages, JSON and pages.
#pragma once

#include <string>
#include <string_view>

namespace occlude::render {

/// `text` as one line of UTF-8. Control characters, and bytes that are not UTF-8, become \xNN. Text longer than 2000 bytes
/// loses its middle.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace occlude::render
