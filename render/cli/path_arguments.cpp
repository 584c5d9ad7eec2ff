// SPDX-License-Identifier: MIT
#include "path_arguments.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "command_arguments.h"
#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/model_cameras.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_place.h"
#include "occlude/render/path_fit.h"
#include "occlude/render/printable.h"
#include "occlude/render/tour.h"

namespace occlude::cli {
namespace {

using render::TourKind;

/// The kind of path to make; nothing if `path` is a file.
std::optional<TourKind> kind_of(const std::string& path) {
  if (path.empty()) return TourKind::automatic;
  for (const TourKind kind : {TourKind::walk, TourKind::fly, TourKind::orbit}) {
    if (path == to_string(kind)) return kind;
  }
  return std::nullopt;
}

/// The camera of the model that is meant; nothing if none is.
std::optional<std::string> camera_in(const std::string& path) {
  constexpr std::string_view kCamera = "camera:";
  return path.starts_with(kCamera) ? std::optional(path.substr(kCamera.size())) : std::nullopt;
}

bool is_file(const std::string& path) { return !kind_of(path) && !camera_in(path); }

std::string name_of(const std::string& model_file) {
  return render::printable(std::filesystem::path(model_file).filename().native());
}

render::CameraPath camera_path(const std::string& model_file, const std::string& camera, const render::ModelNotes& notes) {
  render::CameraPath path = render::read_model_camera(model_file, camera, notes);
  path.model = name_of(model_file);
  return path;
}

render::CameraPath made_path(const std::string& model_file, culler::SoupView soup, const glm::dvec3& up, TourKind kind) {
  try {
    render::Tour tour = make_tour(soup, up, kind, render::check_interrupt);
    if (kind != TourKind::automatic && kind != tour.kind) {
      warn(model_file,
           fmt::format("there is no way to {} in it: the path is of the kind {}", to_string(kind), to_string(tour.kind)));
    }
    tour.path.model = name_of(model_file);
    return tour.path;
  } catch (const std::invalid_argument& error) {
    throw render::InputError(model_file + ": no camera path can be made: " + error.what());
  }
}

}  // namespace

Option PathArguments::add_region_to(Command command) {
  constexpr double kLargest = 1e9;
  return command
      .add("--region", region_,
           "cull each frame for all eyes within this distance of the path, in units of the model: what is culled is hidden "
           "from all of them")
      .in_range(0, kLargest);
}

Option PathArguments::add_to(Command command, const std::string& text, const std::string& otherwise) {
  const std::string help = fmt::format(
      "{}: a file (JSON, or CSV of matrices); camera:NAME, a camera of the model; or walk, fly or orbit to make one "
      "(default: {})",
      text, otherwise);
  Option path = command.add("--path", path_, help).check(check_named).each([](const std::string& file) {
    if (is_file(file)) render::keep_input(file);
  });
  command.under(kTuning, [&] {
    command.add("--matrix-order", order_, "order of the numbers of a path's matrices, where neither they nor the file tell")
        .one_of({"row", "column"})
        .needs(path);
  });
  return path;
}

std::string PathArguments::file() const { return is_file(path_) ? path_ : ""; }

render::CameraPath PathArguments::through(const render::ModelFile& model) const {
  if (model.soup) return through(model.path, *model.soup, model.notes);
  // The polygons of a store are read for a path that is made, and for no other.
  return through(model.path, kind_of(path_) ? render::read_model(model.path).soup : culler::PolygonSoup(), model.notes);
}

render::CameraPath PathArguments::through(const std::string& model_file, const render::Model& model) const {
  return through(model_file, model.soup, model.notes);
}

render::CameraPath PathArguments::through(const std::string& model_file, culler::SoupView soup,
                                          const render::ModelNotes& notes) const {
  render::CameraPath path = named(model_file, soup, notes);
  path.eyes = culler::EyeRegion::ball(region_);
  return path;
}

render::CameraPath PathArguments::named(const std::string& model_file, culler::SoupView soup,
                                        const render::ModelNotes& notes) const {
  if (const auto made = kind_of(path_)) return made_path(model_file, soup, up_of(notes), *made);
  if (const auto camera = camera_in(path_)) return camera_path(model_file, *camera, notes);
  render::PathDefaults defaults{.up = up_of(notes), .order = std::nullopt};
  if (!order_.empty()) defaults.order = order_ == "row" ? render::MatrixOrder::row : render::MatrixOrder::column;
  return render::read_camera_path(path_, defaults);
}

void warn_of_misfit(const render::CameraPath& path, const PathArguments& arguments, const std::string& model_file,
                    culler::SoupView model) {
  if (path.noise != 0) warn(arguments.name(), fmt::format("{} numbers nearer to 0 than 2^-100 were taken as 0", path.noise));
  warn(arguments.name(), render::doubt_about(path, model_file, model));
}

}  // namespace occlude::cli
