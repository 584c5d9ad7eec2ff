// SPDX-License-Identifier: MIT
#include "report.h"

#include <fmt/format.h>

#include <iterator>

#include "figures.h"
#include "page.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

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
  std::string body = fmt::format(
      R"(<h1>A walk through {}</h1><p class="lead">{} polygons, {} frames; after Hudson et al. 1997, section 6.3.</p>)",
      model, grouped(static_cast<double>(result.polygons)), result.frames.size());
  body += facts(summary) + "<h2>Averages (the paper's table 2)</h2>" + table2_html(summary);
  body += figures_html(result, !summary["speedup"].is_null()) + conditions(summary) + plates(result);
  return page("occlude: " + model, body);
}

}  // namespace occlude::render
