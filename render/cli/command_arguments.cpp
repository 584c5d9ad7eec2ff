// SPDX-License-Identifier: MIT
#include "command_arguments.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "occlude/render/console.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/methods.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_place.h"
#include "occlude/render/paint.h"
#include "occlude/render/printable.h"
#include "occlude/render/ranks.h"
#include "occlude/render/store.h"

namespace occlude::cli {
namespace {

/// The numbers of "A:B:STEP" or "WxH"; refuse()s anything else.
std::vector<std::size_t> numbers(const std::string& option, const std::string& text, char separator) {
  std::vector<std::size_t> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    std::size_t value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) refuse(option, "cannot read '" + text + "'");
    values.push_back(value);
    if (next == end) return values;
    if (*next != separator) refuse(option, "cannot read '" + text + "'");
    at = next + 1;
  }
}

void parse_frames(const std::string& text, render::WalkOptions& options) {
  if (text == "all") return;
  const auto values = numbers("--frames", text, ':');
  if (values.size() < 2 || values.size() > 3) refuse("--frames", "expected A:B, A:B:STEP or all");
  options.begin = values[0];
  options.end = values[1];
  options.step = values.size() == 3 ? values[2] : 1;
  if (options.step == 0) refuse("--frames", "STEP must be at least 1");
}

/// What is wrong with a unit or an axis.
template <class Parse>
std::string fault_of(const std::string& text, const Parse& parse, const char* expected) {
  return text == "file" || parse(text) ? "" : fmt::format("expected {}, or file", expected);
}

/// Calls refuse() if the model is a store and one of these options is given, which are settled in it.
void require_settled(const std::vector<Option>& options, const std::string& model) {
  const auto given = std::ranges::find_if(options, &Option::is_given);
  if (given == options.end() || !render::is_store(model)) return;
  refuse(given->name(), model + " is a store, in which this is settled: give it to the `occlude preprocess` that makes it");
}

Option choice(Command command, const char* name, std::string& value, const std::vector<std::string>& choices,
              const char* text) {
  return command.add(name, value, text).show_default().one_of(choices);
}

}  // namespace

