// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "experiments.h"
#include "occlude/render/summary.h"
#include "tables.h"

namespace occlude::experiments {
namespace {

using Json = nlohmann::ordered_json;
using render::if_known;

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

Json sort_json(const Sorting& sorting) {
  return {{"points", json_of(sort_table(sorting))},
          {"exponents",
           {{"moves", if_known(sorting.moves_exponent)},
            {"comparisons", if_known(sorting.comparisons_exponent)},
            {"comparisons_anew", if_known(sorting.anew_exponent)}}}};
}

Json growth_json(const Growth& growth) {
  return {{"points", json_of(growth_table(growth))},
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
  json["methods"] = result.table2 ? json_of(table_of(result.table2->methods)) : Json(nullptr);
  json["figures_2_and_3"] = result.table2 ? frames_json(result.walked, rendered) : Json(nullptr);
  json["figure4"] = result.figure4 ? figure4_json(*result.figure4) : Json(nullptr);
  json["sweeps"] = nullptr;
  if (result.sweeps) {
    json["sweeps"] = {{"regions", json_of(regions_table(*result.sweeps))},
                      {"threshold", json_of(threshold_table(*result.sweeps))}};
  }
  json["sort"] = result.sort ? sort_json(*result.sort) : Json(nullptr);
  json["joined"] = nullptr;
  if (result.joined) {
    json["joined"] = {{"pictures", json_of(pictures_table(*result.joined))},
                      {"leaves", json_of(leaves_table(*result.joined))},
                      {"budgets", json_of(budgets_table(*result.joined))}};
  }
  json["occluders"] = result.occluders ? json_of(occluders_table(*result.occluders)) : Json(nullptr);
  json["threads"] = result.threads.empty() ? Json(nullptr) : json_of(threads_table(result.threads));
  json["growth"] = result.growth ? growth_json(*result.growth) : Json(nullptr);
  json["machine"] = json_of(result.table2 ? result.table2->machine : render::this_machine());
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace occlude::experiments
