// SPDX-License-Identifier: MIT
// Case files: JSON Lines with one question each.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cases/case_json.h"

namespace occlude::cases {

/// The object on a line, read by render::parse_json. NaN, Infinity and numbers beyond the range of doubles are accepted as
/// such, so that the case is refused for them and not the line. Throws LineError.
[[nodiscard]] nlohmann::json parse_object(std::string_view line);

/// Calls `take` with the number and the object of every line that is not blank, in order. "-" is standard input. Throws
/// InputError, with file and line, for what cannot be read and for the LineErrors of `take`, and for a file without a case.
/// Throws Interrupted. With `silence` no progress is shown, for callers that print while they work.
void for_each_case(const std::string& file, bool silence,
                   const std::function<void(std::size_t number, const nlohmann::json&)>& take);

}  // namespace occlude::cases
