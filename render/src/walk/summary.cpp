// SPDX-License-Identifier: MIT
#include "summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <thread>

#include "means.h"
#include "occlude/render/machine.h"
#include "occlude/render/printable.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

template <class Member>
std::size_t total(const WalkResult& result, Member&& member) {
  std::size_t sum = 0;
  for (const FrameRecord& record : result.frames) sum += member(record);
  return sum;
}

Json operations(const kernel::Operations& counted) {
  const double tests = counted.tests == 0 ? 1 : static_cast<double>(counted.tests);
  const auto each = [&](std::uint64_t count) { return static_cast<double>(count) / tests; };
  return {{"tests", counted.tests},
          {"dot_per_test", each(counted.dot)},
          {"scalar_per_test", each(counted.scalar)},
          {"vector_per_test", each(counted.vector)},
          {"cross_per_test", each(counted.cross)}};
}

/// Null where there is no limit.
template <class Number>
Json if_limited(Number most) {
  const bool is_limited = most < std::numeric_limits<Number>::max();
  return is_limited ? Json(most) : Json();
}

}  // namespace

Json options_json(const WalkOptions& options, const culler::BuildConfig& build) {
  const culler::Objective& objective = options.cull.objective;
  return {{"size", {options.width, options.height}},
          {"cover_size", {options.cull.cover_width, options.cull.cover_height}},
          {"cover_triangles", if_limited(options.cull.cover_triangles)},
          {"budget_ms", if_limited(options.cull.cover_ms)},
          {"leaf", build.hierarchy.leaf_size},
          {"occluders", options.cull.occluders},
          {"probes", options.cull.probes},
          {"solid_angle", objective.angle == culler::Objective::Angle::exact ? "exact" : "area"},
          {"weights",
           {{"solid_angle", objective.solid_angle},
            {"depth_complexity", objective.depth_complexity},
            {"coherence", objective.coherence}}},
          {"pixel_margin", options.cull.margin * options.height},
          {"near", options.cull.near == kernel::Near::surface ? "surface" : "farthest"},
          {"arithmetic", options.cull.arithmetic == kernel::Arithmetic::certified ? "certified" : "plain"},
          {"test", options.cull.test == kernel::Test::overlap ? "overlap" : "conservative"},
          {"bounds", build.hierarchy.bounds == culler::Bounds::obb ? "obb" : "aabb"},
          {"shapes", build.occluders.shells ? "polytope" : "polygon"},
          {"unions", options.cull.unions},
          {"preprocess", options.preprocess.empty() ? Json(nullptr) : Json(printable(options.preprocess.native()))}};
}

Json machine_json(const std::string& renderer) {
  return {{"processor", processor_name()},
          {"threads", std::thread::hardware_concurrency()},
          {"renderer", renderer.empty() ? Json(nullptr) : Json(renderer)},
          {"compiler", compiler_name()}};
}

std::string table2_text(const Json& summary) {
  const Json& mean = summary["mean"];
  const auto fps = [](const Json& ms) {
    return ms.is_null() ? std::string("-") : fmt::format("{:.1f}", 1000 / ms.get<double>());
  };
  const auto percent = [](const Json& ratio) {
    return ratio.is_null() ? std::string("-") : fmt::format("{:+.0f} %", 100 * (ratio.get<double>() - 1));
  };
  return fmt::format(
      "Table 2, averages per frame           this run           the paper (1997)\n"
      "                                  polygons      fps      polygons      fps\n"
      "view-frustum culling            {:>10.0f} {:>8}        49,196      3.6\n"
      "with occlusion culling          {:>10.0f} {:>8}        29,749      5.6\n"
      "drawing only what shows         {:>10} {:>8}             -        -\n"
      "polygons culled                 {:>9.1f} %                 39.5 %\n"
      "speedup                         {:>19}                      +55 %\n"
      "  limit by polygons drawn       {:>19}                      +65 %\n",
      mean["view_frustum_polygons"].get<double>(), fps(mean["frame_ms_view_frustum_only"]),
      mean["rendered_polygons"].get<double>(), fps(mean["frame_ms"]),
      mean["visible_polygons"].is_null() ? "-" : fmt::format("{:.0f}", mean["visible_polygons"].get<double>()),
      fps(mean["frame_ms_visible_only"]), 100 * summary["culled_share"].get<double>(), percent(summary["speedup"]),
      percent(summary["speedup_limit"]["polygons"]));
}

