// SPDX-License-Identifier: MIT
// Options that several subcommands share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "command_line.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/digest.h"
#include "occlude/render/job.h"
#include "occlude/render/walk.h"

namespace occlude::cli {

/// Headings in the help.
inline constexpr const char *kTuning = "Tuning", *kDebugging = "Debugging";

/// The options for reading a model.
class ReadArguments {
 public:
  /// Adds the options and returns them.
  std::vector<Option> add_to(Command command);

  /// Of this model. Calls refuse() if it is a store and an option is given: they are settled in it.
  [[nodiscard]] render::ReadOptions options(const std::string& model) const;

 private:
  bool is_opaque_all_ = false;
  std::string up_, unit_;
  std::vector<Option> added_;
};

/// The options for preparing a model.
class BuildArguments {
 public:
  /// Adds the options and returns them.
  std::vector<Option> add_to(Command command);

  /// `method` is the method for which the model is prepared.
  [[nodiscard]] culler::BuildConfig config(culler::Method method = culler::Method::automatic) const;

 private:
  std::uint32_t leaf_ = 0;
  std::string bounds_ = "aabb", shapes_ = "polytope", regions_ = "grid";
};

/// Adds the budgets of a cull by cover and returns them.
std::vector<Option> add_budgets(Command command, culler::CoverOptions& cover);

/// The options of a walk: its frames, pictures and culling.
class WalkArguments {
 public:
  /// `frames`, `size` and `method` are the defaults of --frames, --size and --method.
  explicit WalkArguments(std::string frames = "all", std::string size = "640x360",
                         culler::Method method = culler::Method::automatic)
      : frames_(std::move(frames)), size_(std::move(size)), default_method_(method) {}

  void add_size_to(Command command);
  Option add_frames_to(Command command);
  /// Adds --hold, which excludes --region.
  void add_hold_to(Command command, Option region);
  /// Adds the options that affect culling and returns them.
  std::vector<Option> add_culling_to(Command command);
  /// Adds the options for reading a model, and --preprocess, which excludes those for preparing one. Returns --preprocess.
  /// Call after add_culling_to().
  Option add_model_to(Command command);

  /// Notes that by the other methods the option does nothing: without --method it asks for frusta. Returns the option.
  Option of_frusta(Option option);
  /// Whether --method is given.
  [[nodiscard]] bool has_method() const { return !method_.empty(); }
  /// The parsed options, but for those of add_model_to(). Calls refuse() for text that cannot be parsed.
  [[nodiscard]] render::WalkOptions options() const;
  /// All of them, for a walk through this model. Calls refuse() also if it is a store and an option is given by which models
  /// are read or prepared. Warns of those that do nothing by --method.
  [[nodiscard]] render::WalkOptions options(const std::string& model) const;

 private:
  void warn_of_unused() const;
  [[nodiscard]] culler::Method method() const;
  Option of_cover(Option option);
  std::vector<Option> add_common_to(Command command);
  std::vector<Option> add_tuning_to(Command command);
  std::vector<Option> add_debugging_to(Command command);

  std::string frames_, size_;
  culler::Method default_method_;
  std::string near_ = "surface", method_, cover_size_ = "576x360", arithmetic_ = "certified", test_ = "conservative",
              angle_ = "area", preprocess_;
  ReadArguments read_;
  BuildArguments build_;
  std::vector<Option> options_of_frusta_, options_of_cover_;
  std::vector<Option> build_options_;  ///< and --preprocess, once it is added
  double pixel_margin_ = culler::kPixelMargin, hold_ = 0;
  culler::CullOptions cull_;
};

/// The options of commands whose work is done in parts.
class PartsArguments {
 public:
  /// Adds the options and returns them. `name` is that of the command.
  std::vector<Option> add_to(Command command, const std::string& name);

  /// Where parts are kept. Under mpirun that is a folder also if none is named.
  [[nodiscard]] render::Keeping keeping() const;

 private:
  std::string folder_, name_;
  bool resume_ = false;
};

struct PictureSize {
  int width, height;
};

/// Parses "WxH", each from `least` to `most` pixels; calls refuse() for anything else.
[[nodiscard]] PictureSize parse_size(const std::string& option, const std::string& text, std::size_t least,
                                     std::size_t most);

/// Sets the size of the coarse picture from the text of --cover-size; calls refuse() for what is no size.
void set_cover_size(culler::CoverOptions& options, const std::string& text);

/// The largest side of a picture that is drawn; llvmpipe allows 16384, memory less.
inline constexpr std::size_t kLargestSide = 8192;

/// Parses a whole number; calls refuse() for anything else.
[[nodiscard]] std::uint64_t whole_number(const std::string& option, const std::string& text);

/// What is wrong with the name of a file: an empty one is probably a mistake, such as an unset variable in a script.
[[nodiscard]] std::string check_named(const std::string& file);

/// Adds an option, or without dashes an argument, for an input file. No output may replace that file.
Option add_input(Command command, const char* name, std::string& file, const char* text);
Option add_inputs(Command command, const char* name, std::vector<std::string>& files, const char* text);

/// Adds the same for an output file or folder.
Option add_output(Command command, const char* name, std::string& path, const std::string& text);
/// Adds the same for a file of a format that names end in, such as ".png". A name that ends as files of another do is
/// refused.
Option add_output(Command command, const char* name, std::string& path, const std::string& text, const char* extension);

/// Says on standard error what is doubtful about a file, if anything is.
void warn(const std::string& file, const std::string& doubt);

/// Reads a model, and warns of what the user must know of how it was read.
[[nodiscard]] render::Model read_model(const std::string& file, const render::ReadOptions& options);
/// The same of the model of a walk.
[[nodiscard]] render::ModelFile open_model(const std::string& file, const render::WalkOptions& options);

/// Adds all that the model consists of.
render::Digest& add(render::Digest& digest, culler::SoupView soup);

/// What is read of models of each format, for `--help`.
[[nodiscard]] std::string formats_help();

/// The limits of inputs, for `--help`.
[[nodiscard]] std::string limits_help();

}  // namespace occlude::cli
