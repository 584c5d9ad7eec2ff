// SPDX-License-Identifier: MIT
#include "occlude/render/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "occlude/render/paper_report.h"
#include "occlude/render/printable.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

std::size_t total(const WalkResult& result, std::size_t FrameRecord::*member) {
  std::size_t sum = 0;
  for (const FrameRecord& record : result.frames) sum += record.*member;
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

Json exceeded(Summary::AboveLimit above) {
  if (above == Summary::AboveLimit::no) return nullptr;
  return above == Summary::AboveLimit::within_noise ? "within_noise" : "beyond_noise";
}

/// Null if there is no limit.
template <class Number>
Json if_limited(Number most) {
  const bool is_limited = most < std::numeric_limits<Number>::max();
  return is_limited ? Json(most) : Json();
}

/// The spread over the frames of a member of FrameRecord, or of a function of one.
template <class Member>
std::optional<Spread> spread(const WalkResult& result, Worst worst, Member&& member) {
  std::vector<FrameValue> values;
  for (const FrameRecord& record : result.frames) {
    values.push_back({record.frame, static_cast<double>(std::invoke(member, record))});
  }
  return spread_of(std::move(values), worst);
}

double speedup_of(const FrameRecord& record) { return record.view_frustum_frame_ms / record.frame_ms; }

/// Decides by the speedup of each frame over its own limit.
Summary::AboveLimit above_limit(const WalkResult& result, const Summary& summary) {
  if (!summary.speedup || !summary.limit_by_polygons || *summary.speedup <= *summary.limit_by_polygons) {
    return Summary::AboveLimit::no;
  }
  std::vector<double> excess;
  for (const FrameRecord& r : result.frames) {
    if (r.rendered_polygons == 0 || r.frame_ms <= 0) continue;
    const double limit = static_cast<double>(r.view_frustum_polygons) / static_cast<double>(r.rendered_polygons);
    excess.push_back(speedup_of(r) / limit);
  }
  std::ranges::sort(excess);
  const std::optional<Interval> median = median_interval(excess);
  return median && median->low > 1 ? Summary::AboveLimit::beyond_noise : Summary::AboveLimit::within_noise;
}

/// None if there are no values.
std::optional<double> mean_value(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Summary::Held held(const WalkResult& result) {
  Summary::Held held;
  std::vector<double> of_regions, of_frames;
  for (const RegionRecord& region : result.regions) of_regions.push_back(region.cull_ms);
  for (const FrameRecord& record : result.frames) {
    if (record.region == 0) {
      ++held.frames_by_point;
    } else if (result.regions[record.region - 1].frame != record.frame) {
      of_frames.push_back(record.cull_ms);
    }
  }
  held.regions = of_regions.size();
  const std::size_t walked = result.frames.back().frame - result.frames.front().frame + 1;
  if (held.regions > 0) held.frames_a_region = static_cast<double>(walked) / static_cast<double>(held.regions);
  held.region_ms = mean_value(of_regions);
  held.frame_ms = mean_value(of_frames);
  return held;
}

std::string held_text(const Summary& summary) {
  const Summary::Held& held = *summary.held;
  const auto ms = [](const std::optional<double>& mean) { return mean ? rounded(*mean, 2) + " ms" : "-"; };
  return fmt::format(
      "held: {} regions that reach {} ahead, one for {:.1f} frames; a region takes {}, a frame between {}; {} of {} frames "
      "by "
      "point\n",
      held.regions, summary.options.hold, held.frames_a_region, ms(held.region_ms), ms(held.frame_ms), held.frames_by_point,
      summary.frames);
}

Json json_of(const Summary::Held& held) {
  return {{"regions", held.regions},
          {"frames_a_region", held.frames_a_region},
          {"frames_by_point", held.frames_by_point},
          {"region_ms", if_known(held.region_ms)},
          {"between_ms", if_known(held.frame_ms)}};
}

}  // namespace

const char* name_of(kernel::Near near) { return near == kernel::Near::surface ? "surface" : "farthest"; }

const char* name_of(kernel::Arithmetic arithmetic) {
  return arithmetic == kernel::Arithmetic::certified ? "certified" : "plain";
}

const char* name_of(kernel::Test test) { return test == kernel::Test::overlap ? "overlap" : "conservative"; }

double mean_hidden(const WalkResult& result) {
  return mean(result, [](const FrameRecord& r) {
    return r.view_frustum_polygons - std::min(r.view_frustum_polygons, r.visible_polygons);
  });
}

Summary summarise(const WalkResult& result, const WalkOptions& options, const std::string& model) {
  const auto if_rendered = [&](auto value) { return options.render ? std::optional(value) : std::nullopt; };
  const auto mean_of = [&](auto member) { return mean(result, member); };
  const auto total_of = [&](auto member) { return total(result, member); };

  Summary summary;
  summary.model = model;
  summary.polygons = result.polygons;
  summary.see_through_polygons = result.see_through_polygons;
  summary.triangles = result.triangles;
  summary.frames = result.frames.size();
  summary.options = options;
  summary.build = result.build;

  const double viewed = mean_of(&FrameRecord::view_frustum_polygons), drawn = mean_of(&FrameRecord::rendered_polygons);
  const double visible = mean_of(&FrameRecord::visible_polygons), hidden = mean_hidden(result);
  const double viewed_ms = mean_of(&FrameRecord::view_frustum_frame_ms), frame_ms = mean_of(&FrameRecord::frame_ms);
  Summary::Mean& mean_figures = summary.mean;
  mean_figures.view_frustum_polygons = viewed;
  mean_figures.rendered_polygons = drawn;
  mean_figures.visible_polygons = if_rendered(visible);
  mean_figures.hidden_polygons = if_rendered(hidden);
  mean_figures.occluders = mean_of(&FrameRecord::occluders);
  mean_figures.candidates = mean_of([](const FrameRecord& r) { return r.stats.occluders_in_view; });
  mean_figures.sort_moves = mean_of([](const FrameRecord& r) { return r.stats.sort_moves; });
  mean_figures.cull_ms = mean_of(&FrameRecord::cull_ms);
  mean_figures.cull_processor_ms = mean_of(&FrameRecord::cull_processor_ms);
  mean_figures.view_frustum_cull_ms = mean_of(&FrameRecord::view_frustum_cull_ms);
  mean_figures.witness_ms = mean_of(&FrameRecord::witness_ms);
  mean_figures.frame_ms = if_rendered(frame_ms);
  mean_figures.frame_ms_view_frustum_only = if_rendered(viewed_ms);
  mean_figures.frame_ms_visible_only = if_rendered(mean_of(&FrameRecord::visible_frame_ms));
  mean_figures.frame_processor_ms = if_rendered(mean_of(&FrameRecord::frame_processor_ms));
  mean_figures.frame_processor_ms_view_frustum_only = if_rendered(mean_of(&FrameRecord::view_frustum_frame_processor_ms));

  summary.spread.cull_ms = spread(result, Worst::most, &FrameRecord::cull_ms);
  summary.spread.cull_processor_ms = spread(result, Worst::most, &FrameRecord::cull_processor_ms);
  if (options.render) {
    summary.spread.frame_ms = spread(result, Worst::most, &FrameRecord::frame_ms);
    summary.spread.frame_processor_ms = spread(result, Worst::most, &FrameRecord::frame_processor_ms);
    summary.spread.speedup = spread(result, Worst::least, speedup_of);
  }

  summary.culled_share = viewed == 0 ? 0 : 1 - drawn / viewed;
  summary.culled_share_of_hidden = if_rendered(hidden == 0 ? 0 : (viewed - drawn) / hidden);
  summary.speedup = if_rendered(viewed_ms / frame_ms);
  if (drawn != 0) summary.limit_by_polygons = viewed / drawn;
  if (visible != 0) summary.limit_by_visible = if_rendered(viewed / visible);
  summary.above_limit = above_limit(result, summary);
  summary.wrong_pixels = if_rendered(total_of(&FrameRecord::wrong_pixels));
  summary.snapped_pixels = if_rendered(total_of(&FrameRecord::snapped_pixels));
  summary.false_culls = if_rendered(total_of(&FrameRecord::false_culls));
  if (options.hold > 0) summary.held = held(result);
  summary.methods = methods_of({{&options, &result}}, options.render);
  if (!result.missed.empty()) {
    summary.missed = {.method = options.cull.method, .frames = result.missed.size(), .counts = {}};
    for (const culler::MissedReasons::Counts& counts : result.missed) summary.missed->counts += counts;
  }
  summary.reference_frames = result.reference_frames;
  summary.witnesses = result.witnesses;
  summary.operations = result.operations;
  summary.preprocess_s = result.preprocess_s;
  summary.region = result.region;
  summary.machine = this_machine(result.renderer);
  summary.load = result.load;
  return summary;
}

std::string limit_note(const Summary& summary) {
  switch (summary.above_limit) {
    case Summary::AboveLimit::no:
      return "";
    case Summary::AboveLimit::within_noise:
      return "The speedup is above its limit by polygons, but within the noise of the times.";
    case Summary::AboveLimit::beyond_noise:
      return "The speedup is above its limit by polygons: that counts all alike, and those culled took longer to draw than "
             "others.";
  }
  return "";
}

std::string busy_note(const Summary& summary) {
  // A cull works on one processor alone and waits for nothing: what it takes beyond its processor time is others' doing.
  constexpr double kMostWait = 1.1;
  std::vector<std::string> signs;
  if (summary.load && *summary.load > summary.machine.threads) {
    signs.push_back(fmt::format("{:.1f} processes wanted to run on its {} threads when the walk began", *summary.load,
                                summary.machine.threads));
  }
  for (const MethodRow& m : summary.methods) {
    if (m.cull_processor_ms && m.cull_ms > kMostWait * *m.cull_processor_ms) {
      signs.push_back(
          fmt::format("culls by {} took {:.2f} times their processor time", m.method, m.cull_ms / *m.cull_processor_ms));
    }
  }
  if (signs.empty()) return "";
  return fmt::format(
      "The machine was busy: {}. Times by the clock are too long; those of the processor are nearer to the truth.",
      fmt::join(signs, "; "));
}

bool passed(const WalkResult& result) {
  return std::all_of(result.frames.begin(), result.frames.end(),
                     [](const FrameRecord& r) { return r.false_culls == 0 && r.wrong_pixels == r.snapped_pixels; });
}

std::string text_of(const Summary& summary, const Paint& paint) {
  std::string text =
      text_of(table_of(summary.methods)) + "\n" + text_of(table2_of(summary)) + "\n" + text_of(spread_table(summary));
  if (const std::string note = limit_note(summary); !note.empty()) text += note + '\n';
  if (const std::string note = busy_note(summary); !note.empty()) text += paint(Colour::yellow, note) + '\n';
  if (summary.held) text += held_text(summary);
  if (summary.options.render) {
    const bool is_right = *summary.false_culls == 0 && *summary.wrong_pixels == *summary.snapped_pixels;
    text += paint(is_right ? Colour::green : Colour::red,
                  fmt::format("false culls {}, wrong pixels {} (of them by the renderer's 1/256-pixel rounding: {})",
                              *summary.false_culls, *summary.wrong_pixels, *summary.snapped_pixels)) +
            '\n';
  }
  for (const MethodRow& m : summary.methods) {
    const bool is_other = m.by && m.method != method_text(summary.options);
    const std::size_t false_culls = m.false_culls.value_or(0), wrong = m.wrong_pixels.value_or(0);
    if (is_other && false_culls + wrong != 0) {
      text += paint(Colour::red,
                    fmt::format("by {}: false culls {}, unexplained wrong pixels {}", m.method, false_culls, wrong)) +
              '\n';
    }
  }
  if (const auto& witness = summary.options.witness) {
    text += fmt::format("witnesses {}: {}\n", summary.witnesses, printable(witness->native()));
  }
  return text;
}

Json json_of(const WalkOptions& options, const culler::BuildConfig& build) {
  const culler::Objective& objective = options.cull.objective;
  return {{"size", {options.width, options.height}},
          {"cover_size", {options.cull.cover.width, options.cull.cover.height}},
          {"budget_work", if_limited(options.cull.cover.work)},
          {"budget_ms", if_limited(options.cull.cover.ms)},
          {"leaf", build.hierarchy.leaf_size},
          {"occluders", options.cull.occluders},
          {"probes", options.cull.probes},
          {"solid_angle", objective.angle == culler::Objective::Angle::exact ? "exact" : "area"},
          {"weights",
           {{"solid_angle", objective.solid_angle},
            {"depth_complexity", objective.depth_complexity},
            {"coherence", objective.coherence}}},
          {"pixel_margin", options.cull.margin * options.height},
          {"near", name_of(options.cull.shadow_near)},
          {"arithmetic", name_of(options.cull.arithmetic)},
          {"test", name_of(options.cull.test)},
          {"bounds", build.hierarchy.bounds == culler::Bounds::obb ? "obb" : "aabb"},
          {"shapes", build.occluders.shells ? "polytope" : "polygon"},
          {"regions", build.lists.kind == culler::RegionKind::tree ? "tree" : "grid"},
          {"unions", options.cull.unions},
          {"hold", options.hold > 0 ? Json(options.hold) : Json()},
          {"preprocess", options.preprocess.empty() ? Json(nullptr) : Json(printable(options.preprocess.native()))}};
}

Json options_of(const Summary& summary) {
  Json options = json_of(summary.options, summary.build);
  options["region"] = summary.region > 0 ? Json(summary.region) : Json();
  return options;
}

Json json_of(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median},
          {"percentile_5", spread->percentile_5},
          {"percentile_95", spread->percentile_95},
          {"worst", spread->worst.value},
          {"worst_frame", spread->worst.frame}};
}

