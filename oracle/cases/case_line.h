// SPDX-License-Identifier: MIT
// Case files: JSON Lines, one question each.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cases/case_json.h"

namespace occlude::cases {

/// The object on a line, as render::parse_json reads it: NaN, Infinity and numbers beyond the doubles are what they are, so
/// that the case is refused for them and not the line. Throws LineError.
[[nodiscard]] nlohmann::json parse_object(std::string_view line);

/// Calls `take` with the object on every line that is not blank, in order; "-" is standard input. Throws InputError, naming
/// file and line, for what cannot be read and for the LineErrors of `take`, and Interrupted. Who prints while it works asks
/// for `silence`: no progress between the lines.
void for_each_case(const std::string& file, bool silence,
                   const std::function<void(std::size_t number, const nlohmann::json&)>& take);

}  // namespace occlude::cases
