// SPDX-License-Identifier: MIT
#include "occlude/render/paper_html.h"

#include <fmt/format.h>

#include <iterator>

#include "occlude/render/chart.h"
#include "occlude/render/page.h"

namespace occlude::render {
namespace {

constexpr const char* kUnknown = "&ndash;";

std::string times(const std::optional<double>& ratio) { return ratio ? fmt::format("{:.1f} &times;", *ratio) : kUnknown; }

std::string ms(double value) { return fmt::format("{:.2f}", value); }
std::string speedup(double ratio) { return fmt::format("{:.2f} &times;", ratio); }

/// A row of spread_html().
std::string spread_row(const char* name, const std::optional<double>& mean, const std::optional<Spread>& spread,
                       std::string (*number)(double)) {
  if (!spread) return "";
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{} in frame <a href=\"#frame={}\">{}</a></td></tr>\n",
      name, mean ? number(*mean) : kUnknown, number(spread->median), number(spread->percentile_5),
      number(spread->percentile_95), number(spread->worst.value), spread->worst.frame, spread->worst.frame);
}

template <class Member>
Series series(const std::vector<FrameRecord>& frames, const std::string& name, const std::string& colour, Member member) {
  Series s{name, colour, {}};
  for (const FrameRecord& record : frames) s.y.push_back(static_cast<double>(record.*member));
  return s;
}

}  // namespace

std::string table1_html(const Summary& summary) {
  const kernel::Operations& counted = summary.operations;
  if (counted.tests == 0) return "";
  const auto each = [&](std::uint64_t count) {
    return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(counted.tests));
  };
  return fmt::format(
      R"(<div class="wide"><table><thead><tr><th>Operations of a test</th><th>dot</th><th>scalar &times; vector</th><th>add, subtract</th><th>cross</th></tr></thead><tbody>
<tr><td>This walk, mean of {} tests</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>
<tr><td>Paper: specialised, no far plane, worst / best</td><td>240 / 4</td><td>144 / 0</td><td>132 / 0</td><td>0 / 0</td></tr>
<tr><td>Paper: naive, no far plane, worst / best</td><td>216 / 8</td><td>168 / 0</td><td>600 / 0</td><td>336 / 0</td></tr>
</tbody></table></div>)",
      grouped(static_cast<double>(counted.tests)), each(counted.dot), each(counted.scalar), each(counted.vector),
      each(counted.cross));
}

std::string table2_html(const Summary& summary) {
  const Summary::Mean& mean = summary.mean;
  return fmt::format(
      R"(<div class="wide"><table><thead><tr><th>Averages per frame</th><th>polygons</th><th>frames/s</th><th>the paper, its own model: polygons</th><th>frames/s</th></tr></thead><tbody>
<tr><td>View-frustum culling</td><td>{}</td><td>{}</td><td>49,196</td><td>3.6</td></tr>
<tr><td>With occlusion culling</td><td>{}</td><td>{}</td><td>29,749</td><td>5.6</td></tr>
<tr><td>Drawing only visible polygons</td><td>{}</td><td>{}</td><td>&ndash;</td><td>&ndash;</td></tr>
<tr><td>Polygons culled; speedup</td><td>{:.1f} %</td><td>{}</td><td>39.5 %</td><td>+55 %</td></tr>
<tr><td>Limit of the speedup: ratio of polygons drawn</td><td></td><td>{}</td><td></td><td>+65 %</td></tr>
<tr><td>Limit of the speedup: drawing only what is visible</td><td></td><td>{}</td><td></td><td>&ndash;</td></tr>
<tr><td>Of the hidden polygons in the view frustum, culled</td><td>{}</td><td></td><td></td><td></td></tr>
</tbody></table></div>)",
      grouped(mean.view_frustum_polygons), fps(mean.frame_ms_view_frustum_only, kUnknown), grouped(mean.rendered_polygons),
      fps(mean.frame_ms, kUnknown), mean.visible_polygons ? grouped(*mean.visible_polygons) : kUnknown,
      fps(mean.frame_ms_visible_only, kUnknown), 100 * summary.culled_share, gain(summary.speedup, kUnknown),
      gain(summary.limit_by_polygons, kUnknown), times(summary.limit_by_visible),
      summary.culled_share_of_hidden ? percent(*summary.culled_share_of_hidden) : kUnknown);
}

std::string spread_html(const Summary& summary) {
  const std::string rows = spread_row("Culling, ms", summary.mean.cull_ms, summary.spread.cull_ms, ms) +
                           spread_row("Frame, ms", summary.mean.frame_ms, summary.spread.frame_ms, ms) +
                           spread_row("Speedup", summary.speedup, summary.spread.speedup, speedup);
  if (rows.empty()) return "";
  return "<div class=\"wide\"><table><thead><tr><th>Frame by frame</th><th>mean</th><th>median</th><th>5 %</th><th>95 %</th>"
         "<th>worst</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>";
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
