// SPDX-License-Identifier: MIT
// Names of files and other text that somebody else chose, as messages, JSON and pages give it.
#pragma once

#include <string>
#include <string_view>

namespace occlude::render {

/// `text` in UTF-8 and on one line: control characters, and bytes that are not UTF-8, as \xNN. Of what is longer than 2000
/// bytes the middle is left out.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace occlude::render
