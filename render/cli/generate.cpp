// SPDX-License-Identifier: MIT
// occlude generate city
#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/city.h"
#include "occlude/render/model_io.h"

namespace occlude::cli {
namespace {

struct Arguments {
  std::size_t polygons = 500'000;
  std::uint64_t seed = 1;
  std::string out, path;
};

void generate(const Arguments& arguments) {
  const render::City city = render::generate_city(arguments.polygons, arguments.seed);
  const std::string comment =
      fmt::format("occlude generate city --polygons {} --seed {}; metres, Z up", arguments.polygons, arguments.seed);
  render::write_ply(arguments.out, city.soup, comment);
  render::write_camera_path(arguments.path, city.path);
  fmt::print("{}: {} polygons, {} vertices\n{}: {} frames\n", arguments.out, city.soup.size(), city.soup.vertices.size(),
             arguments.path, city.path.frames);
}

}  // namespace

void add_generate(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("generate", "Make a model and a camera path");
  command->require_subcommand(1);
  CLI::App* city =
      command->add_subcommand("city", "London streets, the centre of Tenochtitlan and English hills, as in the paper");
  city->footer("Example: occlude generate city --polygons 500000 --seed 1 --out city.ply --path city.json");
  const auto arguments = std::make_shared<Arguments>();
  city->add_option("--polygons", arguments->polygons, "at least so many polygons")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{20'000}, std::size_t{20'000'000}));
  city->add_option("--seed", arguments->seed, "same seed, same bytes, on any machine")->capture_default_str();
  city->add_option("--out", arguments->out, "PLY file to write")->required();
  city->add_option("--path", arguments->path, "JSON file to write the camera path to")->required();
  city->callback([arguments] { generate(*arguments); });
}

}  // namespace occlude::cli
