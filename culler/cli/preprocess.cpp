// SPDX-License-Identifier: MIT
// occlude preprocess: finds out once what every walk through a model can use, and occluders for engines.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "frame/culler_access.h"
#include "frame/sampling.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/inner_boxes.h"
#include "occlude/culler/simplified_occluders.h"
#include "occlude/render/console.h"
#include "occlude/render/digest.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/job.h"
#include "occlude/render/model_io.h"
#include "occlude/render/output_file.h"
#include "occlude/render/packing.h"
#include "occlude/render/progress.h"
#include "occlude/render/range_parts.h"
#include "occlude/render/ranks.h"
#include "occlude/render/stopwatch.h"
#include "occlude/render/store.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

using nlohmann::ordered_json;

struct PreprocessArguments {
  std::string model, out, inner_boxes, occluders, pattern = "even", seed = "1";
  ReadArguments read;
  BuildArguments build;
  culler::ListConfig lists;
  culler::SampleConfig samples;
  culler::InnerBoxOptions boxes;
  culler::SimplifyOptions simple;
  PathArguments path;
  bool with_boxes = false, json = false;
  PartsArguments parts;
  std::string given;  ///< the options on which the samples depend
};

/// What is told about a file that was made.
struct Summary {
  std::string line;
  ordered_json json;
};

/// Throws PartError unless there are so many numbers, each the mean of how many polygons something hides.
void require_hidden(const std::vector<float>& hidden, std::uint64_t count, std::size_t polygons) {
  render::require_part(hidden.size() == count, "its numbers are not as many as its regions list occluders");
  const auto is_mean = [most = static_cast<float>(polygons)](float mean) { return mean >= 0 && mean <= most; };
  render::require_part(std::ranges::all_of(hidden, is_mean), "something hides fewer polygons than none, or more than all");
}

/// Samples the regions in parts. Returns `hidden` of OccluderLists::Stored, on the first rank; the others have only helped.
std::vector<float> sample(render::Job& job, const culler::Culler& culler, const culler::SampleConfig& samples) {
  constexpr std::size_t kParts = 256;
  culler.prepare(culler::Method::frusta, render::check_interrupt);
  const culler::OccluderLists& lists = occluders_of(culler).lists();
  const std::size_t polygons = culler.hierarchy().soup().size();
  const std::size_t regions = lists.partition().regions();
  render::RangeParts parts(regions, (regions + kParts - 1) / kParts);
  render::Progress progress("region", regions);
  std::vector<float> hidden;
  const auto work = [&](const std::string& part) {
    const auto [first, end] = parts.of(part);
    return render::Packer().put(culler::sample_regions(culler, samples, first, end, render::check_interrupt)).bytes();
  };
  const auto take = [&](const std::string& result) {
    render::Unpacker unpacker(result);
    const std::vector<float> part = unpacker.list<float>();
    unpacker.finish();
    const auto [first, end] = parts.take();
    require_hidden(part, lists.stored().first[end] - lists.stored().first[first], polygons);
    hidden.insert(hidden.end(), part.begin(), part.end());
    progress.update(end);
  };
  job.run({[&] { return parts.next(); }, work, take});
  return hidden;
}

render::Job job_of(const PreprocessArguments& arguments, culler::SoupView soup) {
  return {arguments.samples.viewpoints > 0 && !arguments.out.empty() ? arguments.parts.keeping() : render::Keeping{}, [&] {
            render::Digest digest;
            return add(digest.add(arguments.given), soup).value();
          }};
}

culler::Culler find_out(render::Job& job, const culler::PolygonSoup& soup, const PreprocessArguments& arguments,
                        const culler::BuildConfig& config) {
  culler::Culler culler(soup, config, render::check_interrupt);
  if (arguments.samples.viewpoints == 0) return culler;
  return with_hidden(culler, sample(job, culler, arguments.samples));
}

Summary make_store(render::OutputFile& file, render::Job& job, const culler::PolygonSoup& soup,
                   const PreprocessArguments& arguments, const culler::BuildConfig& config) {
  const render::Stopwatch stopwatch;
  const culler::Culler culler = find_out(job, soup, arguments, config);
  for (const auto method : {culler::Method::frusta, culler::Method::cover}) culler.prepare(method, render::check_interrupt);
  const double seconds = stopwatch.seconds();
  render::check_interrupt();
  render::write_store(file, culler);
  file.close();
  const std::size_t nodes = culler.hierarchy().nodes().size();
  const culler::OccluderLists::Stored& lists = occluders_of(culler).lists().stored();
  const auto hide = std::ranges::count_if(lists.hidden, [](float hidden) { return hidden > 0; });
  const std::string sampled = lists.hidden.empty() ? "" : fmt::format(", {} of them found to hide something", hide);
  return {fmt::format("{}: {} polygons, {} nodes; {} regions list {} occluders{}; {:.1f} s\n", arguments.out, soup.size(),
                      nodes, lists.first.size() - 1, lists.occluders.size(), sampled, seconds),
          {{"polygons", soup.size()},
           {"nodes", nodes},
           {"regions", lists.first.size() - 1},
           {"listed", lists.occluders.size()},
           {"found_to_hide", lists.hidden.empty() ? ordered_json() : ordered_json(hide)},
           {"seconds", seconds}}};
}

