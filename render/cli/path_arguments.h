// SPDX-License-Identifier: MIT
// The camera path of a command: from a file, or made for the model.
#pragma once

#include <string>

#include "command_line.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/model.h"
#include "occlude/render/walk.h"

namespace occlude::cli {

class PathArguments {
 public:
  /// Adds --path and --matrix-order; returns --path. `text` says what path it is, `otherwise` what the command does without
  /// one.
  Option add_to(Command command, const std::string& text, const std::string& otherwise = "made for the model");

  /// Adds --region.
  Option add_region_to(Command command);

  [[nodiscard]] bool is_given() const { return !path_.empty(); }
  /// As it is named.
  [[nodiscard]] const std::string& name() const { return path_; }
  /// The file of the path; empty if it is made, or a camera of the model.
  [[nodiscard]] std::string file() const;

  /// The path through the model. Without --path one is made. Throws InputError as read_camera_path() and read_model(), and
  /// where no path can be made. Throws Interrupted on Ctrl-C.
  [[nodiscard]] render::CameraPath through(const render::ModelFile& model) const;
  /// The same of the model in `model_file`.
  [[nodiscard]] render::CameraPath through(const std::string& model_file, const render::Model& model) const;

 private:
  [[nodiscard]] render::CameraPath through(const std::string& model_file, culler::SoupView soup,
                                           const render::ModelNotes& notes) const;

  [[nodiscard]] render::CameraPath named(const std::string& model_file, culler::SoupView soup,
                                         const render::ModelNotes& notes) const;

  std::string path_, order_;
  double region_ = 0;
};

/// Warns on standard error of numbers that were taken as 0, and if the path is probably meant for another model.
void warn_of_misfit(const render::CameraPath& path, const PathArguments& arguments, const std::string& model_file,
                    culler::SoupView model);

}  // namespace occlude::cli
