// SPDX-License-Identifier: MIT
#include "occlude/render/walk_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "deflated.h"
#include "occlude/render/formats.h"
#include "occlude/render/missed_report.h"
#include "occlude/render/page.h"
#include "occlude/render/paper_report.h"
#include "page_camera.h"
#include "page_files.h"
#include "template.h"

namespace occlude::render {
namespace {

std::string fact(const std::string& value, const std::string& what, bool bad = false) {
  return fmt::format(R"(<div class="fact{}"><b>{}</b>{}</div>)", bad ? " bad" : "", value, what);
}

/// The main results. The paper's are of its own city, so only shares and ratios stand beside them.
std::string facts(const Summary& summary) {
  std::string shares, speeds;
  std::size_t false_culls = 0;
  for (const MethodRow& m : summary.methods) {
    if (!m.by) continue;
    const bool is_of_paper = m.by == culler::Method::frusta;
    const auto by = [&](const char* what, const char* paper) {
      return fmt::format("{} by {}{}", what, m.method, is_of_paper ? paper : "");
    };
    shares += fact(percent(m.culled_share), by("of the polygons in view culled", " <small>(paper: 39.5 %)</small>"));
    speeds += m.speedup
                  ? fact(fmt::format("{:.2f} &times;", *m.speedup), by("frames a second", " <small>(paper: 1.55)</small>"))
                  : fact(fmt::format("{:.2f} ms", m.cull_ms), by("to cull a frame, on average", ""));
    false_culls += m.false_culls.value_or(0);
  }
  std::string html = shares + speeds;
  if (!summary.options.render) return html;
  const std::size_t wrong = *summary.wrong_pixels, snapped = *summary.snapped_pixels;
  html += fact(fmt::format("{}", false_culls), "visible polygons culled", false_culls != 0);
  html += fact(fmt::format("{}", wrong),
               snapped == 0 ? "pixels that differ"
                            : fmt::format("pixels that differ, {} of them by the renderer's 1/256-pixel rounding", snapped),
               wrong != snapped);
  return html;
}

std::string lead(const Summary& summary) {
  return fmt::format("{} polygons, {} frames. After Hudson et al. 1997, section 6.3.{}",
                     grouped(static_cast<double>(summary.polygons)), grouped(static_cast<double>(summary.frames)),
                     summary.options.render ? "" : " Nothing was drawn: this walk measured culling alone.");
}

std::string methods(const Summary& summary, std::size_t shown) {
  return html_of(table_of(summary.methods)) +
         fmt::format(
             "<p class=\"soft\">Without: the same frames by the view frustum alone, in turns with "
             "the method. Averages below are by {}{}.{}</p>",
             text_of(summary.options.cull.method),
             summary.held ? ", for regions of eyes that hold for the frames between" : "",
             shown > 1
                 ? " The picture, and what is told of frames, regions and occluders, is of the method that is chosen there."
                 : "");
}

std::string note(const char* kind, const std::string& text) {
  return text.empty() ? "" : fmt::format(R"(<p class="{}">{}</p>)", kind, text);
}

/// What is not as in the walk.
std::string simplified(const Summary& summary, const WalkRecording& recording) {
  std::string html;
  if (recording.polygons() < summary.polygons) {
    html += fmt::format("The model is simplified here: the {} largest of its {} polygons. ",
                        grouped(static_cast<double>(recording.polygons())), grouped(static_cast<double>(summary.polygons)));
  }
  if (recording.every() > 1) html += fmt::format("Of every {} frames one is shown here. ", recording.every());
  return note("note", html);
}

std::string pictures_html(const std::vector<PagePicture>& pictures) {
  std::string html;
  for (const PagePicture& picture : pictures) html += picture_html(picture.png, picture.caption);
  return html;
}

std::string machine_of(const Machine& machine) { return fmt::format("{}, {} threads", machine.processor, machine.threads); }

std::string conditions(const Summary& summary) {
  const WalkOptions& options = summary.options;
  const culler::CullOptions& cull = options.cull;
  const Machine& machine = summary.machine;
  const std::string method =
      culler::is_by_cover(cull.method)
          ? fmt::format("joined shadows in a picture of {}&times;{}", cull.cover.width, cull.cover.height)
          : fmt::format("{} occluders{}, near plane {}, {} test", cull.occluders,
                        cull.unions ? " and unions of pairs of them" : "", name_of(cull.shadow_near), name_of(cull.test));
  const std::string drawn = options.render
                                ? fmt::format(
                                      "Every frame was drawn with both methods, one after the other, in alternating order, "
                                      "in {}&times;{} pixels. On "
                                      "{} frames the item buffer was drawn from the whole model without any culling. ",
                                      options.width, options.height, summary.reference_frames)
                                : "Nothing was drawn. ";
  const std::string held =
      summary.held ? fmt::format(", for regions of eyes that reach {:g} ahead", options.hold) : std::string();
  return fmt::format("<p>{}{}; {} arithmetic, tree of {}s. {}Preprocess {:.1f} s.</p><p>{}; {}compiled by {}.</p>", method,
                     held, name_of(cull.arithmetic), summary.build.hierarchy.bounds == culler::Bounds::obb ? "OBB" : "AABB",
                     drawn, summary.preprocess_s, escaped(machine_of(machine)),
                     machine.renderer.empty() ? "" : escaped(machine.renderer) + "; ", escaped(machine.compiler));
}

std::string digits(std::size_t count) { return std::to_string(count); }
std::string digits(double ms) { return fmt::format("{:.5g}", ms); }

/// Lists of numbers by their names, as members of a JSON object.
class Columns {
 public:
  /// `value` is a member of an element of `rows`, or a function of one.
  template <class Rows, class Value>
  void add(std::string_view name, const Rows& rows, Value&& value) {
    fmt::format_to(std::back_inserter(text_), R"({}"{}":[)", text_.empty() ? "" : ",", name);
    for (std::size_t i = 0; i < rows.size(); ++i) text_ += (i == 0 ? "" : ",") + digits(std::invoke(value, rows[i]));
    text_ += "]";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Why each frame drew what is hidden: a column for each reason that some frame has. Returns the names of these columns with
/// the reasons in words.
nlohmann::ordered_json add_missed(Columns& columns, const std::vector<culler::MissedReasons::Counts>& missed) {
  using Counts = culler::MissedReasons::Counts;
  nlohmann::ordered_json names = nlohmann::ordered_json::object();
  const auto add = [&](const std::string& name, const char* text, const std::function<std::size_t(const Counts&)>& count) {
    if (std::ranges::all_of(missed, [&](const Counts& counts) { return count(counts) == 0; })) return;
    columns.add(name, missed, count);
    names[name] = text;
  };
  for (std::size_t r = 0; r < culler::kMissedReasons; ++r) {
    const auto reason = static_cast<culler::Missed>(r);
    add("missed_" + std::string(to_string(reason)), text_of(reason),
        [r](const Counts& counts) { return counts.reasons[r]; });
  }
  add("missed_unasked", kUnasked, [](const Counts& counts) { return counts.missed - counts.asked(); });
  return names;
}

/// The regions of a walk that holds: where they are, and what each took.
nlohmann::ordered_json json_of(const std::vector<RegionRecord>& regions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RegionRecord& region : regions) {
    const auto& [a, b, c] = region.eyes.half_edges;
    list.push_back({{"first", region.frame},
                    {"ms", region.cull_ms},
                    {"centre", page_json(region.center)},
                    {"halfEdges", {page_json(a), page_json(b), page_json(c)}}});
  }
  return list;
}

/// The figures of all frames of a walk, in columns.
std::string figures(const Summary& summary, const MethodWalk& of) {
  const WalkOptions& options = *of.options;
  Columns columns;
  const auto add = [&](const char* name, auto&& value) { columns.add(name, of.walk->frames, value); };
  add("frame", &FrameRecord::frame);
  add("in_view", &FrameRecord::view_frustum_polygons);
  add("drawn", &FrameRecord::rendered_polygons);
  add("culled", [](const FrameRecord& r) { return r.stats.shadow_culled_polygons; });
  add("out_of_view", [](const FrameRecord& r) { return r.stats.view_culled_polygons; });
  add("cull_ms", &FrameRecord::cull_ms);
  add("cull_processor_ms", &FrameRecord::cull_processor_ms);
  if (options.hold > 0) add("region", &FrameRecord::region);
  if (options.render) {
    add("visible", &FrameRecord::visible_polygons);
    add("frame_ms", &FrameRecord::frame_ms);
    add("frame_processor_ms", &FrameRecord::frame_processor_ms);
    add("view_frustum_frame_ms", &FrameRecord::view_frustum_frame_ms);
    add("view_frustum_frame_processor_ms", &FrameRecord::view_frustum_frame_processor_ms);
    add("visible_frame_ms", &FrameRecord::visible_frame_ms);
  }
  const nlohmann::ordered_json reasons = add_missed(columns, of.walk->missed);
  const nlohmann::ordered_json walk = {{"model", summary.model},
                                       {"polygons", summary.polygons},
                                       {"rendered", options.render},
                                       {"name", method_text(options)},
                                       {"method", name_of(options.cull.method)},
                                       {"kind", culler::is_by_cover(options.cull.method) ? "cover" : "frusta"},
                                       {"size", {options.width, options.height}},
                                       {"reasons", reasons},
                                       {"regions", json_of(of.walk->regions)}};
  return fmt::format(R"({{"walk":{},"columns":{{{}}}}})", walk.dump(), columns.text());
}

std::string parts(const Summary& summary, const WalkPageContent& content) {
  std::string walks;
  for (const PageWalk& shown : content.walks) walks += (walks.empty() ? "" : ",") + figures(summary, shown.walk);
  std::string html = page_part("figures", "[" + walks + "]") + page_part("way", content.path);
  const auto first = content.walks.front().recording->parts();
  for (const auto& [name, bytes] : first) html += page_part(name, bytes);
  // Of the others what is not the same.
  for (std::size_t i = 1; i < content.walks.size(); ++i) {
    const auto parts = content.walks[i].recording->parts();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k] != first[k]) html += page_part(fmt::format("{}-{}", parts[k].first, i), parts[k].second);
    }
  }
  return html;
}

}  // namespace

