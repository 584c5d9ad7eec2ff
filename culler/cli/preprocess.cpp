// SPDX-License-Identifier: MIT
// occlude preprocess: finds out once what every walk through a model can use.
#include "occlude/culler/preprocess.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_file.h"
#include "occlude/render/preprocess_file.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

struct Arguments {
  std::string model, out, pattern = "even", seed = "1";
  BuildArguments build;
  culler::OccluderLists::Config lists;
  culler::SampleConfig samples;
  bool json = false;
};

void preprocess(Arguments& arguments) {
  culler::BuildConfig config = arguments.build.config();
  arguments.lists.kind = config.lists.kind;
  config.lists = arguments.lists;
  arguments.samples.seed = whole_number("--seed", arguments.seed);
  arguments.samples.pattern =
      arguments.pattern == "random" ? culler::SampleConfig::Pattern::random : culler::SampleConfig::Pattern::even;
  render::OutputFile file(arguments.out);
  const culler::PolygonSoup soup = render::read_model(arguments.model);
  const auto start = std::chrono::steady_clock::now();
  const culler::Preprocess result = [&] {
    render::Watch watch("region");
    return culler::preprocess(soup, config, arguments.samples, std::ref(watch), render::check_interrupt);
  }();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  render::check_interrupt();
  render::write_preprocess(file, soup, result);
  render::check_interrupt();
  file.commit();
  const culler::OccluderLists::Stored& lists = result.lists;
  const auto hide = std::ranges::count_if(lists.hidden, [](float hidden) { return hidden > 0; });
  if (arguments.json) {
    const nlohmann::ordered_json summary{
        {"polygons", soup.size()},
        {"nodes", result.layout.left.size()},
        {"regions", lists.first.size() - 1},
        {"listed", lists.occluders.size()},
        {"found_to_hide", lists.hidden.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(hide)},
        {"bytes", std::filesystem::file_size(arguments.out)},
        {"seconds", seconds}};
    render::print(summary.dump(2) + "\n");
    return;
  }
  const std::string sampled = lists.hidden.empty() ? "" : fmt::format(", {} of them found to hide something", hide);
  render::tell(fmt::format("{}: {} polygons, {} nodes; {} regions list {} occluders{}; {:.1f} s\n", arguments.out,
                           soup.size(), result.layout.left.size(), lists.first.size() - 1, lists.occluders.size(), sampled,
                           seconds));
}

}  // namespace

void add_preprocess(Command app, int&) {
  Command command = app.add_command("preprocess", "Find out once about a model what every walk can use");
  command.footer(
      "Stores the order of the tree, the occluders that each region of space lists, and what they hide as sampled there, "
      "for\n"
      "walk and validate with --preprocess. Nothing in it can make a cull wrong.\n" +
      limits_help() +
      "\n"
      "Example: occlude preprocess city.ply --out city.pre");
  const auto a = std::make_shared<Arguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  add_output(command, "--out", a->out, "file to write").required();
  a->build.add_to(command);
  command.add("--region-count", a->lists.regions, "number of regions aimed at; of a tree the most")
      .show_default()
      .in_range(1.0, 1e7);
  command.add("--threshold", a->lists.threshold, "steradians above which a region lists an occluder")
      .show_default()
      .in_range(1e-6, 10.0);
  command
      .add("--entries", a->lists.entries,
           "most entries of all lists together; where there would be more, the longest keep what looks largest")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1} << 30U);
  command.add("--samples", a->samples.viewpoints, "viewpoints sampled in each region: minutes for a large model")
      .show_default()
      .in_range(std::size_t{0}, std::size_t{1000});
  command.add("--pattern", a->pattern, "how viewpoints are spread").show_default().one_of({"even", "random"});
  command.add("--seed", a->seed, "whole number; same seed, same viewpoints, on any machine").show_default();
  command.add_flag("--json", a->json, "print the counts as JSON");
  command.run([a] { preprocess(*a); });
}

}  // namespace occlude::cli
