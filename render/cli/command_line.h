// SPDX-License-Identifier: MIT
// The interface with which commands declare their options. Only command_line.cpp includes CLI11, which takes seconds to
// compile.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command_text.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace occlude::cli {

/// Throws the error for an invalid value of an option.
[[noreturn]] void refuse(const std::string& option, const std::string& why);

/// Parses all of `text` as a number.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

/// An option, a flag or an argument of a command. Copies refer to the same option; the setters return it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  /// Shows the present value in the help.
  Option show_default();
  /// A number from `least` to `most`.
  Option in_range(std::size_t least, std::size_t most);
  Option in_range(double least, double most);
  Option not_negative();
  Option one_of(const std::vector<std::string>& words);
  /// `fault` returns what is wrong with a value, or an empty text.
  Option check(const std::function<std::string(const std::string&)>& fault);
  /// Calls `take` with every value.
  Option each(const std::function<void(std::string)>& take);
  /// One word may hold several values, separated by `delimiter`.
  Option split_at(char delimiter);
  /// Whether it is on the command line, once that is parsed.
  [[nodiscard]] bool is_given() const;
  [[nodiscard]] std::string name() const;
  Option needs(Option other);
  Option excludes(Option other);

 private:
  CLI::Option* option_;
};

/// A command, or a group of its options. Copies refer to the same command.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// Adds a subcommand. Here and below, `text` is a line of help.
  Command add_command(const std::string& name, const std::string& text);
  /// Adds a group of options of which exactly one must be given.
  Command add_alternatives(const std::string& name, const std::string& text);
  /// Adds a group of options of which at least one must be given.
  Command add_any_of(const std::string& name, const std::string& text);
  /// Adds an option, or without dashes an argument, that sets `value`: a std::string, a number, a std::optional of these,
  /// or a vector of strings.
  template <class T>
  Option add(const std::string& name, T& value, const std::string& text);
  Option add_flag(const std::string& name, bool& value, const std::string& text);
  /// The options that `add` adds stand under this heading in the help; others under "Options".
  void under(const std::string& heading, const std::function<void()>& add);
  /// Sets the end of the help.
  void footer(const std::string& text);
  /// Makes a subcommand mandatory.
  void require_command();
  /// Sets the work of the command, which runs once its options are parsed. Adds --quiet. Under mpirun the first rank does
  /// it.
  void run(const std::function<void()>& work);
  /// The same for work in which all ranks take part.
  void run_on_all_ranks(const std::function<void()>& work);

  /// The subcommand of this name. Throws render::InputError if there is none.
  [[nodiscard]] Command command(const std::string& name) const;
  /// The options and arguments that were given, with their values, a line each, but those of these names.
  [[nodiscard]] std::string given_but(const std::vector<std::string>& names) const;
  /// The text of --help.
  [[nodiscard]] std::string help() const;
  /// What this and its subcommands say of themselves.
  [[nodiscard]] CommandText describe() const;

 private:
  CLI::App* app_;
};

/// The name of the program, what its help says, and its version.
struct Program {
  std::string name, text, footer, version;
};

/// Reads the command line of the program, to which `declare` adds its commands, and runs the command that it names. Returns
/// the help or the version if the line asks for one of them. Throws render::InputError for a line that cannot be read.
[[nodiscard]] std::string run_program(const Program& program, int argc, char** argv,
                                      const std::function<void(Command)>& declare);

}  // namespace occlude::cli
