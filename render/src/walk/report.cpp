// SPDX-License-Identifier: MIT
#include "report.h"

#include <fmt/format.h>

#include <iterator>

#include "chart.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStyle = R"(
:root { color-scheme: light; --ink: #1d2430; --soft: #5b6676; --line: #dde2e8; --paper: #ffffff; --wash: #f5f7f9; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .2rem; } h2 { font-size: 1.2rem; margin-top: 2.4rem; }
p.lead, figcaption, .soft { color: var(--soft); }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .8rem; margin: 1.5rem 0; }
.fact { background: var(--wash); border-radius: .6rem; padding: .8rem 1rem; } .fact b { display: block; font-size: 1.6rem; }
.fact.bad { background: #fdecea; color: #a3201a; }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; } th, td { text-align: right; padding: .45rem .7rem; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; } thead th { font-weight: 600; color: var(--soft); }
svg { width: 100%; height: auto; font: 13px system-ui, sans-serif; fill: var(--ink); } svg polyline { fill: none; stroke-width: 1.3; }
svg .grid { stroke: var(--line); }
figure { margin: 1rem 0; } figure img { width: 100%; border-radius: .4rem; display: block; } figcaption { font-size: .9rem; margin-top: .4rem; }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

std::string percent(double ratio) { return fmt::format("{:+.0f} %", 100 * (ratio - 1)); }

std::string fact(const std::string& value, const std::string& what, bool bad = false) {
  return fmt::format(R"(<div class="fact{}"><b>{}</b>{}</div>)", bad ? " bad" : "", value, what);
}

/// What a reader wants to know first.
std::string facts(const Json& summary) {
  std::string html = R"(<div class="facts">)";
  html += fact(fmt::format("{:.1f} %", 100 * summary["culled_share"].get<double>()),
               "of the polygons in the view frustum culled");
  if (!summary["speedup"].is_null()) {
    const auto wrong = summary["wrong_pixels"].get<std::size_t>();
    const auto snapped = summary["wrong_pixels_explained_by_snapping"].get<std::size_t>();
    const auto false_culls = summary["false_culls"].get<std::size_t>();
    html += fact(fmt::format("{:.2f} &times;", summary["speedup"].get<double>()),
                 "frames a second, against view-frustum culling");
    html += fact(fmt::format("{}", false_culls), "visible polygons culled", false_culls != 0);
    html +=
        fact(fmt::format("{}", wrong),
             snapped == 0 ? "pixels that differ"
                          : fmt::format("pixels that differ, {} of them by the renderer's 1/256-pixel rounding", snapped),
             wrong != snapped);
  }
  return html + "</div>";
}

std::string table(const Json& summary) {
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
<tr><td>Polygons culled; speedup</td><td>{:.1f} %</td><td>{}</td><td>39.5 %</td><td>+55 %</td></tr>
<tr><td>Limit of the speedup: ratio of polygons drawn</td><td></td><td>{}</td><td></td><td>+65 %</td></tr>
<tr><td>Limit of the speedup: drawing only what is visible</td><td></td><td>{}</td><td></td><td>&ndash;</td></tr>
<tr><td>Of the hidden polygons in the view frustum, culled</td><td>{}</td><td></td><td></td><td></td></tr>
</tbody></table></div>)",
      grouped(mean["view_frustum_polygons"].get<double>()), fps(mean["frame_ms_view_frustum_only"]),
      grouped(mean["rendered_polygons"].get<double>()), fps(mean["frame_ms"]), 100 * summary["culled_share"].get<double>(),
      gain(summary["speedup"]), gain(summary["speedup_limit"]["polygons"]), times(summary["speedup_limit"]["visible"]),
      share(summary["culled_share_of_hidden"]));
}

template <class Member>
Series series(const WalkResult& result, const std::string& name, const std::string& colour, Member member) {
  Series s{name, colour, {}};
  for (const FrameRecord& record : result.frames) s.y.push_back(static_cast<double>(record.*member));
  return s;
}

