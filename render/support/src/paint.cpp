// SPDX-License-Identifier: MIT
#include "occlude/render/paint.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string_view>

namespace occlude::render {
namespace {

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

Paint::Paint(int descriptor)
    : is_on_(isatty(descriptor) != 0 && environment("NO_COLOR").empty() && environment("TERM") != "dumb") {}

std::string Paint::operator()(Colour colour, const std::string& text) const {
  constexpr std::array<const char*, 3> kCodes{"31", "32", "33"};
  if (!is_on_) return text;
  return std::string("\033[") + kCodes[static_cast<std::size_t>(colour)] + "m" + text + "\033[0m";
}

}  // namespace occlude::render
