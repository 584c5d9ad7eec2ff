// SPDX-License-Identifier: MIT
// The command line as the commands declare it. CLI11 is behind it and in command_line.cpp alone: every file that includes
// it takes some seconds more to compile.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace occlude::cli {

/// Throws the error that an option was given what it does not take.
[[noreturn]] void refuse(const std::string& option, const std::string& why);

/// The number that is all of `text`.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

/// An option, a flag or an argument of a command; a copy is the same one. What changes it returns it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  /// The help shows the value that it has now.
  Option show_default();
  /// A number from `least` to `most`.
  Option in_range(std::size_t least, std::size_t most);
  Option in_range(double least, double most);
  Option not_negative();
  Option one_of(const std::vector<std::string>& words);
  /// `fault` tells what is wrong with a value: nothing when it returns an empty text.
  Option check(const std::function<std::string(const std::string&)>& fault);
  /// `take` is told every value.
  Option each(const std::function<void(std::string)>& take);
  /// Several values may stand in one word, `delimiter` between them.
  Option split_at(char delimiter);
  Option needs(Option other);
  Option excludes(Option other);

 private:
  CLI::Option* option_;
};

/// A command, or a group of its options; a copy is the same one.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// A subcommand. `text` is a line of help, as everywhere below.
  Command add_command(const std::string& name, const std::string& text);
  /// Options of which exactly one must be given.
  Command add_alternatives(const std::string& name, const std::string& text);
  /// An option, or without dashes an argument, that sets `value`: a std::string, a number, a std::optional of these, or
  /// a vector of texts.
  template <class T>
  Option add(const std::string& name, T& value, const std::string& text);
  Option add_flag(const std::string& name, bool& value, const std::string& text);
  /// The help ends with it.
  void footer(const std::string& text);
  /// One of its subcommands must be given.
  void require_command();
  /// What it does once its options are read.
  void run(const std::function<void()>& work);

 private:
  CLI::App* app_;
};

/// What the help of the whole program tells, and its version.
struct Program {
  std::string name, text, footer, version;
};

/// Reads the command line of the program, to which `declare` adds its commands, and runs the command that it names. Returns
/// the help or the version where that was asked for instead. Throws render::InputError for a line that cannot be read.
[[nodiscard]] std::string run_program(const Program& program, int argc, char** argv,
                                      const std::function<void(Command)>& declare);

}  // namespace occlude::cli
