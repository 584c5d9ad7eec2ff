// SPDX-License-Identifier: MIT
// occlude bench culler
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "command_arguments.h"
#include "commands.h"
#include "experiments.h"
#include "occlude/render/city.h"
#include "occlude/render/console.h"
#include "report_files.h"
#include "subject_arguments.h"

namespace occlude::cli {
namespace {

struct BenchCullerArguments {
  SubjectArguments subject{500'000};
  std::string out, largest = "1e6";
  WalkArguments walk{"0:300", "640x360", culler::Method::frusta};
  std::vector<std::string> only;
  experiments::Options options;
  bool no_render = false, json = false;
};

/// The chosen experiments; by default all, without `growth` for a given model.
std::vector<std::string> chosen(const BenchCullerArguments& arguments) {
  if (!arguments.only.empty()) return arguments.only;
  std::vector<std::string> all(experiments::kExperiments.begin(), experiments::kExperiments.end());
  if (!arguments.subject.is_city()) std::erase(all, "growth");
  return all;
}

void bench_culler(BenchCullerArguments& arguments) {
  experiments::Options& options = arguments.options;
  options.walk = arguments.walk.options();
  options.walk.render = !arguments.no_render;
  options.seed = arguments.subject.seed();
  options.largest = whole_number("--largest", arguments.largest);
  if (options.largest < render::kSmallestCity || options.largest > render::kLargestCity) {
    refuse("--largest", "expected 20000 to 5e7 polygons");
  }
  std::optional<ReportFiles> files;
  if (!arguments.out.empty()) files.emplace(arguments.out, "culler");
  const experiments::Result result = run(arguments.subject.subject(), options, chosen(arguments));
  if (files) files->commit(report_json(result, options), report_html(result, options));
  arguments.json ? render::print(report_json(result, options)) : render::tell(report_text(result, options));
  if (files && !arguments.json) render::tell(fmt::format("report: {}\n", files->path()));
}

}  // namespace

void add_bench_culler(Command bench, int&) {
  Command command = bench.add_command("culler", "The paper's experiments: table 2, figures 2 to 4, and open questions");
  command.footer("Without MODEL the experiments run on a generated city.\n" + limits_help() +
                 "\n"
                 "Example: occlude bench culler --out report\n"
                 "Example: occlude bench culler sponza.ply --path sponza.json --only table2,figure4 --no-render");
  const auto a = std::make_shared<BenchCullerArguments>();
  a->subject.add_to(command);
  command
      .add("--only", a->only,
           "experiments, separated by commas: table2, figure4, sweeps, sort, joined, occluders, threads, growth (default: "
           "all; with a MODEL all except growth, which needs cities)")
      .split_at(',')
      .one_of(std::vector<std::string>(experiments::kExperiments.begin(), experiments::kExperiments.end()));
  a->walk.add_size_to(command);
  a->walk.add_culling_to(command);
  command.add("--region-count", a->options.regions, "number of regions in figure 4; each takes time to sample")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1} << 24U);
  command.add("--samples", a->options.samples, "viewpoints per region for depth complexity; 0 leaves its curves out")
      .show_default()
      .in_range(std::size_t{0}, std::size_t{1000});
  command.add("--repetitions", a->options.repetitions, "rounds; each measures everything once")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1000});
  command.add("--largest", a->largest, "polygons of the largest city of growth, up to 5e7").show_default();
  command.add_flag("--no-render", a->no_render, "draw nothing: table 2 has no frame times");
  add_output(command, "--out", a->out, "folder to write culler.json and culler.html to");
  command.add_flag("--json", a->json, "print culler.json instead of tables");
  command.run([a] { bench_culler(*a); });
}

}  // namespace occlude::cli
