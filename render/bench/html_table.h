// SPDX-License-Identifier: MIT
// Tables on a page.
#pragma once

#include <string>

#include "table.h"

namespace occlude::experiments {

using bench::Table;

/// A heading and what is below it.
[[nodiscard]] std::string section(const std::string& title, const std::string& body);

/// Without the title.
[[nodiscard]] std::string html_of(const Table& table);

/// The same below its title.
[[nodiscard]] std::string section(const Table& table);

}  // namespace occlude::experiments
