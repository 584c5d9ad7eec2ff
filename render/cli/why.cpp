// SPDX-License-Identifier: MIT
// occlude why
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/progress.h"
#include "occlude/render/scene_renderer.h"
#include "occlude/render/why_report.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

struct WhyArguments {
  std::string model, frame, pixel, out;
  PathArguments path;
  std::optional<std::uint32_t> polygon;
  WalkArguments walk;
  bool json = false;
};

/// Throws InputError if the model lacks the requested polygon.
void require_polygon(const WhyArguments& arguments, std::size_t polygons) {
  if (arguments.polygon && *arguments.polygon >= polygons) {
    throw render::InputError(
        fmt::format("{}: no polygon {}: the model has {}", arguments.model, *arguments.polygon, polygons));
  }
}

/// The index in the tree of this polygon of the model; of several pieces, of the first one among those that show most.
std::uint32_t polygon_of(const culler::Hierarchy& hierarchy, std::uint32_t face, const render::ItemBuffer& items) {
  const std::vector<std::uint32_t> pixels = items.pixels_of(hierarchy.soup().size());
  std::optional<std::uint32_t> best;
  for (std::uint32_t p = 0; p < pixels.size(); ++p) {
    if (hierarchy.face(p) == face && (!best || pixels[p] > pixels[*best])) best = p;
  }
  return *best;
}

/// The polygon visible at a pixel: the opaque one or, where there is none, the nearest see-through one.
std::uint32_t polygon_at(const render::ItemBuffer& items, int x, int y) {
  const std::uint32_t opaque = items.at(x, y);
  return opaque == render::kNothing && !items.before.pixels.empty() ? items.before.at(x, y) : opaque;
}

struct Pixel {
  int x, y;  ///< from the top left corner
};

Pixel parse_pixel(const std::string& text, const render::WalkOptions& options) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) refuse("--pixel", "expected X,Y");
  const std::uint64_t x = whole_number("--pixel", text.substr(0, comma)),
                      y = whole_number("--pixel", text.substr(comma + 1));
  if (x >= static_cast<std::uint64_t>(options.width) || y >= static_cast<std::uint64_t>(options.height)) {
    refuse("--pixel", fmt::format("the picture has {}x{} pixels", options.width, options.height));
  }
  return {static_cast<int>(x), static_cast<int>(y)};
}

int why(const WhyArguments& arguments) {
  const render::WalkOptions options = arguments.walk.options(arguments.model);
  std::optional<Pixel> pixel;
  if (!arguments.polygon) pixel = parse_pixel(arguments.pixel, options);
  const std::size_t number = whole_number("--frame", arguments.frame);
  std::optional<render::WhyFiles> files;
  if (!arguments.out.empty()) files.emplace(arguments.out);
  render::ModelFile model = open_model(arguments.model, options);
  if (model.soup) require_polygon(arguments, model.soup->face_count());
  const render::CameraPath path = arguments.path.through(model);
  const culler::Culler culler = render::make_culler(std::move(model), options);
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  require_polygon(arguments, hierarchy.face_count());  // a store is opened only now
  warn_of_misfit(path, arguments.path, arguments.model, hierarchy.soup());
  const render::ReplayedFrame frame(culler, path, options, number);

  const auto context = render::make_offscreen_context();
  const culler::PolygonRange all = hierarchy.soup().all();
  const render::ItemBuffer items =
      render::SceneRenderer(hierarchy.soup(), options.width, options.height).item_buffer(frame.camera(), std::span(&all, 1));
  const std::uint32_t polygon =
      pixel ? polygon_at(items, pixel->x, pixel->y) : polygon_of(hierarchy, *arguments.polygon, items);
  if (polygon == render::kNothing) {
    throw render::InputError(fmt::format("--pixel {}: no polygon is visible there", arguments.pixel));
  }
  const render::Account account = render::account_for(frame, polygon, items);
  render::check_interrupt();
  arguments.json ? render::print(render::to_json(frame, account)) : render::tell(render::to_text(frame, account));
  if (files) files->write(frame, account);
  return 0;
}

}  // namespace

void add_why(Command app, int& exit_code) {
  Command command = app.add_command("why", "Explain why a frame of a walk drew or culled a polygon");
  command.footer("The earlier frames are culled first, as in a walk; give the options of that walk.\n" + limits_help() +
                 "\n"
                 "Example: occlude why city.ply --path city.json --frame 120 --pixel 320,180");
  const auto a = std::make_shared<WhyArguments>();
  add_input(command, "MODEL", a->model, "model of the walk").required();
  a->path.add_to(command, "camera path of the walk");
  a->walk.add_hold_to(command, a->path.add_region_to(command));
  command.add("--frame", a->frame, "number of the frame, from 0").required();
  Command which = command.add_alternatives("which", "the polygon");
  which.add("--polygon", a->polygon, "number in the model file, from 0");
  which.add("--pixel", a->pixel, "X,Y from the top left corner: the polygon visible there without culling");
  add_output(command, "--out", a->out, "folder for why.json and plates from the camera and from outside");
  a->walk.add_size_to(command);
  a->walk.add_culling_to(command);
  a->walk.add_model_to(command);
  command.add_flag("--json", a->json, "print JSON instead of text");
  command.run([a, &exit_code] { exit_code = why(*a); });
}

}  // namespace occlude::cli
