// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "nearest.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/ranks.h"

namespace occlude::cli {
namespace {

/// With the names of the commands above it.
std::string full_name(const CLI::App& app) {
  return (app.get_parent() ? full_name(*app.get_parent()) + " " : "") + app.get_name();
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_name().empty()) names.push_back(command->get_name());
  }
  return names;
}

/// "aabb" and "obb" of the kind "TEXT:{aabb,obb}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string kind = option.get_type_name();
  const std::size_t open = kind.find('{'), close = kind.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(kind.substr(open + 1, close - open - 1), ',');
}

OptionText describe(const CLI::App& app, const CLI::Option& option) {
  const auto* const formatter = dynamic_cast<const CLI::Formatter*>(app.get_formatter().get());
  OptionText text;
  text.is_argument = option.get_positional();
  text.takes_value = option.get_type_size() != 0;
  if (text.is_argument) text.names = {option.get_name(true)};
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  text.value = formatter->make_option_opts(&option);
  text.choices = choices_of(option);
  text.text = option.get_description();
  text.group = text.is_argument ? "Arguments" : option.get_group();
  return text;
}

/// The options of the command and of its groups of alternatives.
std::vector<const CLI::Option*> all_options_of(const CLI::App& app) {
  std::vector<const CLI::Option*> options = app.get_options();
  for (const CLI::App* group : app.get_subcommands([](const CLI::App* part) { return part->get_name().empty(); })) {
    for (const CLI::Option* option : all_options_of(*group)) options.push_back(option);
  }
  return options;
}

/// The same in words, arguments first.
std::vector<OptionText> options_of(const CLI::App& app) {
  std::vector<OptionText> options;
  for (const CLI::Option* option : all_options_of(app)) options.push_back(describe(app, *option));
  std::stable_partition(options.begin(), options.end(), [](const OptionText& option) { return option.is_argument; });
  return options;
}

CommandText describe(const CLI::App& app) {
  CommandText text{full_name(app), app.get_description(), app.get_footer(), options_of(app), {}};
  for (const std::string& name : commands_of(app)) text.commands.push_back(describe(*app.get_subcommand(name)));
  return text;
}

/// The last command that the line names.
const CLI::App& named(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : named(*commands.back());
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  return "unknown command '" + word + "'" + did_you_mean(word, commands_of(app));
}

/// What is wrong with a word that no command takes; none if there is no such word.
std::optional<std::string> unknown_word(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) return app.get_subcommands().empty() ? std::nullopt : unknown_word(*app.get_subcommands().back());
  const std::string word = words.front().substr(0, words.front().find('='));
  if (!word.starts_with('-')) {
    return commands_of(app).empty() ? "'" + word + "' is one argument too many" : unknown_command(app, word);
  }
  std::vector<std::string> names;
  for (const OptionText& option : options_of(app)) {
    if (!option.is_argument) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return "unknown option '" + word + "'" + did_you_mean(word, names);
}

}  // namespace

void refuse(const std::string& option, const std::string& why) { throw CLI::ValidationError(option, why); }

std::optional<double> parse_number(const std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
}

Option Option::required() { return Option(*option_->required()); }
Option Option::show_default() { return Option(*option_->capture_default_str()); }
Option Option::in_range(std::size_t least, std::size_t most) { return Option(*option_->check(CLI::Range(least, most))); }

Option Option::in_range(double least, double most) {
  const auto fault = [=](const std::string& text) -> std::string {  // CLI::Range lets "nan" pass, and shows 1e-9 as 0
    const std::optional<double> value = parse_number(text);
    if (!value || !std::isfinite(*value)) return "'" + text + "' is not a number";
    return *value < least || *value > most ? fmt::format("{} is not in the range from {} to {}", text, least, most) : "";
  };
  return Option(*option_->check(CLI::Validator(fault, "") & CLI::Range(least, most)));
}

Option Option::not_negative() { return Option(*option_->check(CLI::NonNegativeNumber)); }
Option Option::one_of(const std::vector<std::string>& words) { return Option(*option_->check(CLI::IsMember(words))); }
Option Option::check(const std::function<std::string(const std::string&)>& fault) { return Option(*option_->check(fault)); }
Option Option::each(const std::function<void(std::string)>& take) { return Option(*option_->each(take)); }
Option Option::split_at(char delimiter) { return Option(*option_->delimiter(delimiter)); }
bool Option::is_given() const { return option_->count() > 0; }
std::string Option::name() const { return option_->get_name(); }
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

void Command::under(const std::string& heading, const std::function<void()>& add) {
  const std::string before = app_->option_defaults()->get_group();
  app_->option_defaults()->group(heading);
  add();
  app_->option_defaults()->group(before);
}
void Command::footer(const std::string& text) { app_->footer(text); }
void Command::require_command() { app_->require_subcommand(1); }

void Command::run(const std::function<void()>& work) {
  run_on_all_ranks([work] {
    if (render::is_first_rank()) work();
  });
}

void Command::run_on_all_ranks(const std::function<void()>& work) {
  app_->add_flag_callback("--quiet", render::be_quiet, "print nothing but errors, warnings and what --json asks for");
  app_->callback(work);
}

Command Command::command(const std::string& name) const {
  const std::vector<std::string> names = commands_of(*app_);
  if (std::ranges::find(names, name) == names.end()) throw render::InputError(unknown_command(*app_, name));
  return Command(*app_->get_subcommand(name));
}

std::string Command::given_but(const std::vector<std::string>& names) const {
  std::string text;
  for (const CLI::Option* option : all_options_of(*app_)) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::ranges::find(names, name) != names.end()) continue;
    text += name;
    for (const std::string& value : option->results()) text += "=" + value;
    text += "\n";
  }
  return text;
}

std::string Command::help() const {
  return app_->get_formatter()->make_help(app_, full_name(*app_), CLI::AppFormatMode::Normal);
}

CommandText Command::describe() const { return cli::describe(*app_); }

std::string run_program(const Program& program, int argc, char** argv, const std::function<void(Command)>& declare) {
  CLI::App app(program.text, program.name);
  app.require_subcommand(0, 1);  // a missing command is reported below, after an unknown word
  app.footer(program.footer);
  app.set_version_flag("--version", program.version);
  declare(Command(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::optional<std::string> fault = unknown_word(app);
    if (fault || error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
      throw render::InputError(fault.value_or(error.what()) + " (see " + full_name(named(app)) + " --help)");
    }
    std::ostringstream text;
    app.exit(error, text, text);
    return text.str();
  }
  if (app.get_subcommands().empty()) throw render::InputError("which command? (see " + program.name + " --help)");
  return "";
}

}  // namespace occlude::cli
