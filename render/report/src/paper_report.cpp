// SPDX-License-Identifier: MIT
#include "occlude/render/paper_report.h"

#include <fmt/format.h>

#include <iterator>

#include "occlude/render/chart.h"
#include "occlude/render/formats.h"

namespace occlude::render {
namespace {

constexpr const char* kUnknown = "-";

std::string in_ms(double value) { return rounded(value, 2); }
std::string in_percent(double ratio) { return gain(ratio, kUnknown); }

template <class Member>
Series series(const std::vector<FrameRecord>& frames, const std::string& name, const std::string& colour, Member member) {
  Series s{name, colour, {}};
  for (const FrameRecord& record : frames) s.y.push_back(static_cast<double>(record.*member));
  return s;
}

}  // namespace

Table table1_of(const kernel::Operations& counted) {
  const auto each = [&](std::uint64_t count) {
    return rounded(static_cast<double>(count) / static_cast<double>(counted.tests), 1);
  };
  return {"Table 1",
          {{"Operations of a test"}, {"dot"}, {"scalar \u00d7 vector"}, {"add, subtract"}, {"cross"}},
          {{"This walk, mean of " + grouped(static_cast<double>(counted.tests)) + " tests", each(counted.dot),
            each(counted.scalar), each(counted.vector), each(counted.cross)},
           {"Paper: specialised, no far plane, worst / best", "240 / 4", "144 / 0", "132 / 0", "0 / 0"},
           {"Paper: naive, no far plane, worst / best", "216 / 8", "168 / 0", "600 / 0", "336 / 0"}}};
}

Table table2_of(const Summary& summary) {
  const Summary::Mean& mean = summary.mean;
  const auto times = [](const std::optional<double>& ratio) { return ratio ? gain(ratio, kUnknown) : kUnknown; };
  return {
      "Table 2, by " + method_text(summary.options),
      {{"Averages per frame"}, {"polygons"}, {"frames/s"}, {"the paper, its own model: polygons"}, {"frames/s"}},
      {{"View-frustum culling", mean.view_frustum_polygons, fps(mean.frame_ms_view_frustum_only, kUnknown), "49,196", "3.6"},
       {"With occlusion culling", mean.rendered_polygons, fps(mean.frame_ms, kUnknown), "29,749", "5.6"},
       {"Drawing only visible polygons", if_known(mean.visible_polygons), fps(mean.frame_ms_visible_only, kUnknown),
        kUnknown, kUnknown},
       {"Polygons culled; speedup", percent(summary.culled_share), times(summary.speedup), "39.5 %", "+55 %"},
       {"Limit of the speedup: ratio of polygons drawn", "", times(summary.limit_by_polygons), "", "+65 %"},
       {"Limit of the speedup: drawing only what is visible", "", times(summary.limit_by_visible), "", kUnknown},
       {"Of the hidden polygons in the view frustum, culled",
        summary.culled_share_of_hidden ? percent(*summary.culled_share_of_hidden) : kUnknown, "", "", ""}}};
}

Table spread_table(const Summary& summary) {
  Table table{"", {{"Frame by frame"}, {"mean"}, {"median"}, {"5 %"}, {"95 %"}, {"worst"}}, {}};
  const auto add = [&](const char* name, const std::optional<double>& mean, const std::optional<Spread>& spread,
                       std::string (*number)(double)) {
    if (!spread) return;
    const auto& [frame, worst] = spread->worst;
    table.rows.push_back({name, mean ? number(*mean) : kUnknown, number(spread->median), number(spread->percentile_5),
                          number(spread->percentile_95),
                          linked(fmt::format("{} (frame {})", number(worst), frame), fmt::format("#frame={}", frame))});
  };
  add("Culling, ms", summary.mean.cull_ms, summary.spread.cull_ms, in_ms);
  add("Culling, ms of processor", summary.mean.cull_processor_ms, summary.spread.cull_processor_ms, in_ms);
  add("Frame, ms", summary.mean.frame_ms, summary.spread.frame_ms, in_ms);
  add("Frame, ms of processors", summary.mean.frame_processor_ms, summary.spread.frame_processor_ms, in_ms);
  add("Speedup", summary.speedup, summary.spread.speedup, in_percent);
  return table;
}

std::string figures_html(const std::vector<FrameRecord>& frames, bool rendered) {
  std::vector<double> numbers;
  for (const FrameRecord& record : frames) numbers.push_back(static_cast<double>(record.frame));
  const std::string before = "#8a94a3", after = "#1565c0", seen = "#2e9e5b";
  std::string html;
  if (rendered) {
    html += "<h2>Frame time (the paper's figure 2)</h2><figure>" +
            line_chart({"frame"}, {"milliseconds"}, numbers,
                       {series(frames, "view-frustum culling", before, &FrameRecord::view_frustum_frame_ms),
                        series(frames, "with occlusion culling", after, &FrameRecord::frame_ms),
                        series(frames, "culling alone", "#d9822b", &FrameRecord::cull_ms)}) +
            "</figure>";
  }
  std::vector<Series> polygons{series(frames, "view-frustum culling", before, &FrameRecord::view_frustum_polygons),
                               series(frames, "with occlusion culling", after, &FrameRecord::rendered_polygons)};
  if (rendered) polygons.push_back(series(frames, "visible", seen, &FrameRecord::visible_polygons));
  html += "<h2>Polygons rendered (the paper's figure 3)</h2><figure>" +
          line_chart({"frame"}, {"polygons"}, numbers, polygons) + "</figure>";
  return html;
}

}  // namespace occlude::render
