// SPDX-License-Identifier: MIT
// What a benchmark of the culler is about: a model and a path through it, or a generated city.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "command_arguments.h"
#include "command_line.h"
#include "path_arguments.h"
#include "setting.h"

namespace occlude::cli {

class SubjectArguments {
 public:
  /// `polygons` is the default of --polygons.
  explicit SubjectArguments(std::size_t polygons) : polygons_(polygons) {}

  void add_to(Command command);

  [[nodiscard]] bool is_city() const { return model_.empty(); }
  /// Of the city. Calls refuse() for a text that is no seed.
  [[nodiscard]] std::uint64_t seed() const;
  /// Reads the model and the path, or generates the city.
  [[nodiscard]] experiments::Subject subject() const;

 private:
  std::string model_, seed_ = "1";
  PathArguments path_;
  ReadArguments read_;
  std::size_t polygons_;
};

}  // namespace occlude::cli
