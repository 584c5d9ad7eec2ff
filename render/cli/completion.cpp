// SPDX-License-Identifier: MIT
#include "completion.h"

#include <fmt/format.h>

#include <iterator>

namespace occlude::cli {
namespace {

/// What a script has a `case` for.
struct Cases {
  std::string commands;  ///< which words are commands
  std::string words;     ///< what may follow a command
  std::string values;    ///< what may follow an option
};

void add(Cases& cases, const CommandText& command) {
  std::string words;
  for (const CommandText& part : command.commands) words += part.name.substr(command.name.size() + 1) + ' ';
  for (const OptionText& option : command.options) {
    if (option.is_argument) continue;
    for (const std::string& name : option.names) {
      words += name + ' ';
      if (!option.takes_value) continue;
      fmt::format_to(std::back_inserter(cases.values), "    '{} {}') words='{}' ;;\n", command.name, name,
                     fmt::join(option.choices, " "));
    }
  }
  fmt::format_to(std::back_inserter(cases.words), "    '{}') words='{}' ;;\n", command.name, words);
  for (const CommandText& part : command.commands) {
    fmt::format_to(std::back_inserter(cases.commands), "{}'{}'", cases.commands.empty() ? "" : " | ", part.name);
    add(cases, part);
  }
}

}  // namespace

std::string bash_completion(const CommandText& program) {
  Cases cases;
  add(cases, program);
  return fmt::format(
      R"(# Completion of the command {0} in bash.
_{0}() {{
  local command={0} word words=
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$command $word" in
    {1}) command+=" $word" ;;
    esac
  done
  case "$command" in
{2}  esac
  case "$command $3" in
{3}  esac
  COMPREPLY=($(compgen -W "$words" -- "$2"))
}}
complete -o default -F _{0} {0}
)",
      program.name, cases.commands, cases.words, cases.values);
}

}  // namespace occlude::cli
