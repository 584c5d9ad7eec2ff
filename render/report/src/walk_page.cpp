// SPDX-License-Identifier: MIT
#include "occlude/render/walk_page.h"

#include <fmt/format.h>

#include <iterator>

#include "occlude/render/chart.h"
#include "occlude/render/page.h"

namespace occlude::render {
namespace {

constexpr const char* kNone = "&ndash;";

std::string times(const std::optional<double>& ratio) { return ratio ? fmt::format("{:.1f} &times;", *ratio) : kNone; }

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string fact(const std::string& value, const std::string& what, bool bad = false) {
  return fmt::format(R"(<div class="fact{}"><b>{}</b>{}</div>)", bad ? " bad" : "", value, what);
}

/// The main results.
std::string facts(const Summary& summary) {
  std::string html = R"(<div class="facts">)";
  html += fact(percent(summary.culled_share), "of the polygons in the view frustum culled");
  if (summary.options.render) {
    const std::size_t wrong = *summary.wrong_pixels, snapped = *summary.snapped_pixels;
    html += fact(fmt::format("{:.2f} &times;", *summary.speedup), "frames a second, against view-frustum culling");
    html += fact(fmt::format("{}", *summary.false_culls), "visible polygons culled", *summary.false_culls != 0);
    html +=
        fact(fmt::format("{}", wrong),
             snapped == 0 ? "pixels that differ"
                          : fmt::format("pixels that differ, {} of them by the renderer's 1/256-pixel rounding", snapped),
             wrong != snapped);
  }
  return html + "</div>";
}

std::string plates_html(const std::vector<Plate>& plates) {
  if (plates.empty()) return "";
  std::string html = "<h2>Plates</h2>";
  for (const Plate& plate : plates) {
    fmt::format_to(std::back_inserter(html),
                   R"(<figure><img src="plates/{0}" alt="{1}" loading="lazy"><figcaption>{1}</figcaption></figure>)",
                   plate.file, escaped(plate.caption));
  }
  return html;
}

/// What was drawn of the frames.
std::string drawing(const Summary& summary) {
  if (!summary.options.render) return ", of which nothing was drawn: only culling was measured.";
  return fmt::format(
      "; on {} of them the item buffer was drawn from the whole model without any culling. Every frame was drawn with both "
      "methods, one after the other, in alternating order.",
      summary.reference_frames);
}

std::string conditions(const Summary& summary) {
  const WalkOptions& options = summary.options;
  const culler::CullOptions& cull = options.cull;
  const Machine& machine = summary.machine;
  return fmt::format(
      "<h2>Conditions</h2><p class=\"soft\">{}&times;{} pixels, {} occluders{}, near plane {}, {} arithmetic, {} test, tree "
      "of {}s. "
      "{} frames{} Preprocess {:.1f} s. {}, {} threads; {}compiled by {}.</p>",
      options.width, options.height, cull.occluders, cull.unions ? " and unions of pairs of them" : "", name_of(cull.near),
      name_of(cull.arithmetic), name_of(cull.test), summary.build.hierarchy.bounds == culler::Bounds::obb ? "OBB" : "AABB",
      summary.frames, drawing(summary), summary.preprocess_s, escaped(machine.processor), machine.threads,
      machine.renderer.empty() ? "" : escaped(machine.renderer) + "; ", escaped(machine.compiler));
}

template <class Member>
Series series(const std::vector<FrameRecord>& frames, const std::string& name, const std::string& colour, Member member) {
  Series s{name, colour, {}};
  for (const FrameRecord& record : frames) s.y.push_back(static_cast<double>(record.*member));
  return s;
}

}  // namespace

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
      grouped(mean.view_frustum_polygons), fps(mean.frame_ms_view_frustum_only, kNone), grouped(mean.rendered_polygons),
      fps(mean.frame_ms, kNone), mean.visible_polygons ? grouped(*mean.visible_polygons) : kNone,
      fps(mean.frame_ms_visible_only, kNone), 100 * summary.culled_share, gain(summary.speedup, kNone),
      gain(summary.limit_by_polygons, kNone), times(summary.limit_by_visible),
      summary.culled_share_of_hidden ? percent(*summary.culled_share_of_hidden) : kNone);
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

std::string walk_page(const Summary& summary, const std::vector<FrameRecord>& frames, const std::vector<Plate>& plates) {
  const std::string model = escaped(summary.model);
  std::string body = fmt::format(
      R"(<h1>A walk through {}</h1><p class="lead">{} polygons, {} frames; after Hudson et al. 1997, section 6.3.</p>)",
      model, grouped(static_cast<double>(summary.polygons)), summary.frames);
  body += facts(summary) + "<h2>Averages (the paper's table 2)</h2>" + table2_html(summary);
  if (const std::string note = limit_note(summary); !note.empty()) body += "<p class=\"soft\">" + note + "</p>";
  body += figures_html(frames, summary.options.render) + conditions(summary) + plates_html(plates);
  return page("occlude: " + model, body);
}

}  // namespace occlude::render