PictureSize parse_size(const std::string& option, const std::string& text, std::size_t least, std::size_t most) {
  const auto values = numbers(option, text, 'x');
  const auto is_side = [&](std::size_t side) { return side >= least && side <= most; };
  if (values.size() != 2 || !is_side(values[0]) || !is_side(values[1])) {
    refuse(option, "expected WxH, each from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return {static_cast<int>(values[0]), static_cast<int>(values[1])};
}

void set_cover_size(culler::CoverOptions& options, const std::string& text) {
  const PictureSize size = parse_size("--cover-size", text, culler::kLeastCoverSide, culler::kMostCoverSide);
  options.width = size.width;
  options.height = size.height;
}

void WalkArguments::add_size_to(Command command) {
  command.add("--size", size_, "WxH, size of the pictures in pixels").show_default();
}

Option WalkArguments::add_frames_to(Command command) {
  return command
      .add("--frames", frames_, "A:B:STEP, frames A, A+STEP, ... below B, or all; frames between them are only culled")
      .show_default();
}

void WalkArguments::add_hold_to(Command command, Option region) {
  constexpr double kShortest = 1e-9, kLongest = 1e9;
  command
      .add(
          "--hold", hold_,
          "cull for regions of eyes that reach so far ahead, in units of the model, and draw what the region leaves in each "
          "frame that it holds for")
      .in_range(kShortest, kLongest)
      .excludes(region);
}

std::vector<Option> ReadArguments::add_to(Command command) {
  added_ = {
      command.add_flag("--opaque-all", is_opaque_all_,
                       "take all surfaces for opaque: glass, and what else lets light through, hides what is behind it"),
      command
          .add("--up", up_,
               "axis of the file that is up: x, y, z, -x, -y, -z, or file for the one that it says; turns the model so that "
               "it is z (default: coordinates are those of the file)")
          .check([](const std::string& text) { return fault_of(text, render::parse_up, "x, y, z, -x, -y, -z"); }),
      command
          .add("--unit", unit_,
               "unit of the file: m, km, cm, mm, in, ft, a number of metres, or file for the one that it says; converts the "
               "model to metres (default: coordinates are those of the file)")
          .check(
              [](const std::string& text) { return fault_of(text, render::parse_unit, "m, km, cm, mm, in, ft, metres"); })};
  return added_;
}

render::ReadOptions ReadArguments::options(const std::string& model) const {
  require_settled(added_, model);
  render::ReadOptions options{is_opaque_all_, {!unit_.empty(), !up_.empty()}};
  options.conversion.file.metres = render::parse_unit(unit_).value_or(0);
  options.conversion.file.up = render::parse_up(up_).value_or(glm::dvec3(0));
  return options;
}

std::vector<Option> BuildArguments::add_to(Command command) {
  return {choice(command, "--bounds", bounds_, {"aabb", "obb"},
                 "bounding volumes of the hierarchy: axis-aligned boxes, or oriented ones"),
          command.add("--leaf", leaf_, "most polygons in a leaf of the hierarchy (default: 4; for frusta 16)")
              .in_range(std::size_t{1}, std::size_t{4096}),
          choice(command, "--shapes", shapes_, {"polytope", "polygon"},
                 "shapes of occluders: closed convex shells and flat polygons, or flat polygons only"),
          choice(command, "--regions", regions_, {"grid", "tree"},
                 "regions of space that list occluders: cubes of one size, or the nodes of the hierarchy")};
}

culler::BuildConfig BuildArguments::config(culler::Method method) const {
  culler::BuildConfig config;
  config.hierarchy.leaf_size = leaf_ != 0 ? leaf_ : culler::leaf_size_for(method);
  config.hierarchy.bounds = bounds_ == "obb" ? culler::Bounds::obb : culler::Bounds::aabb;
  config.occluders.shells = shapes_ == "polytope";
  config.lists.kind = regions_ == "tree" ? culler::RegionKind::tree : culler::RegionKind::grid;
  return config;
}

std::vector<Option> WalkArguments::add_culling_to(Command command) {
  std::vector<Option> options;
  const auto append = [&](const std::vector<Option>& more) { options.insert(options.end(), more.begin(), more.end()); };
  append(add_common_to(command));
  command.under(kTuning, [&] {
    build_options_ = build_.add_to(command);
    append(build_options_);
    append(add_tuning_to(command));
    for (const Option budget : add_budgets(command, cull_.cover)) options.push_back(of_cover(budget));
  });
  command.under(kDebugging, [&] { append(add_debugging_to(command)); });
  return options;
}

namespace {

culler::Method method_named(const std::string& name) {
  return *std::ranges::find_if(render::kMethods, [&](culler::Method method) { return render::name_of(method) == name; });
}

}  // namespace

Option WalkArguments::of_frusta(Option option) {
  options_of_frusta_.push_back(option);
  return option;
}

Option WalkArguments::of_cover(Option option) {
  options_of_cover_.push_back(option);
  return option;
}

culler::Method WalkArguments::method() const {
  if (has_method()) return method_named(method_);
  const bool is_about_frusta = std::ranges::any_of(options_of_frusta_, &Option::is_given);
  return is_about_frusta ? culler::Method::frusta : default_method_;
}

std::vector<Option> WalkArguments::add_common_to(Command command) {
  constexpr std::size_t kMostOccluders = 4096;  // each costs one test at every node that it does not decide
  return {
      add_frames_to(command),
      command
          .add("--method", method_,
               "automatic: cover, as far as it pays; frusta: the shadows of a few chosen occluders, as in the paper; cover: "
               "the "
               "joined shadows of all visible polygons, in a coarse picture (default: " +
                   std::string(render::name_of(default_method_)) + ", or frusta if an option is given that only they have)")
          .one_of({"automatic", "frusta", "cover"}),
      of_frusta(command.add("--occluders", cull_.occluders, "occluders per frame; 0: view-frustum culling alone")
                    .show_default()
                    .in_range(std::size_t{0}, kMostOccluders)),
  };
}

std::vector<Option> add_budgets(Command command, culler::CoverOptions& cover) {
  constexpr double kLongest = 1e9;  // milliseconds, eleven days
  return {
      command
          .add("--budget-work", cover.work,
               "most work of a cull by cover: boxes asked, and 16 for each triangle drawn into the coarse picture; the same "
               "on "
               "every machine (default: no limit)")
          .not_negative(),
      command
          .add("--budget-ms", cover.ms,
               "most milliseconds of a cull by cover, about; what is left is drawn unasked (default: no limit)")
          .in_range(0, kLongest)};
}

std::vector<Option> WalkArguments::add_tuning_to(Command command) {
  constexpr std::size_t kMostProbes = 4096;
  constexpr double kLargestMargin = kLargestSide;
  constexpr double kLargestWeight = 16;  // powers of ratios of a thousand stay within the range of double
  const auto weight = [&](const char* name, double& value, const char* text) {
    return of_frusta(command.add(name, value, text).show_default().in_range(0, kLargestWeight));
  };
  culler::Objective& objective = cull_.objective;
  return {
      of_cover(command.add("--cover-size", cover_size_, "WxH, size of the coarse picture in pixels, each from 64 to 4096")
                   .show_default()),
      of_frusta(
          command
              .add("--probes", cull_.probes, "candidates per frame for which the polygons that they would hide are counted")
              .show_default()
              .in_range(std::size_t{0}, kMostProbes)),
      of_frusta(choice(command, "--solid-angle", angle_, {"area", "exact"},
                       "solid angle of an occluder: the area-angle estimate, or exact")),
      weight("--weight-solid-angle", objective.solid_angle, "exponent of this criterion in the choice of occluders; 0: off"),
      weight("--weight-depth-complexity", objective.depth_complexity,
             "the same for the depth complexity sampled by a preprocess"),
      weight("--weight-coherence", objective.coherence, "the same for the polygons hidden in the previous frames"),
      of_frusta(command.add_flag("--unions", cull_.unions,
                                 "also use pairs of occluders that share an edge, for boxes that neither hides alone")),
      command
          .add("--pixel-margin", pixel_margin_,
               "pixels by which shadows shrink, so that the renderer's rounding cannot show a culled polygon; 0: all "
               "that is exactly hidden may be culled")
          .show_default()
          .in_range(0, kLargestMargin),
  };
}

std::vector<Option> WalkArguments::add_debugging_to(Command command) {
  return {
      of_frusta(choice(command, "--near", near_, {"surface", "farthest"},
                       "start of a shadow: at the occluder, or at its farthest vertex (as in the paper)")),
      choice(command, "--arithmetic", arithmetic_, {"certified", "plain"},
             "exact, or the paper's double arithmetic (for measurements)"),
      of_frusta(choice(command, "--test", test_, {"conservative", "overlap"},
                       "test against planes only, or decide all three relations")),
  };
}

Option WalkArguments::add_model_to(Command command) {
  read_.add_to(command);
  std::vector<Option> added;
  command.under(kTuning, [&] {
    added.push_back(add_input(command, "--preprocess", preprocess_, "store of this model, by `occlude preprocess`"));
  });
  for (Option option : build_options_) added.front().excludes(option);
  build_options_.push_back(added.front());
  return added.front();
}

void WalkArguments::warn_of_unused() const {
  if (!has_method()) return;  // then it is one that has them, or all are compared
  for (const Option& option : method() == culler::Method::frusta ? options_of_cover_ : options_of_frusta_) {
    if (option.is_given()) warn(option.name(), fmt::format("does nothing by {}", method_));
  }
}

render::WalkOptions WalkArguments::options(const std::string& model) const {
  render::WalkOptions all = options();
  require_settled(build_options_, model);
  all.read = read_.options(model);
  warn_of_unused();
  return all;
}

render::WalkOptions WalkArguments::options() const {
  render::WalkOptions options;
  parse_frames(frames_, options);
  const PictureSize size = parse_size("--size", size_, 1, kLargestSide);
  options.width = size.width;
  options.height = size.height;
  options.cull = cull_;
  options.hold = hold_;
  options.cull.method = method();
  set_cover_size(options.cull.cover, cover_size_);
  options.cull.margin = culler::margin_for(options.height, pixel_margin_);
  options.cull.objective.angle = angle_ == "exact" ? culler::Objective::Angle::exact : culler::Objective::Angle::area;
  options.preprocess = preprocess_;
  options.cull.shadow_near = near_ == "surface" ? kernel::Near::surface : kernel::Near::farthest;
  options.cull.arithmetic = arithmetic_ == "certified" ? kernel::Arithmetic::certified : kernel::Arithmetic::plain;
  options.build = build_.config(options.cull.method);
  options.cull.test = test_ == "overlap" ? kernel::Test::overlap : kernel::Test::conservative;
  return options;
}

std::vector<Option> PartsArguments::add_to(Command command, const std::string& name) {
  name_ = name;
  return {
      add_output(command, "--parts", folder_,
                 "folder to keep finished parts in, sealed, until all are done; under mpirun, and to --resume, occlude_" +
                     name + "_parts if none is named"),
      command.add_flag("--resume", resume_, "go on with the parts that a run with the same options has left there")};
}

render::Keeping PartsArguments::keeping() const {
  const bool is_kept = resume_ || render::ranks() > 1;
  return {folder_.empty() && is_kept ? "occlude_" + name_ + "_parts" : folder_, resume_};
}

std::uint64_t whole_number(const std::string& option, const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && next == end) return value;
  double number = 0;  // 1e8 is accepted too
  const auto [rest, fault] = std::from_chars(text.data(), end, number);
  const bool is_whole =
      fault == std::errc() && rest == end && number >= 0 && number <= 0x1p53 && number == std::floor(number);
  if (!is_whole) refuse(option, "'" + text + "' is not a whole number, or too large");
  return static_cast<std::uint64_t>(number);
}

std::string check_named(const std::string& file) { return file.empty() ? "it is empty" : ""; }

Option add_input(Command command, const char* name, std::string& file, const char* text) {
  return command.add(name, file, text).check(check_named).each(render::keep_input);
}

Option add_inputs(Command command, const char* name, std::vector<std::string>& files, const char* text) {
  return command.add(name, files, text).check(check_named).each(render::keep_input);
}

Option add_output(Command command, const char* name, std::string& path, const std::string& text) {
  return command.add(name, path, text).check(check_named);
}
Option add_output(Command command, const char* name, std::string& path, const std::string& text, const char* extension) {
  static constexpr std::array<std::string_view, 17> kOthers{".bmp",  ".csv",  ".dae",  ".fbx", ".gif",  ".glb",
                                                            ".gltf", ".html", ".jpeg", ".jpg", ".json", ".obj",
                                                            ".pdf",  ".ply",  ".png",  ".stl", ".svg"};
  return add_output(command, name, path, text).check([extension](const std::string& file) -> std::string {
    std::string ends = std::filesystem::path(file).extension().string();
    for (char& c : ends) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ends == extension || std::ranges::find(kOthers, ends) == kOthers.end()) return "";
    return fmt::format("{}: what is written is no {} file: let the name end in {}", file, ends, extension);
  });
}

