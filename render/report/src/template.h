// SPDX-License-Identifier: MIT
// Texts with places to fill in.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace occlude::render {

/// The template with each {{name}} replaced by value(name). What is filled in is not searched again.
[[nodiscard]] std::string filled(std::string_view text, const std::function<std::string(std::string_view)>& value);

}  // namespace occlude::render