Json json_of(const Summary& summary) {
  const Summary::Mean& mean = summary.mean;
  const std::string busy = busy_note(summary);
  Json json{{"model", summary.model},
            {"polygons", summary.polygons},
            {"see_through_polygons", summary.see_through_polygons},
            {"triangles", summary.triangles},
            {"frames", summary.frames},
            {"method", name_of(summary.options.cull.method)},
            {"options", options_of(summary)},
            {"mean",
             {{"view_frustum_polygons", mean.view_frustum_polygons},
              {"rendered_polygons", mean.rendered_polygons},
              {"visible_polygons", if_known(mean.visible_polygons)},
              {"hidden_polygons", if_known(mean.hidden_polygons)},
              {"occluders", mean.occluders},
              {"candidates", mean.candidates},
              {"sort_moves", mean.sort_moves},
              {"cull_ms", mean.cull_ms},
              {"cull_processor_ms", mean.cull_processor_ms},
              {"view_frustum_cull_ms", mean.view_frustum_cull_ms},
              {"witness_ms", mean.witness_ms},
              {"frame_ms", if_known(mean.frame_ms)},
              {"frame_ms_view_frustum_only", if_known(mean.frame_ms_view_frustum_only)},
              {"frame_ms_visible_only", if_known(mean.frame_ms_visible_only)},
              {"frame_processor_ms", if_known(mean.frame_processor_ms)},
              {"frame_processor_ms_view_frustum_only", if_known(mean.frame_processor_ms_view_frustum_only)}}},
            {"spread",
             {{"cull_ms", json_of(summary.spread.cull_ms)},
              {"cull_processor_ms", json_of(summary.spread.cull_processor_ms)},
              {"frame_ms", json_of(summary.spread.frame_ms)},
              {"frame_processor_ms", json_of(summary.spread.frame_processor_ms)},
              {"speedup", json_of(summary.spread.speedup)}}},
            {"culled_share", summary.culled_share},
            {"culled_share_of_hidden", if_known(summary.culled_share_of_hidden)},
            {"speedup", if_known(summary.speedup)},
            {"speedup_limit",
             {{"polygons", if_known(summary.limit_by_polygons)},
              {"visible", if_known(summary.limit_by_visible)},
              {"exceeded", exceeded(summary.above_limit)}}},
            {"wrong_pixels", if_known(summary.wrong_pixels)},
            {"wrong_pixels_explained_by_snapping", if_known(summary.snapped_pixels)},
            {"false_culls", if_known(summary.false_culls)},
            {"methods", json_of(table_of(summary.methods))},
            {"missed", summary.missed ? json_of(*summary.missed) : Json()},
            {"reference_frames", summary.reference_frames},
            {"witnesses", summary.witnesses},
            {"operations", operations(summary.operations)},
            {"preprocess_s", summary.preprocess_s},
            {"machine", json_of(summary.machine)},
            {"load", if_known(summary.load)},
            {"busy", busy.empty() ? Json() : Json(busy)}};
  if (summary.held) json["held"] = json_of(*summary.held);
  return json;
}

