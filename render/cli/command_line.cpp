// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "occlude/render/errors.h"

namespace occlude::cli {

void refuse(const std::string& option, const std::string& why) { throw CLI::ValidationError(option, why); }

std::optional<double> parse_number(const std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
}

Option Option::required() { return Option(*option_->required()); }
Option Option::show_default() { return Option(*option_->capture_default_str()); }
Option Option::in_range(std::size_t least, std::size_t most) { return Option(*option_->check(CLI::Range(least, most))); }

Option Option::in_range(double least, double most) {
  const auto is_number = [](const std::string& text) {  // CLI::Range alone lets "nan" pass
    const std::optional<double> value = parse_number(text);
    return value && std::isfinite(*value) ? "" : "'" + text + "' is not a number";
  };
  return Option(*option_->check(CLI::Validator(is_number, "") & CLI::Range(least, most)));
}

Option Option::not_negative() { return Option(*option_->check(CLI::NonNegativeNumber)); }
Option Option::one_of(const std::vector<std::string>& words) { return Option(*option_->check(CLI::IsMember(words))); }
Option Option::check(const std::function<std::string(const std::string&)>& fault) { return Option(*option_->check(fault)); }
Option Option::each(const std::function<void(std::string)>& take) { return Option(*option_->each(take)); }
Option Option::split_at(char delimiter) { return Option(*option_->delimiter(delimiter)); }
Option Option::needs(Option other) { return Option(*option_->needs(other.option_)); }
Option Option::excludes(Option other) { return Option(*option_->excludes(other.option_)); }

Command Command::add_command(const std::string& name, const std::string& text) {
  return Command(*app_->add_subcommand(name, text));
}

Command Command::add_alternatives(const std::string& name, const std::string& text) {
  CLI::Option_group* const group = app_->add_option_group(name, text);
  group->require_option(1);
  return Command(*group);
}

Command Command::add_any_of(const std::string& name, const std::string& text) {
  CLI::Option_group* const group = app_->add_option_group(name, text);
  group->require_option(1, 0);  // 0: no most
  return Command(*group);
}

template <class T>
Option Command::add(const std::string& name, T& value, const std::string& text) {
  return Option(*app_->add_option(name, value, text));
}
template Option Command::add(const std::string&, std::string&, const std::string&);
template Option Command::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::add(const std::string&, std::optional<std::string>&, const std::string&);
template Option Command::add(const std::string&, std::uint32_t&, const std::string&);
template Option Command::add(const std::string&, std::optional<std::uint32_t>&, const std::string&);
template Option Command::add(const std::string&, std::size_t&, const std::string&);
template Option Command::add(const std::string&, double&, const std::string&);

Option Command::add_flag(const std::string& name, bool& value, const std::string& text) {
  return Option(*app_->add_flag(name, value, text));
}

void Command::footer(const std::string& text) { app_->footer(text); }
void Command::require_command() { app_->require_subcommand(1); }
void Command::run(const std::function<void()>& work) { app_->callback(work); }

std::string run_program(const Program& program, int argc, char** argv, const std::function<void(Command)>& declare) {
  CLI::App app(program.text, program.name);
  app.require_subcommand(0, 1);  // a missing command is reported below, after an unknown word
  app.footer(program.footer);
  app.set_version_flag("--version", program.version);
  declare(Command(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
      throw render::InputError(std::string(error.what()) + " (see " + program.name + " --help)");
    }
    std::ostringstream text;
    app.exit(error, text, text);
    return text.str();
  }
  if (app.get_subcommands().empty()) throw render::InputError("which command? (see " + program.name + " --help)");
  return "";
}

}  // namespace occlude::cli
