// SPDX-License-Identifier: MIT
// What the commands say of themselves, as data from which the man page and the completion of words are written.
#pragma once

#include <string>
#include <vector>

namespace occlude::cli {

struct OptionText {
  std::vector<std::string> names;  ///< with dashes; of an argument its name alone
  bool is_argument = false, takes_value = false;
  std::string value;                 ///< what the help shows after the name: kind, default, whether it is required
  std::vector<std::string> choices;  ///< if only these values are taken
  std::string text, group;
};

struct CommandText {
  std::string name;  ///< with those of the commands above it
  std::string text, footer;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;
};

}  // namespace occlude::cli
