// SPDX-License-Identifier: MIT
// occlude bench rivals
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/page.h"
#include "occlude/render/table.h"
#include "report_files.h"
#include "subject_arguments.h"
#include "visibility.h"

namespace occlude::cli {
namespace {

struct BenchRivalsArguments {
  SubjectArguments subject{500'000};
  WalkArguments walk{"0:300:15"};
  std::uint32_t leaf = culler::leaf_size_for(culler::Method::cover);
  std::vector<std::string> rays{"160x90", "640x360"};
  std::string out;
  experiments::VisibilityOptions options;
  bool json = false;
};

void bench_rivals(BenchRivalsArguments& arguments) {
  experiments::VisibilityOptions& options = arguments.options;
  options.walk = arguments.walk.options();
  options.walk.build.hierarchy.leaf_size = arguments.leaf;
  options.pictures.clear();
  for (const std::string& text : arguments.rays) {
    const PictureSize size = parse_size("--rays", text, 1, kLargestSide);
    options.pictures.push_back({size.width, size.height});
  }
  std::optional<ReportFiles> files;
  if (!arguments.out.empty()) files.emplace(arguments.out, "rivals");
  const experiments::VisibilityResult result = measure_visibility(arguments.subject.subject(), options);
  const render::Table table = table_of(result, options);
  if (files) {
    files->commit(json_of(result, options),
                  render::page("occlude: what is visible", "<h1>Beside other projects</h1>" + section(table)));
  }
  arguments.json ? render::print(json_of(result, options)) : render::tell(text_of(table));
  if (files && !arguments.json) render::tell(fmt::format("report: {}\n", files->path()));
}

}  // namespace

void add_bench_rivals(Command bench) {
  Command command = bench.add_command("rivals", "What is visible, beside Embree (rays) and OpenSceneGraph (occluder nodes)");
  command.footer(
      "Without MODEL it is a generated city. Other projects are measured where they were installed when occlude was\n"
      "built (Debian: libembree-dev, libopenscenegraph-dev).\n" +
      limits_help() +
      "\n"
      "Example: occlude bench rivals\n"
      "Example: occlude bench rivals sponza.ply --path sponza.json --frames 0:240:15 --out report");
  const auto a = std::make_shared<BenchRivalsArguments>();
  a->subject.add_to(command);
  a->walk.add_size_to(command);
  a->walk.add_frames_to(command);
  command.add("--leaf", a->leaf, "most polygons in a leaf of the tree; whole leaves are drawn or left out")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{4096});
  command.add("--rays", a->rays, "WxH, pictures with a ray for each pixel, separated by commas (default: 160x90,640x360)")
      .split_at(',');
  command.add("--repetitions", a->options.repetitions, "rounds; each measures everything once")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1000});
  add_output(command, "--out", a->out, "folder to write rivals.json and rivals.html to");
  command.add_flag("--json", a->json, "print rivals.json instead of a table");
  command.run([a] { bench_rivals(*a); });
}

}  // namespace occlude::cli
