// SPDX-License-Identifier: MIT
// occlude walk
#include "occlude/render/walk.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "case_line.h"
#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_file.h"
#include "occlude/render/printable.h"
#include "occlude/render/walk_summary.h"

namespace occlude::cli {
namespace {

struct Arguments {
  std::string model, path, out, witness, cases;
  WalkArguments walk;
  bool no_render = false, json = false;
};

/// As the lines of a case file.
void record_shadow_tests(render::WalkOptions& options, render::OutputFile& file) {
  options.on_shadow_test = [&file, number = std::size_t{0}](const render::ShadowTest& test) mutable {
    const std::string id = fmt::format("frame {} test {}", test.frame, number++);
    file.stream() << write_case(id, {test.viewpoint, test.occluder, test.near, test.box}, "") << '\n';
  };
}

int walk(const Arguments& arguments) {
  render::WalkOptions options = arguments.walk.options();
  options.render = !arguments.no_render;
  if (!arguments.witness.empty()) options.witness = arguments.witness;
  const std::filesystem::path out = arguments.out;
  std::vector<std::string> files{arguments.model, arguments.path, out / "summary.json", out / "frames.csv",
                                 out / "report.html"};
  if (options.witness) files.push_back(arguments.witness);
  std::optional<render::OutputFile> cases;
  if (!arguments.cases.empty()) files.push_back(arguments.cases);
  check_distinct(files);
  const render::CameraPath path = render::read_camera_path(arguments.path);
  const culler::PolygonSoup soup = render::read_model(arguments.model);
  if (!arguments.cases.empty()) record_shadow_tests(options, cases.emplace(arguments.cases));
  const std::string name = render::printable(std::filesystem::path(arguments.model).filename().native());
  const render::WalkResult result = render::walk(soup, path, options, name, arguments.out);
  if (cases) cases->commit();
  if (arguments.json) {
    fmt::print("{}", render::summary_json(result, options, name));
  } else {
    fmt::print("{}report: {}\n", render::summary_text(result, options, name), (out / "report.html").string());
  }
  return render::passed(result) ? 0 : 1;
}

}  // namespace

void add_walk(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("walk", "Walk a path through a model with and without occlusion culling, and compare");
  command->footer(
      "Writes summary.json, frames.csv, report.html and plates/*.png into DIR.\n"
      "Exit code 0; 1 when a visible polygon was culled or a pixel differs without explanation; 2 for bad input.\n" +
      render::limits_help() +
      "\n"
      "Example: occlude walk city.ply --path city.json --out report");
  const auto a = std::make_shared<Arguments>();
  command->add_option("MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...")->required();
  command->add_option("--path", a->path, "camera path (JSON)")->required();
  command->add_option("--out", a->out, "folder to write to")->required();
  a->walk.add_size_to(*command);
  a->walk.add_culling_to(*command);
  a->walk.add_preprocess_to(*command);
  command->add_flag("--no-render", a->no_render, "measure culling alone");
  command->add_option("--witness", a->witness, "write the proof of every cull to this file (JSON Lines)");
  command->add_option(
      "--cases", a->cases,
      "write the shadow tests of some 48 of the frames to this file, as cases for occlude classify and fuzz");
  command->add_flag("--json", a->json, "print summary.json instead of Table 2");
  command->callback([a, &exit_code] { exit_code = walk(*a); });
}

}  // namespace occlude::cli