Json summarise(const WalkResult& result, const WalkOptions& options, const std::string& model) {
  const bool rendered = options.render;
  const auto if_rendered = [&](auto value) { return rendered ? Json(value) : Json(nullptr); };
  const auto mean_of = [&](auto member) { return mean(result, member); };
  const auto total_of = [&](auto member) { return total(result, [&](const FrameRecord& r) { return r.*member; }); };

  const double viewed = mean_of(&FrameRecord::view_frustum_polygons), drawn = mean_of(&FrameRecord::rendered_polygons);
  const double visible = mean_of(&FrameRecord::visible_polygons);
  const double viewed_ms = mean_of(&FrameRecord::view_frustum_frame_ms), frame_ms = mean_of(&FrameRecord::frame_ms);
  const double hidden = mean_hidden(result);

  Json json;
  json["model"] = model;
  json["polygons"] = result.polygons;
  json["triangles"] = result.triangles;
  json["frames"] = result.frames.size();
  json["method"] = options.cull.method == culler::Method::cover ? "cover" : "frusta";
  json["options"] = options_json(options, result.build);
  json["mean"] = {{"view_frustum_polygons", viewed},
                  {"rendered_polygons", drawn},
                  {"visible_polygons", if_rendered(visible)},
                  {"hidden_polygons", if_rendered(hidden)},
                  {"occluders", mean_of(&FrameRecord::occluders)},
                  {"candidates", mean(result, [](const FrameRecord& r) { return r.stats.occluders_in_view; })},
                  {"sort_moves", mean(result, [](const FrameRecord& r) { return r.stats.sort_moves; })},
                  {"cull_ms", mean_of(&FrameRecord::cull_ms)},
                  {"witness_ms", mean_of(&FrameRecord::witness_ms)},
                  {"frame_ms", if_rendered(frame_ms)},
                  {"frame_ms_view_frustum_only", if_rendered(viewed_ms)},
                  {"frame_ms_visible_only", if_rendered(mean_of(&FrameRecord::visible_frame_ms))}};
  json["culled_share"] = viewed == 0 ? 0 : 1 - drawn / viewed;
  json["culled_share_of_hidden"] = if_rendered(hidden == 0 ? 0 : (viewed - drawn) / hidden);
  json["speedup"] = if_rendered(viewed_ms / frame_ms);
  json["speedup_limit"] = {{"polygons", drawn == 0 ? Json(nullptr) : Json(viewed / drawn)},
                           {"visible", visible == 0 ? Json(nullptr) : if_rendered(viewed / visible)}};
  json["wrong_pixels"] = if_rendered(total_of(&FrameRecord::wrong_pixels));
  json["wrong_pixels_explained_by_snapping"] = if_rendered(total_of(&FrameRecord::snapped_pixels));
  json["false_culls"] = if_rendered(total_of(&FrameRecord::false_culls));
  json["reference_frames"] = result.reference_frames;
  json["witnesses"] = result.witnesses;
  json["operations"] = operations(result.operations);
  json["preprocess_s"] = result.preprocess_s;
  json["machine"] = machine_json(result.renderer);
  return json;
}

std::string frames_csv(const WalkResult& result) {
  std::string csv =
      "frame,view_frustum_polygons,rendered_polygons,visible_polygons,view_frustum_cull_ms,view_frustum_frame_ms,cull_ms,"
      "frame_ms,"
      "occluders,potential_occluders,candidates,sort_kept,sort_moves,nodes_visited,view_tests,shadow_tests,probe_tests,"
      "exact_shadow_tests,view_culled_polygons,shadow_"
      "culled_polygons,"
      "wrong_pixels,snapped_pixels,false_culls,cover_tests,cover_triangles,visible_frame_ms\n";
  for (const FrameRecord& r : result.frames) {
    fmt::format_to(std::back_inserter(csv),
                   "{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.4f}\n",
                   r.frame, r.view_frustum_polygons, r.rendered_polygons, r.visible_polygons, r.view_frustum_cull_ms,
                   r.view_frustum_frame_ms, r.cull_ms, r.frame_ms, r.occluders, r.stats.potential_occluders,
                   r.stats.occluders_in_view, r.stats.sort_kept, r.stats.sort_moves, r.stats.nodes_visited,
                   r.stats.view_tests, r.stats.shadow_tests, r.stats.probe_tests, r.stats.exact_shadow_tests,
                   r.stats.view_culled_polygons, r.stats.shadow_culled_polygons, r.wrong_pixels, r.snapped_pixels,
                   r.false_culls, r.stats.cover_tests, r.stats.cover_triangles, r.visible_frame_ms);
  }
  return csv;
}

std::string summary_json(const WalkResult& result, const WalkOptions& options, const std::string& model) {
  return summarise(result, options, model).dump(2) + "\n";
}

std::string summary_text(const WalkResult& result, const WalkOptions& options, const std::string& model) {
  const Json summary = summarise(result, options, model);
  std::string text = table2_text(summary);
  if (options.render) {
    text += fmt::format("false culls {}, wrong pixels {} (of them by the renderer's 1/256-pixel rounding: {})\n",
                        summary["false_culls"].get<std::size_t>(), summary["wrong_pixels"].get<std::size_t>(),
                        summary["wrong_pixels_explained_by_snapping"].get<std::size_t>());
  }
  if (options.witness) text += fmt::format("witnesses {}: {}\n", result.witnesses, printable(options.witness->native()));
  return text;
}

bool passed(const WalkResult& result) {
  return std::all_of(result.frames.begin(), result.frames.end(),
                     [](const FrameRecord& r) { return r.false_culls == 0 && r.wrong_pixels == r.snapped_pixels; });
}

}  // namespace occlude::render