void warn(const std::string& file, const std::string& doubt) {
  if (doubt.empty()) return;
  const render::Paint paint(STDERR_FILENO);
  render::say(paint(render::Colour::yellow, "occlude: warning:") + " " + render::printable(file + ": " + doubt) + "\n");
}

render::Model read_model(const std::string& file, const render::ReadOptions& options) {
  render::Model model = render::read_model(file, options);
  warn(file, render::text_of(model.notes));
  return model;
}

render::ModelFile open_model(const std::string& file, const render::WalkOptions& options) {
  render::ModelFile model(file, options.read);
  warn(file, render::text_of(model.notes));
  return model;
}

render::Digest& add(render::Digest& digest, culler::SoupView soup) {
  return digest.add(soup.vertices).add(soup.indices).add(soup.first).add(soup.faces).add(soup.see_through);
}

std::string formats_help() {
  return "Models:\n"
         "  format             numbers  kept beside polygons                        not kept\n"
         "  PLY                doubles  strips of triangles                         all else\n"
         "  OBJ, MTL           doubles  weights of vertices; glass (d, Tr, map_d)   curves, points, lines\n"
         "  glTF 2.0           doubles  placements, instances, quantised, sparse    animations, points, lines;\n"
         "                              and compressed numbers (Draco, meshopt);    what else the file requires\n"
         "                              morph targets and skins at rest; glass      is refused\n"
         "  COLLADA, FBX, 3DS, floats   placements; glass                           animations, skins, points,\n"
         "  STL, OFF, 3MF, ...                                                      lines, holes in COLLADA\n"
         "Coordinates are those of the file; --up and --unit turn the model so that z is up, and convert it to metres.";
}

std::string limits_help() {
  return fmt::format(
      "Limits: at most {} for a JSON file or a line of JSON Lines, {} for any other file.\n"
      "The import library (formats other than PLY and OBJ) may use\n"
      "{}.\n"
      "A command may use at most three quarters of the machine's memory.",
      render::in_mebibytes(render::kMostJson), render::in_mebibytes(render::kMostBytes), render::import_limits());
}

}  // namespace occlude::cli
