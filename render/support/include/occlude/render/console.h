// SPDX-License-Identifier: MIT
// Standard output, whose errors are reported, and standard error, whose errors are ignored.
#pragma once

#include <string_view>

namespace occlude::render {

/// Opens /dev/null for each closed standard stream, so that no file of the program becomes one of them. Reading from it or
/// printing to it fails. Call this before anything else.
void hold_standard_streams();

/// From now on tell() prints nothing and no Progress is shown.
void be_quiet();
[[nodiscard]] bool is_quiet();

/// From now on nothing is printed, errors neither: of several processes that do the same, one speaks.
void be_silent();

/// Prints a result for people, unless they asked for quiet. Throws as print().
void tell(std::string_view text);

/// Prints to standard output. Throws InputError when standard output cannot be written.
void print(std::string_view text);

/// Flushes standard output. Throws InputError when anything printed could not be written.
void finish_printing();

/// Writes a message to standard error, in place of a line that shows how far work is.
void say(std::string_view text);
/// Writes such a line in place of the one before, and leaves it open.
void say_in_place(std::string_view line);

}  // namespace occlude::render
