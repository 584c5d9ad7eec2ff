// SPDX-License-Identifier: MIT
// Options that several subcommands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "occlude/render/walk.h"

namespace occlude::cli {

/// Which frames, seen how and culled how.
class WalkArguments {
 public:
  void add_to(CLI::App& command);

  /// What the user chose. Throws CLI::ValidationError for text that cannot be read.
  [[nodiscard]] render::WalkOptions options() const;

 private:
  std::string frames_, size_;
  culler::CullOptions cull_;
};

}  // namespace occlude::cli
