// SPDX-License-Identifier: MIT
// occlude compare
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/comparison_report.h"
#include "occlude/render/console.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/output_file.h"
#include "occlude/render/walk_comparison.h"

namespace occlude::cli {
namespace {

struct CompareArguments {
  std::string a, b, out;
  bool fail_if_worse = false, json = false;
};

void compare(const CompareArguments& arguments, int& exit_code) {
  const render::WalkReading a = render::read_walk(arguments.a), b = render::read_walk(arguments.b);
  std::optional<render::OutputFile> page;
  if (!arguments.out.empty()) page.emplace(arguments.out);
  const render::WalkComparison comparison = render::compare_walks(a, b);
  if (arguments.fail_if_worse && !comparison.worse().empty()) exit_code = kCheckFailed;
  if (page) {
    page->write(comparison_page(comparison));
    const render::Uninterrupted naming;
    page->commit();
  }
  arguments.json ? render::print(json_of(comparison).dump(2) + '\n')
                 : render::tell(text_of(comparison, render::Paint(STDOUT_FILENO)));
}

}  // namespace

void add_compare(Command app, int& exit_code) {
  Command command = app.add_command("compare", "Set the results of two walks side by side, and mark what got worse");
  command.footer(
      "A and B are folders that occlude walk wrote, or summary.json of them. With folders, the table has the ratio B/A "
      "frame\n"
      "by frame as well, over the frames that both have: its median, and the 5th and 95th percentile.\n"
      "Counts are worse if they changed by a thousandth, wrong pixels and false culls if there are more of them. Times are\n"
      "worse if the median of their ratios is 5 % worse and, with 95 % confidence, no chance; from summaries alone, and "
      "where\n"
      "the view frustum alone took a tenth longer in one of them, they are not judged.\n"
      "Exit code: 0; 1 with --fail-if-worse if something got worse; 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude compare report_before report_after --out comparison.html");
  const auto a = std::make_shared<CompareArguments>();
  add_input(command, "A", a->a, "folder or summary.json of the first walk").required();
  add_input(command, "B", a->b, "folder or summary.json of the second walk").required();
  add_output(command, "--out", a->out, "write a page with the table, plates and the curves of both to this file (HTML)");
  command.add_flag("--fail-if-worse", a->fail_if_worse, "exit with 1 if something got worse");
  command.add_flag("--json", a->json, "print JSON instead of the table");
  command.run([a, &exit_code] { compare(*a, exit_code); });
}

}  // namespace occlude::cli
