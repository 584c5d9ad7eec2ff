// SPDX-License-Identifier: MIT
// occlude render
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/frame_painter.h"
#include "occlude/render/frames_along_path.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/progress.h"
#include "occlude/render/why.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

struct RenderArguments {
  std::string model, out, layer = "drawn";
  PathArguments path;
  std::optional<std::string> frame;
  std::uint32_t fps = 10;
  bool json = false;
  WalkArguments walk{"all", "1280x720"};
};

using Draw = render::Image (*)(render::FramePainter&, const culler::Camera&, const culler::CullResult&);

template <render::Style style>
render::Image one_layer(render::FramePainter& painter, const culler::Camera& camera, const culler::CullResult& result) {
  return painter.layer(style, camera, result);
}

struct Layer {
  const char *name, *what;
  Draw draw;
};
const std::array<Layer, 8> kLayers{{
    {"drawn", "what is drawn",
     [](auto& painter, const auto& camera, const auto& result) { return painter.view(camera, result.drawn); }},
    {"all", "the whole model", [](auto& painter, const auto& camera, const auto&) { return painter.whole(camera); }},
    {"seen", "what is drawn and seen", one_layer<render::Style::drawn>},
    {"missed", "what is drawn, but hidden", one_layer<render::Style::missed>},
    {"culled", "what is culled because it is hidden", one_layer<render::Style::culled>},
    {"occluders", "the occluders of frusta", one_layer<render::Style::occluder>},
    {"fates", "the whole model, by what became of it",
     [](auto& painter, const auto& camera, const auto& result) { return painter.fates(camera, result); }},
    {"outside", "the same, from above and behind the camera",
     [](auto& painter, const auto& camera, const auto& result) { return painter.outside(camera, result); }},
}};

void render_frames(const RenderArguments& arguments) {
  const render::WalkOptions options = arguments.walk.options(arguments.model);
  std::optional<std::size_t> frame;
  if (arguments.frame) frame = whole_number("--frame", *arguments.frame);
  render::OutputFile file(arguments.out);
  render::ModelFile model = open_model(arguments.model, options);
  const render::CameraPath path = arguments.path.through(model);
  const culler::Culler culler = render::make_culler(std::move(model), options);
  warn_of_misfit(path, arguments.path, arguments.model, culler.hierarchy().soup());
  const Draw draw = std::ranges::find(kLayers, arguments.layer, &Layer::name)->draw;
  const auto context = render::make_offscreen_context();
  render::FramePainter painter(culler, options.width, options.height);
  std::size_t pictures = 1;
  if (frame) {
    const render::ReplayedFrame replayed(culler, path, options, *frame);
    render::write_png(file, draw(painter, replayed.camera(), replayed.result()));
  } else {
    const std::vector<std::size_t> frames = render::frames_of(path, options);
    pictures = frames.size();
    render::FramesAlongPath along(culler, path, options);
    render::Animation animation(file, static_cast<std::uint32_t>(frames.size()), arguments.fps);
    render::Progress progress("picture", frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const culler::Camera camera = path.camera(frames[i], render::aspect(options));
      along.go_to(frames[i]);
      along.cull();
      animation.add(draw(painter, camera, along.result()));
      render::check_interrupt();
      progress.update(i + 1);
    }
  }
  {
    const render::Uninterrupted naming;
    file.commit();
  }
  if (arguments.json) {
    const nlohmann::ordered_json summary{
        {"layer", arguments.layer}, {"width", options.width}, {"height", options.height}, {"pictures", pictures}};
    render::print(summary.dump(2) + "\n");
    return;
  }
  render::tell(fmt::format("{}: {} of {}x{} pixels\n", arguments.out,
                           pictures == 1 ? "a picture" : fmt::format("{} pictures", pictures), options.width,
                           options.height));
}

}  // namespace

void add_render(Command app, int&) {
  Command command = app.add_command("render", "Draw a layer of a frame, or of several as an animation");
  std::string layers = "Layers:\n";
  std::vector<std::string> names;
  for (const Layer& layer : kLayers) {
    layers += fmt::format("  {:<10} {}\n", layer.name, layer.what);
    names.emplace_back(layer.name);
  }
  command.footer(layers + "The earlier frames are culled first, as in a walk; give the options of that walk.\n" +
                 limits_help() +
                 "\n"
                 "Example: occlude render city.ply --path city.json --frame 120 --layer outside --out outside.png\n"
                 "Example: occlude render city.ply --path city.json --frames 0:600:10 --layer fates --out fates.png");
  const auto a = std::make_shared<RenderArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  a->path.add_to(command, "camera path");
  a->walk.add_hold_to(command, a->path.add_region_to(command));
  add_output(command, "--out", a->out, "PNG file to write", ".png").required();
  command.add("--frame", a->frame, "number of the frame, from 0 (default: all of --frames, as an animated PNG)");
  command.add("--layer", a->layer, "what to draw: see below").show_default().one_of(names);
  command.add("--fps", a->fps, "frames per second of an animation")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{100});
  a->walk.add_size_to(command);
  a->walk.add_culling_to(command);
  a->walk.add_model_to(command);
  command.add_flag("--json", a->json, "print what was drawn as JSON");
  command.run([a] { render_frames(*a); });
}

}  // namespace occlude::cli
