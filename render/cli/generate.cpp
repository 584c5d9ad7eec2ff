// SPDX-License-Identifier: MIT
// occlude generate city
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/city.h"
#include "occlude/render/console.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_file.h"

namespace occlude::cli {
namespace {

struct GenerateArguments {
  std::size_t polygons = 500'000;
  std::string seed = "1", out, path;
  bool json = false;
};

void generate(const GenerateArguments& arguments) {
  const std::uint64_t seed = whole_number("--seed", arguments.seed);
  render::OutputFile model(arguments.out), path(arguments.path);
  const render::City city = render::generate_city(arguments.polygons, seed);
  render::check_interrupt();
  const std::string comment =
      fmt::format("occlude generate city --polygons {} --seed {}; metres, Z up", arguments.polygons, arguments.seed);
  render::write_ply(model, city.soup, comment);
  render::write_camera_path(path, city.path);
  model.close();
  path.close();
  {
    const render::Uninterrupted together;
    model.commit();
    path.commit();
  }
  if (arguments.json) {
    const nlohmann::ordered_json summary{
        {"polygons", city.soup.size()}, {"vertices", city.soup.vertices.size()}, {"frames", city.path.frames}};
    render::print(summary.dump(2) + "\n");
    return;
  }
  render::tell(fmt::format("{}: {} polygons, {} vertices\n{}: {} frames\n", arguments.out, city.soup.size(),
                           city.soup.vertices.size(), arguments.path, city.path.frames));
}

}  // namespace

void add_generate(Command app, int&) {
  Command command = app.add_command("generate", "Make a model and a camera path");
  command.require_command();
  command.footer("Example: occlude generate city --out city.ply --path city.json");
  Command city =
      command.add_command("city", "London streets, the centre of Tenochtitlan and English hills, as in the paper");
  city.footer("Example: occlude generate city --polygons 500000 --seed 1 --out city.ply --path city.json");
  const auto arguments = std::make_shared<GenerateArguments>();
  city.add("--polygons", arguments->polygons, "minimum number of polygons")
      .show_default()
      .in_range(render::kSmallestCity, render::kLargestCity);
  city.add("--seed", arguments->seed, "whole number; the same seed gives the same bytes on any machine").show_default();
  add_output(city, "--out", arguments->out, "PLY file to write", ".ply").required();
  add_output(city, "--path", arguments->path, "JSON file to write the camera path to", ".json").required();
  city.add_flag("--json", arguments->json, "print the counts as JSON");
  city.run([arguments] { generate(*arguments); });
}

}  // namespace occlude::cli
