// SPDX-License-Identifier: MIT
// occlude inspect
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/live_page.h"
#include "occlude/render/output_file.h"
#include "occlude/render/printable.h"

namespace occlude::cli {
namespace {

struct InspectArguments {
  ReadArguments read;
  std::string model, path, out = "inspect.html", module;
};

/// live.wasm lies beside the program.
std::string read_module(const std::string& given) {
  std::filesystem::path file = given;
  if (given.empty()) file = std::filesystem::read_symlink("/proc/self/exe").replace_filename("live.wasm");
  if (given.empty() && !std::filesystem::exists(file)) {
    throw render::InputError(fmt::format(
        "{}: the culler for pages is not there; bash render/live/build.sh builds it, --module names another place",
        file.native()));
  }
  std::string bytes = render::read_input(file);
  if (!bytes.starts_with(std::string("\0asm", 4))) {
    throw render::InputError(fmt::format("{}: not a WebAssembly module", file.native()));
  }
  return bytes;
}

void inspect(const InspectArguments& arguments) {
  render::OutputFile out(arguments.out);
  const std::string module = read_module(arguments.module);
  const culler::PolygonSoup model = read_soup(arguments.model, arguments.read.options());
  if (model.size() > render::kMostLivePolygons) {
    throw render::InputError(
        fmt::format("{}: {} polygons; a page takes {} at most", arguments.model, model.size(), render::kMostLivePolygons));
  }
  render::LiveStart start = render::start_beside(model);
  if (!arguments.path.empty()) {
    const render::CameraPath path = render::read_camera_path(arguments.path);
    warn_of_misfit(path, arguments.path, arguments.model, model);
    start = render::start_of(path, model);
  }
  out.write(live_page(render::printable(std::filesystem::path(arguments.model).filename().native()), model, start, module));
  {
    const render::Uninterrupted naming;
    out.commit();
  }
  render::tell(fmt::format("{}: open it in a browser\n", arguments.out));
}

}  // namespace

void add_inspect(Command app, int&) {
  Command command = app.add_command("inspect", "Write a page in which one walks through a model while each frame is culled");
  command.footer(
      "The page is one file that works offline. The culler in it is live.wasm, beside the program;\n"
      "bash render/live/build.sh builds it, with Emscripten.\n"
      "Keys and mouse walk; method, occluders, budget and margin can be changed; from outside one sees what is culled.\n"
      "Exit code: 0, or 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude inspect city.ply --path city.json --out city.html");
  const auto a = std::make_shared<InspectArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  add_input(command, "--path", a->path, "camera path (JSON): start at its first frame, and fly along it");
  a->read.add_to(command);
  add_output(command, "--out", a->out, "HTML file to write to").show_default();
  add_input(command, "--module", a->module, "the culler for pages, if it is not beside the program");
  command.run([a] { inspect(*a); });
}

}  // namespace occlude::cli