Summary make_inner_boxes(render::OutputFile& file, culler::SoupView soup, const PreprocessArguments& arguments) {
  const render::Stopwatch stopwatch;
  const culler::InnerBoxes found = [&] {
    render::Watch watch("part");
    return culler::find_inner_boxes(soup, arguments.boxes, std::ref(watch), render::check_interrupt);
  }();
  const double seconds = stopwatch.seconds();
  render::write_ply(file, culler::soup_of(found.boxes), "boxes inside the closed parts of a model");
  file.close();
  return {
      fmt::format("{}: parts {}, closed {}, with inner boxes {}; boxes {}, of which the first of each part fill {:.0f} % "
                  "of the closed parts' own boxes; {:.1f} s\n",
                  arguments.inner_boxes, found.parts, found.closed_parts, found.filled_parts, found.boxes.size(),
                  100 * found.share, seconds),
      {{"parts", found.parts},
       {"closed_parts", found.closed_parts},
       {"filled_parts", found.filled_parts},
       {"boxes", found.boxes.size()},
       {"share", found.share},
       {"seconds", seconds}}};
}

/// That of the pictures of a walk, unless it is told otherwise.
constexpr double kAspect = 16.0 / 9.0;

Summary make_occluders(render::OutputFile& file, const render::Model& model, const PreprocessArguments& arguments) {
  const render::Stopwatch stopwatch;
  std::vector<culler::Camera> views;
  if (arguments.path.is_given()) {
    const render::CameraPath path = arguments.path.through(arguments.model, model);
    warn_of_misfit(path, arguments.path, arguments.model, model.soup);
    views = path.views(kAspect);
  }
  culler::SimplifyOptions options = arguments.simple;
  options.views = views;
  if (arguments.with_boxes) options.boxes = arguments.boxes;
  std::optional<render::ShownStage> stage("making occluders");
  const culler::SimplifiedOccluders found = simplified_occluders(model.soup, options, render::check_interrupt);
  stage.reset();
  const double seconds = stopwatch.seconds();
  render::write_ply(file, found.soup, "occluders made of a model");
  file.close();
  return {fmt::format("{}: of {} triangles that are drawn {} do for all; {} chosen, with faces of {} boxes; {:.1f} s\n",
                      arguments.occluders, found.drawn_triangles, found.flat_triangles, found.soup.size(),
                      found.boxes.size(), seconds),
          {{"drawn_triangles", found.drawn_triangles},
           {"flat_triangles", found.flat_triangles},
           {"triangles", found.soup.size()},
           {"boxes", found.boxes.size()},
           {"seconds", seconds}}};
}

void preprocess(PreprocessArguments& arguments) {
  culler::BuildConfig config = arguments.build.config();
  arguments.lists.kind = config.lists.kind;
  config.lists = arguments.lists;
  arguments.samples.seed = whole_number("--seed", arguments.seed);
  arguments.samples.pattern =
      arguments.pattern == "random" ? culler::SampleConfig::Pattern::random : culler::SampleConfig::Pattern::even;
  // Others than the first rank help to sample.
  const bool is_first = render::is_first_rank();
  if (!is_first && (arguments.out.empty() || arguments.samples.viewpoints == 0)) return;
  std::optional<render::OutputFile> file, box_file, occluder_file;
  if (is_first && !arguments.out.empty()) file.emplace(arguments.out);
  if (is_first && !arguments.inner_boxes.empty()) box_file.emplace(arguments.inner_boxes);
  if (is_first && !arguments.occluders.empty()) occluder_file.emplace(arguments.occluders);
  const render::Model model = read_model(arguments.model, arguments.read.options(arguments.model));
  const culler::PolygonSoup& soup = model.soup;

  render::Job job = job_of(arguments, soup);
  if (!is_first) {
    static_cast<void>(sample(job, culler::Culler(soup, config, render::check_interrupt), arguments.samples));
    return;
  }
  Summary told{"", {{"polygons", soup.size()}}};
  const auto tell_too = [&](const char* member, const Summary& more) {
    told.line += more.line;
    told.json[member] = more.json;
  };
  if (file) told = make_store(*file, job, soup, arguments, config);
  if (box_file) tell_too("inner_boxes", make_inner_boxes(*box_file, soup, arguments));
  if (occluder_file) tell_too("occluders", make_occluders(*occluder_file, model, arguments));
  {
    const render::Uninterrupted together;
    if (file) file->commit();
    if (box_file) box_file->commit();
    if (occluder_file) occluder_file->commit();
  }
  job.finish();
  if (file) told.json["bytes"] = std::filesystem::file_size(arguments.out);
  if (arguments.json) {
    render::print(told.json.dump(2) + "\n");
  } else {
    render::tell(told.line);
  }
}

}  // namespace

