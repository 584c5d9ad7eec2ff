// SPDX-License-Identifier: MIT
// Options that several subcommands share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "command_line.h"
#include "occlude/render/walk.h"

namespace occlude::cli {

/// How a model is prepared.
class BuildArguments {
 public:
  /// Returns the options.
  std::vector<Option> add_to(Command command);

  /// `method` is what the model is prepared for.
  [[nodiscard]] culler::BuildConfig config(culler::Method method = culler::Method::frusta) const;

 private:
  std::uint32_t leaf_ = 0;
  std::string bounds_ = "aabb", shapes_ = "polytope";
};

/// Which frames, seen how and culled how.
class WalkArguments {
 public:
  /// `frames` are taken where the user names none.
  explicit WalkArguments(std::string frames = "all") : frames_(std::move(frames)) {}

  void add_size_to(Command command);
  /// The options that decide what is culled; returns them.
  std::vector<Option> add_culling_to(Command command);
  /// The option that takes the place of those about how the model is prepared. After add_culling_to().
  Option add_preprocess_to(Command command);

  /// What the user chose. refuse()s text that cannot be read.
  [[nodiscard]] render::WalkOptions options() const;

 private:
  std::string frames_;
  std::string size_ = "640x360", near_ = "surface", method_ = "frusta", cover_size_ = "512x288", arithmetic_ = "certified",
              test_ = "conservative", angle_ = "area", preprocess_;
  BuildArguments build_;
  std::vector<Option> build_options_;
  double pixel_margin_ = render::kPixelMargin;
  culler::CullOptions cull_;
};

/// The whole number in `text`; refuse()s anything else.
[[nodiscard]] std::uint64_t whole_number(const std::string& option, const std::string& text);

/// An option, or without dashes an argument, for a file that the command reads; its outputs will not replace it.
Option add_input(Command command, const char* name, std::string& file, const char* text);
Option add_inputs(Command command, const char* name, std::vector<std::string>& files, const char* text);

/// The same for a file or folder that it writes.
Option add_output(Command command, const char* name, std::string& path, const char* text);

/// What `--help` says of the limits of inputs.
[[nodiscard]] std::string limits_help();

}  // namespace occlude::cli
