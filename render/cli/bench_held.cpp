// SPDX-License-Identifier: MIT
// occlude bench held
#include <memory>

#include "command_arguments.h"
#include "commands.h"
#include "held_bench.h"
#include "occlude/render/console.h"
#include "subject_arguments.h"

namespace occlude::cli {
namespace {

struct BenchHeldArguments {
  SubjectArguments subject{500'000};
  experiments::HeldBenchOptions options;
  bool json = false;
};

void bench_held(const BenchHeldArguments& arguments) {
  const experiments::HeldBenchResult result = experiments::bench_held(arguments.subject.subject(), arguments.options);
  arguments.json ? render::print(json_of(result, arguments.options))
                 : render::tell(text_of(table_of(result, arguments.options)));
}

}  // namespace

void add_bench_held(Command bench) {
  Command command = bench.add_command("held", "Culls that hold for many frames: walking, driving, turning, jumping");
  command.footer(
      "Without MODEL it is a generated city. The camera moves along the path at 1.5 and 15 model units a second, turns in\n"
      "the middle of it by 180 degrees a second, and walks on from elsewhere every second. The time of the thread that\n"
      "culls beside is counted.\n"
      "Example: occlude bench held\n"
      "Example: occlude bench held sponza.ply --path sponza.json --frames 600 --json");
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
  command.add_flag("--json", a->json, "print everything measured as JSON");
  command.run([a] { bench_held(*a); });
}

}  // namespace occlude::cli