std::string frames_csv(const WalkResult& result) {
  std::string csv =
      "frame,view_frustum_polygons,rendered_polygons,visible_polygons,view_frustum_cull_ms,view_frustum_frame_ms,cull_ms,"
      "frame_ms,"
      "occluders,potential_occluders,candidates,sort_kept,sort_moves,nodes_visited,view_tests,shadow_tests,probe_tests,"
      "exact_shadow_tests,view_culled_polygons,shadow_"
      "culled_polygons,"
      "wrong_pixels,snapped_pixels,false_culls,cover_tests,cover_triangles,visible_frame_ms,occlusion_first,region,"
      "cull_processor_ms,frame_processor_ms,view_frustum_frame_processor_ms\n";
  for (const FrameRecord& r : result.frames) {
    fmt::format_to(std::back_inserter(csv),
                   "{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.4f},{:d},{"
                   "},{:.4f},{:.4f},{:.4f}\n",
                   r.frame, r.view_frustum_polygons, r.rendered_polygons, r.visible_polygons, r.view_frustum_cull_ms,
                   r.view_frustum_frame_ms, r.cull_ms, r.frame_ms, r.occluders, r.stats.potential_occluders,
                   r.stats.occluders_in_view, r.stats.sort_kept, r.stats.sort_moves, r.stats.nodes_visited,
                   r.stats.view_tests, r.stats.shadow_tests, r.stats.probe_tests, r.stats.exact_shadow_tests,
                   r.stats.view_culled_polygons, r.stats.shadow_culled_polygons, r.wrong_pixels, r.snapped_pixels,
                   r.false_culls, r.stats.cover_tests, r.stats.cover_triangles, r.visible_frame_ms, r.is_occlusion_first,
                   r.region, r.cull_processor_ms, r.frame_processor_ms, r.view_frustum_frame_processor_ms);
  }
  return csv;
}

}  // namespace occlude::render
