// SPDX-License-Identifier: MIT
// occlude bench town
#include <memory>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "town_bench.h"

namespace occlude::cli {
namespace {

struct BenchTownArguments {
  experiments::TownBenchOptions options;
  bool json = false;
};

void bench_town(const BenchTownArguments& arguments) {
  const experiments::TownBenchOptions& options = arguments.options;
  if (options.walls > options.houses) refuse("--walls", "more than --houses");
  const experiments::TownBenchResult result = experiments::bench_town(options);
  arguments.json ? render::print(json_of(result, options)) : render::tell(text_of(table_of(result, options)));
}

}  // namespace

void add_bench_town(Command bench) {
  Command command = bench.add_command("town", "A town that stands: time to prepare it, its memory, what is drawn");
  command.footer(
      "Terraces of houses along streets, with a rectangle that hides in each, cars that drive, and a camera that walks\n"
      "and turns.\n"
      "Example: occlude bench town\n"
      "Example: occlude bench town --houses 100000 --walls 100000 --json");
  const auto a = std::make_shared<BenchTownArguments>();
  experiments::TownBenchOptions& options = a->options;
  constexpr std::size_t kMost = 10'000'000;
  command.add("--houses", options.houses, "objects that stand").show_default().in_range(std::size_t{1}, kMost);
  command.add("--cars", options.cars, "objects that move").show_default().in_range(std::size_t{0}, kMost);
  command.add("--walls", options.walls, "houses with a rectangle that hides").show_default().in_range(std::size_t{0}, kMost);
  command.add("--repetitions", options.repetitions, "times that the town is made")
      .show_default()
      .in_range(std::size_t{1}, kMost);
  command.add("--frames", options.frames, "frames that are measured").show_default().in_range(std::size_t{1}, kMost);
  command.add_flag("--json", a->json, "print everything measured as JSON");
  command.run([a] { bench_town(*a); });
}

}  // namespace occlude::cli