void add_preprocess(Command app, int&) {
  Command command = app.add_command("preprocess", "Prepare a model once: write a store that commands open at once");
  command.footer(
      "The store holds the model and all that culling it needs: the tree, what can hide, the occluders that each region of\n"
      "space lists, and what they hide as sampled there. Commands take it in place of the model, and cull its first frame\n"
      "without reading or preparing anything else. It is checked when it is opened: no store leads to a wrong cull, but "
      "one\n"
      "with oriented boxes (--bounds obb), which is as good as who made it.\n"
      "\n"
      "Inner boxes are occluders for engines: they lie exactly inside of the closed parts of the model, and hide nothing\n"
      "wrongly from eyes outside of these parts. So do the occluders of --occluders, with a budget of triangles: they lie\n"
      "exactly on the model, and hide nothing wrongly from any eye, but for those --with-boxes or --inset.\n" +
      limits_help() +
      "\n"
      "Example: occlude preprocess city.ply --out city.pre --inner-boxes boxes.ply\n"
      "Example: occlude preprocess city.ply --occluders few.ply --triangles 5000 --path city.json");
  const auto a = std::make_shared<PreprocessArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ...").required();
  Command outputs = command.add_any_of("Outputs", "one of these or more");
  add_output(outputs, "--out", a->out, "file to write");
  const Option inner_boxes = add_output(outputs, "--inner-boxes", a->inner_boxes,
                                        "PLY to write: boxes inside of the closed parts, six quadrilaterals each", ".ply");
  const Option occluders = add_output(outputs, "--occluders", a->occluders,
                                      "PLY to write: triangles on the model that hide in its place, the best first", ".ply");
  a->read.add_to(command);
  a->build.add_to(command);
  command.add("--region-count", a->lists.regions, "number of regions aimed at; of a tree the most")
      .show_default()
      .in_range(1.0, 1e7);
  command.add("--threshold", a->lists.threshold, "steradians above which a region lists an occluder")
      .show_default()
      .in_range(1e-6, 10.0);
  command
      .add("--entries", a->lists.entries,
           "most entries of all lists together; where there would be more, the longest keep what looks largest")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1} << 30U);
  command.add("--samples", a->samples.viewpoints, "viewpoints sampled in each region: minutes for a large model")
      .show_default()
      .in_range(std::size_t{0}, std::size_t{1000});
  command.add("--pattern", a->pattern, "how viewpoints are spread").show_default().one_of({"even", "random"});
  command.add("--seed", a->seed, "whole number; same seed, same viewpoints, on any machine").show_default();
  command.add("--boxes", a->boxes.boxes, "inner boxes of a part at most")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{64})
      .needs(inner_boxes);
  command.add("--cells", a->boxes.cells, "cells along each axis of a part, of the grid in which inner boxes are looked for")
      .show_default()
      .in_range(std::size_t{3}, std::size_t{64})
      .needs(inner_boxes);
  command.add("--triangles", a->simple.triangles, "occluders at most")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1} << 30U)
      .needs(occluders);
  a->path.add_to(command, "in which the occluders are to hide most", "those with the largest area are chosen")
      .needs(occluders);
  command
      .add_flag("--with-boxes", a->with_boxes,
                "choose among faces of inner boxes, too: where no eye gets into a closed part")
      .needs(occluders);
  command
      .add("--inset", a->simple.inset,
           "merge what is flat up to so many metres, inside of closed parts: where no eye gets into one; 0: what is exactly "
           "so")
      .show_default()
      .in_range(0.0, 1e3)
      .needs(occluders);
  command.add_flag("--json", a->json, "print the counts as JSON");
  a->parts.add_to(command, "preprocess");
  command.run_on_all_ranks([a, command] {
    a->given =
        command.given_but({"MODEL", "--out", "--inner-boxes", "--boxes", "--cells", "--occluders", "--triangles", "--path",
                           "--matrix-order", "--with-boxes", "--inset", "--json", "--quiet", "--parts", "--resume"});
    preprocess(*a);
  });
}

}  // namespace occlude::cli
