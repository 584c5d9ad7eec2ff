// SPDX-License-Identifier: MIT
// Standard output, of which no byte may be lost, and standard error, which nobody need hear.
#pragma once

#include <string_view>

namespace occlude::render {

/// Puts something in the place of closed standard streams, so that no file of the program becomes one of them. It can be
/// neither read nor printed to. To be called first of all.
void hold_standard_streams();

/// Prints. Throws InputError when standard output cannot be written.
void print(std::string_view text);

/// Throws InputError when something printed before could not be written.
void finish_printing();

/// Says something to the user, on standard error.
void say(std::string_view text);

}  // namespace occlude::render
