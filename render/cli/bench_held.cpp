// SPDX-License-Identifier: MIT
// occlude bench held
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "held_bench.h"
#include "occlude/render/console.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/output_file.h"
#include "occlude/render/progress.h"
#include "subject_arguments.h"

namespace occlude::cli {
namespace {

struct BenchHeldArguments {
  SubjectArguments subject{500'000};
  experiments::HeldBenchOptions options;
  std::vector<std::string> speeds;
  std::string chart;
  bool json = false;
};

/// Numbers above 0 that ascend; calls refuse() for anything else.
std::vector<double> speeds_of(const std::vector<std::string>& texts) {
  constexpr double kFastest = 1e9;
  std::vector<double> speeds;
  for (const std::string& text : texts) {
    const std::optional<double> speed = parse_number(text);
    if (!speed || !(*speed > (speeds.empty() ? 0 : speeds.back())) || *speed > kFastest) {
      refuse("--speeds", "'" + text + "': expected numbers above 0 that ascend, as 1.5,5,15");
    }
    speeds.push_back(*speed);
  }
  return speeds;
}

void bench_held(const BenchHeldArguments& arguments) {
  experiments::HeldBenchOptions options = arguments.options;
  options.speeds = speeds_of(arguments.speeds);
  std::optional<render::OutputFile> chart;
  if (!arguments.chart.empty()) chart.emplace(arguments.chart);
  std::optional<render::ShownStage> stage("moving");
  const experiments::HeldBenchResult result = experiments::bench_held(arguments.subject.subject(), options);
  stage.reset();
  if (chart) {
    chart->write(chart_of(result, options));
    chart->close();
    const render::Uninterrupted naming;
    chart->commit();
  }
  arguments.json ? render::print(json_of(result, options)) : render::tell(text_of(table_of(result, options)));
}

}  // namespace

void add_bench_held(Command bench) {
  Command command = bench.add_command("held", "Culls that hold for many frames: walking, driving, turning, jumping");
  command.footer(
      "Without MODEL it is a generated city. The camera moves along the path at 1.5 and 15 model units a second, turns in\n"
      "the middle of it by 180 degrees a second, and walks on from elsewhere every second. The time of the thread that\n"
      "culls beside is counted.\n"
      "Example: occlude bench held\n"
      "Example: occlude bench held sponza.ply --path sponza.json --frames 600 --json\n"
      "Example: occlude bench held sponza.ply --path sponza.json --speeds 1.5,5,15 --chart held.svg");
  const auto a = std::make_shared<BenchHeldArguments>();
  experiments::HeldBenchOptions& options = a->options;
  a->subject.add_to(command);
  constexpr std::size_t kMost = 10'000'000;
  command.add("--frames", options.frames, "frames of each way to move").show_default().in_range(std::size_t{1}, kMost);
  command.add("--compare-every", options.compare_every, "frames between those that are also culled by point")
      .show_default()
      .in_range(std::size_t{1}, kMost);
  command.add("--leaf", options.leaf, "most polygons in a leaf of the tree; whole leaves are drawn or left out")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{4096});
  const Option speeds = command
                            .add("--speeds", a->speeds,
                                 "walk along the path at these speeds instead, in model units a second, separated by commas")
                            .split_at(',');
  add_output(command, "--chart", a->chart, "draw milliseconds a frame over the speeds into this SVG file", ".svg")
      .needs(speeds);
  command.add_flag("--json", a->json, "print everything measured as JSON");
  command.run([a] { bench_held(*a); });
}

}  // namespace occlude::cli
