// SPDX-License-Identifier: MIT
// occlude help
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "completion.h"
#include "man_page.h"
#include "occlude/render/console.h"

namespace occlude::cli {
namespace {

struct HelpArguments {
  std::vector<std::string> words;
  std::string shell;
  bool man = false;
};

std::string help(const Command& app, const HelpArguments& arguments) {
  if (arguments.man) return man_page(app.describe());
  if (!arguments.shell.empty()) return bash_completion(app.describe());
  Command command = app;
  for (const std::string& word : arguments.words) command = command.command(word);
  return command.help();
}

}  // namespace

void add_help(Command app, int&) {
  Command command = app.add_command("help", "Tell about a command");
  command.footer(
      "Example: occlude help walk\n"
      "Example: occlude help --man | man -l -\n"
      "Example: source <(occlude help --completion bash)");
  const auto a = std::make_shared<HelpArguments>();
  Option words = command.add("COMMAND", a->words, "the command, such as walk or bench kernel");
  Option man = command.add_flag("--man", a->man, "print the manual page of all commands").excludes(words);
  command.add("--completion", a->shell, "print a script that completes words in this shell")
      .one_of({"bash"})
      .excludes(words)
      .excludes(man);
  command.run([app, a] { render::print(help(app, *a)); });
}

}  // namespace occlude::cli
