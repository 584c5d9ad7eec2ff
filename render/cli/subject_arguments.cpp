// SPDX-License-Identifier: MIT
#include "subject_arguments.h"

#include <fmt/format.h>

#include <filesystem>

#include "command_arguments.h"
#include "experiments.h"
#include "occlude/render/city.h"
#include "occlude/render/printable.h"

namespace occlude::cli {

void SubjectArguments::add_to(Command command) {
  Option model = add_input(command, "MODEL", model_, "PLY, OBJ, glTF, COLLADA, STL, ...");
  path_.add_to(command, "camera path").needs(model);
  for (Option option : read_.add_to(command)) option.needs(model);
  command.add("--polygons", polygons_, "minimum number of polygons in the city")
      .show_default()
      .in_range(render::kSmallestCity, render::kLargestCity)
      .excludes(model);
  command.add("--seed", seed_, "whole number; the same seed gives the same cities").show_default();
}

std::uint64_t SubjectArguments::seed() const { return whole_number("--seed", seed_); }

experiments::Subject SubjectArguments::subject() const {
  if (is_city()) {
    render::City city = render::generate_city(polygons_, seed());
    return {fmt::format("generated city, seed {}", seed_), std::move(city.soup), std::move(city.path)};
  }
  render::Model model = read_model(model_, read_.options(model_));
  render::CameraPath path = path_.through(model_, model);
  warn_of_misfit(path, path_, model_, model.soup);
  return {render::printable(std::filesystem::path(model_).filename().native()), std::move(model.soup), std::move(path)};
}

}  // namespace occlude::cli
