// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "occlude/render/machine.h"
#include "occlude/render/summary.h"
#include "own_ways.h"
#include "report.h"
#include "visibility.h"

namespace occlude::experiments {
namespace {

using Json = nlohmann::ordered_json;

double cull_over_cover(const VisibilityResult& result, const WayResult& way) {
  return way.cull_ms / way_of(result, kByCover).cull_ms;
}

}  // namespace

render::Table table_of(const VisibilityResult& result, const VisibilityOptions& options) {
  render::Table table{"What is visible, beside other projects",
                      {{"", "project"},
                       {"way", "way"},
                       {"prepared, ms", "prepared_ms"},
                       {"drawn", "drawn"},
                       {"of the hidden culled", "hidden_culled", render::percent},
                       {"false culls", "false_culls"},
                       {"wrong pixels", "wrong_pixels"},
                       {"cull, ms", "cull_ms", render::rounded<2>},
                       {"worst cull, ms", "worst_cull_ms", render::rounded<2>},
                       {"cull, ratio to joined shadows", "cull_over_joined_shadows", render::rounded<2>}},
                      {}};
  for (const WayResult& way : result.ways) {
    table.rows.push_back({way.project, way.name, way.prepare_ms, way.drawn, way.hidden_culled, way.false_culls,
                          way.wrong_pixels, way.cull_ms, way.worst_cull_ms, cull_over_cover(result, way)});
  }
  table.notes = {
      fmt::format("{}: {} polygons in {} leaves of at most {}; {} frames of {}x{}, in each {} polygons in view, {} of them "
                  "hidden.",
                  result.model, render::grouped(static_cast<double>(result.polygons)),
                  render::grouped(static_cast<double>(result.leaves)), options.walk.build.hierarchy.leaf_size, result.frames,
                  options.walk.width, options.walk.height, render::grouped(result.in_view), render::grouped(result.hidden)),
      fmt::format(
          "All draw or leave out whole leaves of one tree, which takes {:.0f} ms to build. What is prepared has it in "
          "ours, and comes on top of it in others.",
          result.tree_ms),
      "False culls: polygons with a pixel in the item buffer of the whole model that were left out, over all frames; wrong "
      "pixels show something else then.",
      fmt::format(
          "Times are of the processor: a cull on one thread, each frame the median of {} rounds; what is prepared, on "
          "all threads.",
          options.repetitions)};
  for (const bench::PeerSummary& rival : result.rivals) {
    table.notes.push_back(fmt::format("{}: {}", rival.name, rival.shown_version()));
  }
  table.notes.push_back(text_of(render::this_machine()) + ".");
  return table;
}

std::string json_of(const VisibilityResult& result, const VisibilityOptions& options) {
  Json pictures = Json::array();
  for (const RayPicture& picture : options.pictures) pictures.push_back({picture.width, picture.height});
  const Json json{
      {"model", result.model},
      {"polygons", result.polygons},
      {"frames", result.frames},
      {"repetitions", options.repetitions},
      {"size", {options.walk.width, options.walk.height}},
      {"rays", pictures},
      {"tree", {{"leaf", options.walk.build.hierarchy.leaf_size}, {"leaves", result.leaves}, {"built_ms", result.tree_ms}}},
      {"mean", {{"view_frustum_polygons", result.in_view}, {"hidden_polygons", result.hidden}}},
      {"ways", json_of(table_of(result, options))},
      {"rivals", bench::json_of(result.rivals)},
      {"machine", json_of(render::this_machine())}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace occlude::experiments
