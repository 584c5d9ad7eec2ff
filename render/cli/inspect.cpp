// SPDX-License-Identifier: MIT
// occlude inspect
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/live_page.h"
#include "occlude/render/output_file.h"
#include "occlude/render/printable.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

struct InspectArguments {
  std::string model, out = "inspect.html", module;
  PathArguments path;
  ReadArguments read;
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
  const render::Model read = read_model(arguments.model, arguments.read.options());
  const culler::PolygonSoup& model = read.soup;
  if (model.size() > render::kMostLivePolygons) {
    throw render::InputError(
        fmt::format("{}: {} polygons; a page takes {} at most", arguments.model, model.size(), render::kMostLivePolygons));
  }
  render::LiveStart start = render::start_beside(model);
  if (arguments.path.is_given()) {
    const render::CameraPath path = arguments.path.through(arguments.model, read);
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
  a->path.add_to(command, "path to start on, and to fly along", "none");
  a->read.add_to(command);
  add_output(command, "--out", a->out, "HTML file to write to").show_default();
  add_input(command, "--module", a->module, "the culler for pages, if it is not beside the program");
  command.run([a] { inspect(*a); });
}

}  // namespace occlude::cli