std::string figures(const WalkResult& result, bool rendered) {
  std::vector<double> frames;
  for (const FrameRecord& record : result.frames) frames.push_back(static_cast<double>(record.frame));
  const std::string before = "#8a94a3", after = "#1565c0", seen = "#2e9e5b";
  std::string html;
  if (rendered) {
    html += "<h2>Frame time (the paper's figure 2)</h2><figure>" +
            line_chart("frame", "milliseconds", frames,
                       {series(result, "view-frustum culling", before, &FrameRecord::view_frustum_frame_ms),
                        series(result, "with occlusion culling", after, &FrameRecord::frame_ms),
                        series(result, "culling alone", "#d9822b", &FrameRecord::cull_ms)}) +
            "</figure>";
  }
  std::vector<Series> polygons{series(result, "view-frustum culling", before, &FrameRecord::view_frustum_polygons),
                               series(result, "with occlusion culling", after, &FrameRecord::rendered_polygons)};
  if (rendered) polygons.push_back(series(result, "visible", seen, &FrameRecord::visible_polygons));
  html += "<h2>Polygons rendered (the paper's figure 3)</h2><figure>" + line_chart("frame", "polygons", frames, polygons) +
          "</figure>";
  return html;
}

std::string plates(const WalkResult& result) {
  if (result.plates.empty()) return "";
  std::string html = "<h2>Plates</h2>";
  for (const Plate& plate : result.plates) {
    fmt::format_to(std::back_inserter(html),
                   R"(<figure><img src="plates/{0}" alt="{1}" loading="lazy"><figcaption>{1}</figcaption></figure>)",
                   plate.file, escaped(plate.caption));
  }
  return html;
}

std::string conditions(const Json& summary) {
  const Json& options = summary["options"];
  const Json& machine = summary["machine"];
  const std::string renderer = machine["renderer"].is_null() ? "nothing drawn" : machine["renderer"].get<std::string>();
  return fmt::format(
      "<h2>Conditions</h2><p class=\"soft\">{}&times;{} pixels, {} occluders{}, near plane {}, {} arithmetic, {} test, tree "
      "of {}s. "
      "{} frames; on {} of them the item buffer was drawn from the whole model without any culling. Preprocess {:.1f} s. "
      "Every frame was drawn with both methods, one after the other, in alternating order. {}, {} threads; {}; compiled by "
      "{}.</p>",
      options["size"][0].get<int>(), options["size"][1].get<int>(), options["occluders"].get<std::size_t>(),
      options["unions"].get<bool>() ? " and unions of pairs of them" : "", options["near"].get<std::string>(),
      options["arithmetic"].get<std::string>(), options["test"].get<std::string>(),
      options["bounds"] == "obb" ? "OBB" : "AABB", summary["frames"].get<std::size_t>(),
      summary["reference_frames"].get<std::size_t>(), summary["preprocess_s"].get<double>(),
      escaped(machine["processor"].get<std::string>()), machine["threads"].get<unsigned>(), escaped(renderer),
      escaped(machine["compiler"].get<std::string>()));
}

}  // namespace

std::string report_html(const WalkResult& result, const Json& summary) {
  const std::string model = escaped(summary["model"].get<std::string>());
  std::string html = fmt::format(
      R"(<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>occlude: {0}</title><style>{1}</style></head><body>
<h1>A walk through {0}</h1><p class="lead">{2} polygons, {3} frames; after Hudson et al. 1997, section 6.3.</p>)",
      model, kStyle, grouped(static_cast<double>(result.polygons)), result.frames.size());
  html += facts(summary) + "<h2>Averages (the paper's table 2)</h2>" + table(summary);
  html += figures(result, !summary["speedup"].is_null()) + conditions(summary) + plates(result);
  return html + "</body></html>\n";
}

}  // namespace occlude::render
