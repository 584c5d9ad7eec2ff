// SPDX-License-Identifier: MIT
// occlude walk
#include "occlude/render/walk.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cases/case_line.h"
#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/machine.h"
#include "occlude/render/methods.h"
#include "occlude/render/model_text.h"
#include "occlude/render/output_file.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "occlude/render/store.h"
#include "occlude/render/summary.h"
#include "occlude/render/walk_files.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

struct WalkCommand {
  std::string model, out = "report", witness, log, cases;
  PathArguments path;
  WalkArguments walk;
  bool no_render = false, json = false;
};

/// Writes the shadow tests as lines of a case file.
void record_shadow_tests(render::WalkOptions& options, render::OutputFile& file) {
  options.on_shadow_test = [&file, number = std::size_t{0}](const render::ShadowTest& test) mutable {
    const std::string id = fmt::format("frame {} test {}", test.frame, number++);
    file.write(cases::write_case(id, {test.viewpoint, test.occluder, test.near, test.box}, "") + '\n');
  };
}

/// Whether the path is the one that an earlier walk has left in this folder.
bool is_path_of(const std::filesystem::path& folder, const PathArguments& path) {
  std::error_code error;
  return std::filesystem::equivalent(folder / render::kPathFile, path.file(), error);
}

/// The culler of the walk beside: of the same model, and by another method prepared for that.
culler::Culler culler_beside(const culler::Culler& culler, const std::string& model, const render::WalkOptions& walk,
                             const render::WalkOptions& options) {
  const bool is_of_same = culler::is_by_cover(options.cull.method) == culler::is_by_cover(walk.cull.method);
  if (is_of_same && options.build.hierarchy.leaf_size == walk.build.hierarchy.leaf_size) return culler;
  return render::is_store(model) ? make_culler(render::ModelFile(model), options)
                                 : make_culler(render::model_of(culler), options);
}

/// The first lines: what was read.
std::string what_is_walked(const std::string& name, const culler::Culler& culler, const render::Convention& convention,
                           const render::CameraPath& path) {
  return render::text_of_model(name, culler.hierarchy(), convention) + fmt::format("path: {} frames\n\n", path.frames);
}

void walk(const WalkCommand& arguments, int& exit_code, const std::string& command_line) {
  const std::optional<double> load = render::load_of_machine();  // before this walk adds to it
  render::WalkOptions options = arguments.walk.options(arguments.model);
  options.render = !arguments.no_render;
  if (!arguments.witness.empty()) options.witness = arguments.witness;
  if (!arguments.log.empty()) options.log = arguments.log;
  std::optional<render::OutputFile> cases;
  if (!arguments.cases.empty()) record_shadow_tests(options, cases.emplace(arguments.cases));
  const std::filesystem::path out = arguments.out;
  render::WalkFiles files(out, options, command_line, !is_path_of(out, arguments.path));
  const std::string name = render::printable(std::filesystem::path(arguments.model).filename().native());
  std::optional<render::ShownStage> stage("reading");
  render::ModelFile model = open_model(arguments.model, options);
  if (model.soup) render::require_walkable(model.soup->size(), name);
  stage.emplace("making the path");
  const render::CameraPath path = arguments.path.through(model);
  static_cast<void>(render::frames_of(path, options));  // throws before the work
  const render::Convention convention = model.notes.convention;
  stage.emplace("preparing");
  const render::Stopwatch stopwatch;
  const culler::Culler culler = render::make_culler(std::move(model), options);
  const double preprocess_s = stopwatch.seconds();
  stage.reset();
  warn_of_misfit(path, arguments.path, arguments.model, culler.hierarchy().soup());
  if (!arguments.json) render::tell(what_is_walked(name, culler, convention, path));
  render::WalkResult result = render::walk(culler, path, options, name, files);
  result.preprocess_s = preprocess_s;
  result.load = load;
  render::Summary summary = summarise(result, options, name);
  bool has_passed = render::passed(result);
  const std::vector<render::WalkOptions> beside =
      arguments.walk.has_method() ? std::vector<render::WalkOptions>() : render::options_beside(options);
  std::vector<render::WalkResult> results;
  std::vector<render::MethodWalk> walks{{&options, &result}};
  results.reserve(beside.size());  // walks refer to them
  for (const render::WalkOptions& other : beside) {
    stage.emplace("preparing");
    const culler::Culler of_other = culler_beside(culler, arguments.model, options, other);
    stage.reset();
    results.push_back(render::walk(of_other, path, other, name, files.add_method()));
    walks.push_back({&other, &results.back()});
    has_passed = has_passed && render::passed(results.back());
  }
  summary.methods = render::methods_of(walks, options.render);
  exit_code = has_passed ? kDone : kCheckFailed;
  stage.emplace("writing the report");
  files.write(walks, summary, path);
  if (cases) cases->close();
  {
    const render::Uninterrupted together;
    files.commit();
    if (cases) cases->commit();
  }
  stage.reset();
  if (arguments.json) {
    render::print(json_of(summary).dump(2) + "\n");
  } else {
    render::tell(
        fmt::format("{}report: {}\n", text_of(summary, render::Paint(STDOUT_FILENO)), (out / "report.html").string()));
  }
}

}  // namespace

void add_walk(Command app, int& exit_code, const std::string& command_line) {
  Command command = app.add_command("walk", "Walk a path through a model with and without occlusion culling, and compare");
  command.footer(
      "Writes summary.json, frames.csv, report.html, path.json and plates/*.png into DIR. --path DIR/path.json repeats\n"
      "the walk. Without --path it leads through the model at eye height if there is room for that, else round it.\n"
      "Exit code: 0, or 1 if a visible polygon was culled or a pixel differs without explanation, or 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude walk city.ply\n"
      "Example: occlude walk city.ply --path city.json --out report --witness witness.jsonl");
  const auto a = std::make_shared<WalkCommand>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  a->path.add_to(command, "camera path");
  a->walk.add_hold_to(command, a->path.add_region_to(command));
  add_output(command, "--out", a->out, "folder to write to").show_default();
  a->walk.add_size_to(command);
  a->walk.add_culling_to(command);
  a->walk.add_model_to(command);
  command.add_flag("--no-render", a->no_render, "draw nothing: measure culling only");
  add_output(command, "--witness", a->witness, "write the proof of every cull to this file (JSON Lines)");
  add_output(command, "--log", a->log, "write what each frame drew to this file, for `occlude audit` (JSON Lines)");
  command.under(kDebugging, [&] {
    a->walk.of_frusta(
        add_output(command, "--cases", a->cases,
                   "write the shadow tests of about 48 frames to this file, as cases for occlude classify and fuzz"));
  });
  command.add_flag("--json", a->json, "print summary.json instead of Table 2");
  command.run([a, &exit_code, command_line] { walk(*a, exit_code, command_line); });
}

}  // namespace occlude::cli
