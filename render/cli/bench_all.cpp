// SPDX-License-Identifier: MIT
// occlude bench all
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "all_bench.h"
#include "command_arguments.h"
#include "commands.h"
#include "kernel_bench.h"
#include "occlude/render/city.h"
#include "occlude/render/console.h"
#include "proved_scene.h"
#include "report_files.h"
#include "subject_arguments.h"

namespace occlude::cli {
namespace {

struct BenchAllArguments {
  SubjectArguments subject{100'000};
  WalkArguments walk{"0:300:15"};
  std::string out;
  bool is_quick = false, json = false;
};

/// The sizes of all benchmarks. Each has more in its own command.
struct Sizes {
  bench::Options kernel;
  std::size_t city = 100'000;  ///< polygons, for the culler
  std::vector<std::string> experiments{experiments::kExperiments.begin(), experiments::kExperiments.end()};
  experiments::Options culler;
  experiments::SceneBenchOptions scene;
  experiments::TownBenchOptions town;
  experiments::VisibilityOptions visibility;
  experiments::HeldBenchOptions held;
};

/// They end in a few minutes.
Sizes sizes_of_minutes() {
  Sizes sizes;
  sizes.kernel.repetitions = 5;
  sizes.culler.walk.end = 60;
  sizes.culler.regions = 512;
  sizes.culler.repetitions = 1;
  sizes.culler.largest = 200'000;
  sizes.scene.world = {.objects = 200'000, .streamed = 100'000, .moving = 5'000, .moving_occluders = 50};
  sizes.scene.frames = 200;
  sizes.town.repetitions = 5;
  sizes.visibility.repetitions = 3;
  sizes.held.frames = 600;
  return sizes;
}

/// For a look at whether all of it works.
Sizes sizes_of_seconds() {
  Sizes sizes;
  sizes.kernel.boxes = 256;
  sizes.kernel.repetitions = 1;
  sizes.city = render::kSmallestCity;
  sizes.experiments = {"table2", "sort"};
  sizes.culler.walk.end = 2;
  sizes.culler.repetitions = 1;
  sizes.scene.world = {.objects = 10'000, .streamed = 5'000, .moving = 100, .moving_occluders = 10};
  sizes.scene.frames = sizes.scene.settling = sizes.scene.check_every = 4;
  sizes.town = {.houses = 1'000, .cars = 10, .walls = 900, .repetitions = 1, .frames = 4};
  sizes.visibility.repetitions = 1;
  sizes.held.frames = 4;
  return sizes;
}

experiments::Measured<experiments::Options, experiments::Result> measure_culler(const Sizes& sizes) {
  render::City city = render::generate_city(sizes.city, sizes.culler.seed);
  const experiments::Subject subject{"a generated city", std::move(city.soup), std::move(city.path)};
  return {sizes.culler, run(subject, sizes.culler, sizes.experiments)};
}

experiments::AllResult measure_all(const Sizes& sizes, const experiments::Subject& subject) {
  return {.kernel = measure_kernel(sizes.kernel),
          .culler = measure_culler(sizes),
          .scene = {sizes.scene, measure_scene(sizes.scene)},
          .town = {sizes.town, bench_town(sizes.town)},
          .visibility = {sizes.visibility, measure_visibility(subject, sizes.visibility)},
          .held = {sizes.held, bench_held(subject, sizes.held)}};
}

void bench_all(const BenchAllArguments& arguments, int& exit_code) {
  Sizes sizes = arguments.is_quick ? sizes_of_seconds() : sizes_of_minutes();
  sizes.culler.seed = arguments.subject.seed();
  sizes.visibility.walk = arguments.walk.options();
  sizes.visibility.walk.build.hierarchy.leaf_size = culler::leaf_size_for(culler::Method::cover);
  std::optional<ReportFiles> files;
  if (!arguments.out.empty()) files.emplace(arguments.out, "bench");
  const experiments::AllResult all = measure_all(sizes, arguments.subject.subject());
  if (!is_right(all.scene.result)) exit_code = kCheckFailed;
  if (files) files->commit(report_json(all), report_html(all));
  arguments.json ? render::print(report_json(all)) : render::tell(report_text(all));
  if (files && !arguments.json) render::tell(fmt::format("report: {}\n", files->path()));
}

}  // namespace

void add_bench_all(Command bench, int& exit_code) {
  Command command = bench.add_command("all", "All benchmarks in smaller sizes, in one report beside other projects");
  command.footer(
      "MODEL is for what is visible beside other projects and for culls that hold, the generated city without one. The "
      "paper's\n"
      "experiments run on a small city. Exit code 1 when a scene was culled wrongly.\n" +
      limits_help() +
      "\n"
      "Example: occlude bench all --out report");
  const auto a = std::make_shared<BenchAllArguments>();
  a->subject.add_to(command);
  a->walk.add_frames_to(command);
  a->walk.add_size_to(command);
  command.add_flag("--quick", a->is_quick, "sizes that end in seconds: their times say little");
  add_output(command, "--out", a->out, "folder to write bench.json and bench.html to");
  command.add_flag("--json", a->json, "print bench.json instead of tables");
  command.run([a, &exit_code] { bench_all(*a, exit_code); });
}

}  // namespace occlude::cli
