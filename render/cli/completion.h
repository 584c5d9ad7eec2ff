// SPDX-License-Identifier: MIT
// The completion of commands and options in a shell.
#pragma once

#include <string>

#include "command_text.h"

namespace occlude::cli {

/// A script for bash to source. Words that are neither commands, options nor one of a few values are completed as files.
[[nodiscard]] std::string bash_completion(const CommandText& program);

}  // namespace occlude::cli