std::string walk_page(const Summary& summary, const WalkPageContent& content) {
  const std::map<std::string_view, std::function<std::string()>> values{
      {"model", [&] { return escaped(summary.model); }},
      {"lead", [&] { return lead(summary); }},
      {"methods", [&] { return methods(summary, content.walks.size()); }},
      {"times", [&] { return summary.options.render ? "Frame time (the paper's figure 2)" : "Time to cull"; }},
      {"busy", [&] { return note("note", busy_note(summary)); }},
      {"facts", [&] { return facts(summary); }},
      {"simplified", [&] { return simplified(summary, *content.walks.front().recording); }},
      {"table1", [&] { return summary.operations.tests == 0 ? "" : html_of(table1_of(summary.operations)); }},
      {"spread", [&] { return html_of(spread_table(summary)); }},
      {"table2", [&] { return html_of(table2_of(summary)) + note("soft", limit_note(summary)); }},
      {"pictures", [&] { return pictures_html(content.pictures); }},
      {"conditions", [&] { return conditions(summary); }},
      {"command", [&] { return escaped(content.command); }},
      {"options", [&] { return escaped(options_of(summary).dump(2)); }},
      {"machine", [&] { return escaped(machine_of(summary.machine)); }},
      {"version", [] { return std::string(OCCLUDE_VERSION); }},
      {"parts", [&] { return parts(summary, content); }}};
  return filled(page_file("walk.html"), [&](std::string_view name) {
    const auto found = values.find(name);
    return found == values.end() ? std::string(page_file(name)) : found->second();
  });
}

}  // namespace occlude::render
