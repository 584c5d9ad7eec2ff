// SPDX-License-Identifier: MIT
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments.h"
#include "occlude/render/summary.h"

namespace occlude::experiments {
namespace {

using Json = nlohmann::ordered_json;

Json if_known(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json table2_json(const render::Summary& summary) {
  Json json = json_of(summary);
  // Stated once for all experiments; witnesses and operations belong to walks only.
  for (const char* member : {"model", "polygons", "frames", "options", "machine", "witnesses", "operations", "methods"}) {
    json.erase(member);
  }
  return json;
}

/// Figures 2 and 3.
Json frames_json(const std::vector<render::FrameRecord>& frames, bool rendered) {
  const auto each = [&](auto member) {
    Json values = Json::array();
    for (const render::FrameRecord& record : frames) values.push_back(record.*member);
    return values;
  };
  const auto if_rendered = [&](auto member) { return rendered ? each(member) : Json(nullptr); };
  using Record = render::FrameRecord;
  return {{"frame", each(&Record::frame)},
          {"view_frustum_polygons", each(&Record::view_frustum_polygons)},
          {"rendered_polygons", each(&Record::rendered_polygons)},
          {"visible_polygons", if_rendered(&Record::visible_polygons)},
          {"cull_ms", each(&Record::cull_ms)},
          {"frame_ms", if_rendered(&Record::frame_ms)},
          {"frame_ms_view_frustum_only", if_rendered(&Record::view_frustum_frame_ms)},
          {"frame_ms_visible_only", if_rendered(&Record::visible_frame_ms)}};
}

Json figure4_json(const Figure4& figure) {
  Json shares, knees;
  for (const Curve& curve : figure.curves) {
    shares[curve.name] = curve.share;
    knees[curve.name] = curve.knee;
  }
  const auto plain = share_at(figure, "area_angle", 8), all = share_at(figure, "all_three", 8);
  return {{"regions", figure.regions},
          {"occluders", kOccluders},
          {"culled_share", shares},
          {"knee", knees},
          {"all_three_over_area_angle_at_8", plain && all ? Json(*all - *plain) : Json(nullptr)},
          {"sampling_s", if_known(figure.sampling_s)}};
}

Json sweep_json(const std::vector<SweepPoint>& points) {
  Json json = Json::array();
  for (const SweepPoint& p : points) {
    json.push_back({{"regions", p.lists.regions},
                    {"threshold", p.lists.threshold},
                    {"culled_share", p.culled_share},
                    {"listed", p.listed},
                    {"entries", p.entries},
                    {"preprocess_s", p.preprocess_s},
                    {"cull_ms", p.cull_ms},
                    {"cull_ratio", p.cull_ratio}});
  }
  return json;
}

Json sort_json(const Sorting& sorting) {
  Json points = Json::array();
  for (const SortPoint& p : sorting.points) {
    points.push_back({{"threshold", p.threshold},
                      {"candidates", p.candidates},
                      {"arrivals", p.arrivals},
                      {"moves", p.moves},
                      {"comparisons", p.comparisons},
                      {"comparisons_anew", p.comparisons_anew}});
  }
  return {{"points", points},
          {"exponents",
           {{"moves", if_known(sorting.moves_exponent)},
            {"comparisons", if_known(sorting.comparisons_exponent)},
            {"comparisons_anew", if_known(sorting.anew_exponent)}}}};
}

Json joined_json(const std::vector<JoinedPoint>& points) {
  Json json = Json::array();
  for (const JoinedPoint& p : points) {
    const bool is_limited = p.triangles < std::numeric_limits<std::size_t>::max();
    json.push_back({{"cover_size", {p.width, p.height}},
                    {"leaf", p.leaf},
                    {"cover_triangles", is_limited ? Json(p.triangles) : Json(nullptr)},
                    {"culled_share", p.culled_share},
                    {"drawn", p.drawn},
                    {"cull_ms", p.cull_ms}});
  }
  return json;
}

Json threads_json(const std::vector<ThreadsPoint>& points) {
  Json json = Json::array();
  for (const ThreadsPoint& p : points) {
    json.push_back({{"threads", p.threads},
                    {"cull_ms", p.cull_ms},
                    {"speedup", p.speedup},
                    {"most_speedup", p.most_speedup},
                    {"call_us", p.call_us}});
  }
  return json;
}

Json growth_json(const Growth& growth) {
  Json points = Json::array();
  for (const GrowthPoint& p : growth.points) {
    points.push_back({{"polygons", p.polygons},
                      {"in_view", p.in_view},
                      {"drawn", p.drawn},
                      {"build_s", p.build_s},
                      {"cull_ms", p.cull_ms},
                      {"near_in_view", p.near_in_view},
                      {"near_cull_ms", p.near_cull_ms},
                      {"peak_bytes_per_polygon", if_known(p.peak_bytes)},
                      {"held_bytes_per_polygon", if_known(p.held_bytes)}});
  }
  return {{"points", points},
          {"exponents",
           {{"build", if_known(growth.build_exponent)},
            {"cull", if_known(growth.cull_exponent)},
            {"near_cull", if_known(growth.near_cull_exponent)}}}};
}

}  // namespace

std::string report_json(const Result& result, const Options& options) {
  Json settings = json_of(options.walk, options.walk.build);
  settings["samples"] = options.samples;
  settings["repetitions"] = options.repetitions;
  const bool rendered = options.walk.render;
  Json json{{"model", result.model},
            {"polygons", result.polygons},
            {"frames", {{"first", result.first_frame}, {"last", result.last_frame}, {"count", result.frames}}},
            {"options", settings}};
  json["table2"] = result.table2 ? table2_json(*result.table2) : Json(nullptr);
  json["methods"] = result.table2 ? json_of(result.table2->methods) : Json(nullptr);
  json["figures_2_and_3"] = result.table2 ? frames_json(result.walked, rendered) : Json(nullptr);
  json["figure4"] = result.figure4 ? figure4_json(*result.figure4) : Json(nullptr);
  json["sweeps"] = nullptr;
  if (result.sweeps) {
    json["sweeps"] = {{"regions", sweep_json(result.sweeps->regions)}, {"threshold", sweep_json(result.sweeps->threshold)}};
  }
  json["sort"] = result.sort ? sort_json(*result.sort) : Json(nullptr);
  json["joined"] = nullptr;
  if (result.joined) {
    json["joined"] = {{"pictures", joined_json(result.joined->pictures)},
                      {"leaves", joined_json(result.joined->leaves)},
                      {"budgets", joined_json(result.joined->budgets)}};
  }
  json["threads"] = result.threads.empty() ? Json(nullptr) : threads_json(result.threads);
  json["growth"] = result.growth ? growth_json(*result.growth) : Json(nullptr);
  json["machine"] = json_of(result.table2 ? result.table2->machine : render::this_machine(""));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace occlude::experiments
