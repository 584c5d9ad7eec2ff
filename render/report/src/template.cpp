// SPDX-License-Identifier: MIT
#include "template.h"

namespace occlude::render {

std::string filled(std::string_view text, const std::function<std::string(std::string_view)>& value) {
  std::string result;
  while (true) {
    const std::size_t open = text.find("{{"), close = text.find("}}", open);
    if (close == std::string_view::npos) return result += text;
    result += text.substr(0, open);
    result += value(text.substr(open + 2, close - open - 2));
    text.remove_prefix(close + 2);
  }
}

}  // namespace occlude::render
