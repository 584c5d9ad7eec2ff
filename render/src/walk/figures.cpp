// SPDX-License-Identifier: MIT
#include "figures.h"

#include <fmt/format.h>

#include "chart.h"
#include "page.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double ratio) { return fmt::format("{:+.0f} %", 100 * (ratio - 1)); }

template <class Member>
Series series(const WalkResult& result, const std::string& name, const std::string& colour, Member member) {
  Series s{name, colour, {}};
  for (const FrameRecord& record : result.frames) s.y.push_back(static_cast<double>(record.*member));
  return s;
}

}  // namespace

std::string table2_html(const Json& summary) {
  const Json& mean = summary["mean"];
  const auto fps = [](const Json& ms) {
    return ms.is_null() ? std::string("&ndash;") : fmt::format("{:.1f}", 1000 / ms.get<double>());
  };
  const auto gain = [](const Json& ratio) {
    return ratio.is_null() ? std::string("&ndash;") : percent(ratio.get<double>());
  };
  const auto times = [](const Json& ratio) {
    return ratio.is_null() ? std::string("&ndash;") : fmt::format("{:.1f} &times;", ratio.get<double>());
  };
  const auto share = [](const Json& part) {
    return part.is_null() ? std::string("&ndash;") : fmt::format("{:.1f} %", 100 * part.get<double>());
  };
  return fmt::format(
      R"(<div class="wide"><table><thead><tr><th>Averages per frame</th><th>polygons</th><th>frames/s</th><th>paper: polygons</th><th>paper: frames/s</th></tr></thead><tbody>
<tr><td>View-frustum culling</td><td>{}</td><td>{}</td><td>49,196</td><td>3.6</td></tr>
<tr><td>With occlusion culling</td><td>{}</td><td>{}</td><td>29,749</td><td>5.6</td></tr>
<tr><td>Drawing only what shows</td><td>{}</td><td>{}</td><td>&ndash;</td><td>&ndash;</td></tr>
<tr><td>Polygons culled; speedup</td><td>{:.1f} %</td><td>{}</td><td>39.5 %</td><td>+55 %</td></tr>
<tr><td>Limit of the speedup: ratio of polygons drawn</td><td></td><td>{}</td><td></td><td>+65 %</td></tr>
<tr><td>Limit of the speedup: drawing only what is visible</td><td></td><td>{}</td><td></td><td>&ndash;</td></tr>
<tr><td>Of the hidden polygons in the view frustum, culled</td><td>{}</td><td></td><td></td><td></td></tr>
</tbody></table></div>)",
      grouped(mean["view_frustum_polygons"].get<double>()), fps(mean["frame_ms_view_frustum_only"]),
      grouped(mean["rendered_polygons"].get<double>()), fps(mean["frame_ms"]),
      mean["visible_polygons"].is_null() ? "&ndash;" : grouped(mean["visible_polygons"].get<double>()),
      fps(mean["frame_ms_visible_only"]), 100 * summary["culled_share"].get<double>(), gain(summary["speedup"]),
      gain(summary["speedup_limit"]["polygons"]), times(summary["speedup_limit"]["visible"]),
      share(summary["culled_share_of_hidden"]));
}

std::string figures_html(const WalkResult& result, bool rendered) {
  std::vector<double> frames;
  for (const FrameRecord& record : result.frames) frames.push_back(static_cast<double>(record.frame));
  const std::string before = "#8a94a3", after = "#1565c0", seen = "#2e9e5b";
  std::string html;
  if (rendered) {
    html += "<h2>Frame time (the paper's figure 2)</h2><figure>" +
            line_chart({"frame"}, {"milliseconds"}, frames,
                       {series(result, "view-frustum culling", before, &FrameRecord::view_frustum_frame_ms),
                        series(result, "with occlusion culling", after, &FrameRecord::frame_ms),
                        series(result, "culling alone", "#d9822b", &FrameRecord::cull_ms)}) +
            "</figure>";
  }
  std::vector<Series> polygons{series(result, "view-frustum culling", before, &FrameRecord::view_frustum_polygons),
                               series(result, "with occlusion culling", after, &FrameRecord::rendered_polygons)};
  if (rendered) polygons.push_back(series(result, "visible", seen, &FrameRecord::visible_polygons));
  html += "<h2>Polygons rendered (the paper's figure 3)</h2><figure>" +
          line_chart({"frame"}, {"polygons"}, frames, polygons) + "</figure>";
  return html;
}

}  // namespace occlude::render
