// SPDX-License-Identifier: MIT
// The exceptions that the commands turn into messages and exit codes.
#pragma once

#include <stdexcept>
#include <string>

namespace occlude::render {

/// Input or output that cannot be used. The message is one line that names the file and the place in it; the command
/// prints it and exits with 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Ctrl-C was pressed; everything unfinished has been removed. The command exits with 130.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace occlude::render
