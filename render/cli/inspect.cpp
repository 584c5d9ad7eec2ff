// SPDX-License-Identifier: MIT
// occlude inspect
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/inspect_page.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/output_file.h"
#include "occlude/render/printable.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

struct InspectArguments {
  std::string model, out = "inspect.html", page;
  PathArguments path;
  ReadArguments read;
};

/// viewer.html lies beside the program.
std::string read_page(const std::string& given) {
  std::filesystem::path file = given;
  if (given.empty()) file = std::filesystem::read_symlink("/proc/self/exe").replace_filename("viewer.html");
  if (given.empty() && !std::filesystem::exists(file)) {
    throw render::InputError(fmt::format(
        "{}: the page is not there; bash culler/js/page/build.sh builds it, --page names another place", file.native()));
  }
  std::string page = render::read_input(file);
  if (!render::is_inspect_page(page)) {
    throw render::InputError(fmt::format("{}: not a page that culler/js/page/build.sh has made", file.native()));
  }
  return page;
}

void require_small(const std::string& file, culler::SoupView model) {
  const std::size_t triangles = model.indices.size() - 2 * model.size();
  if (triangles > render::kMostPageTriangles) {
    throw render::InputError(
        fmt::format("{}: {} triangles; a page takes {} at most", file, triangles, render::kMostPageTriangles));
  }
}

void inspect(const InspectArguments& arguments) {
  render::OutputFile out(arguments.out);
  const std::string page = read_page(arguments.page);
  render::ReadOptions options = arguments.read.options(arguments.model);
  options.with_colours = true;
  const render::Model read = read_model(arguments.model, options);
  require_small(arguments.model, read.soup);
  render::Inspected inspected{render::printable(std::filesystem::path(arguments.model).filename().native()), read.soup,
                              read.colours, render::up_of(read.notes)};
  std::optional<render::CameraPath> path;
  if (arguments.path.is_given()) {
    path = arguments.path.through(arguments.model, read);
    warn_of_misfit(*path, arguments.path, arguments.model, read.soup);
    inspected.path = &*path;
  }
  out.write(inspect_page(page, inspected));
  {
    const render::Uninterrupted naming;
    out.commit();
  }
  render::tell(fmt::format("{}: open it in a browser\n", arguments.out));
}

}  // namespace

void add_inspect(Command app, int&) {
  Command command = app.add_command("inspect", "Write a page in which one flies through a model while each frame is culled");
  command.footer(
      "The page is one file that works offline. It is viewer.html, beside the program, with the model inside;\n"
      "bash culler/js/page/build.sh builds that, with Emscripten and npm.\n"
      "Keys, mouse and fingers fly; beside the camera's view is one from outside, with what is hidden; a click says why.\n"
      "Pictures are in perspective, whatever the path says. Polygons have the colours of their materials or vertices,\n"
      "if the file has any.\n"
      "Exit code: 0, or 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude inspect city.ply --path city.json --out city.html");
  const auto a = std::make_shared<InspectArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  a->path.add_to(command, "path to fly along", "round the model");
  a->read.add_to(command);
  add_output(command, "--out", a->out, "HTML file to write to", ".html").show_default();
  add_input(command, "--page", a->page, "the page to put it into, if it is not beside the program");
  command.run([a] { inspect(*a); });
}

}  // namespace occlude::cli
