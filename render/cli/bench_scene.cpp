// SPDX-License-Identifier: MIT
// occlude bench scene
#include <memory>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "proved_scene.h"

namespace occlude::cli {
namespace {

struct BenchSceneArguments {
  experiments::SceneBenchOptions options;
  std::string seed = "1";
  bool json = false;
};

void bench_scene(BenchSceneArguments& arguments, int& exit_code) {
  experiments::SceneBenchOptions& options = arguments.options;
  const experiments::WorldSize& world = options.world;
  options.seed = whole_number("--seed", arguments.seed);
  if (world.streamed + world.moving > world.objects) refuse("--objects", "fewer than --streamed and --moving together");
  if (world.moving_occluders > world.moving) refuse("--moving-occluders", "more than --moving");
  const experiments::SceneBenchResult result = measure_scene(options);
  if (!is_right(result)) exit_code = kCheckFailed;
  arguments.json ? render::print(json_of(result, options)) : render::tell(text_of(table_of(result, options)));
}

}  // namespace

void add_bench_scene(Command bench, int& exit_code) {
  Command command = bench.add_command("scene", "A world of objects that changes: tiles that stream, traffic, two views");
  command.footer(
      "In a town of buildings, tiles of small things come and go around a camera that flies, and traffic drives. Every\n"
      "--check-every frames the culls are compared with those of a scene made anew, and some are proved by the exact "
      "oracle;\n"
      "exit code 1 when one is wrong.\n"
      "The same frames are culled by the view frustum alone as well: a budget does not bound what that takes.\n"
      "Example: occlude bench scene\n"
      "Example: occlude bench scene --budget-ms 0.5\n"
      "Example: occlude bench scene --objects 100000 --streamed 20000 --moving 1000 --frames 100 --json");
  const auto a = std::make_shared<BenchSceneArguments>();
  experiments::SceneBenchOptions& options = a->options;
  constexpr std::size_t kMost = 20'000'000;
  command.add("--objects", options.world.objects, "objects in all").show_default().in_range(std::size_t{1000}, kMost);
  command.add("--streamed", options.world.streamed, "of these, in tiles of 1,000 that come and go")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  command.add("--moving", options.world.moving, "of these, those that move").show_default().in_range(std::size_t{0}, kMost);
  command.add("--moving-occluders", options.world.moving_occluders, "of the moving ones, those that hide")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  command.add("--frames", options.frames, "frames that are measured").show_default().in_range(std::size_t{1}, kMost);
  command.add("--settling", options.settling, "frames before these").show_default().in_range(std::size_t{0}, kMost);
  command.add("--check-every", options.check_every, "frames between checks; 0: none")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  add_budgets(command, options.cover);
  command.add("--seed", a->seed, "whole number; the same seed gives the same world").show_default();
  command.add_flag("--json", a->json, "print everything measured as JSON");
  command.run([a, &exit_code] { bench_scene(*a, exit_code); });
}

}  // namespace occlude::cli
