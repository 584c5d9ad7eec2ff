// SPDX-License-Identifier: MIT
#include "occlude/render/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "occlude/render/chart.h"
#include "occlude/render/input_file.h"
#include "occlude/render/page.h"
#include "occlude/render/summary.h"
#include "occlude/render/table.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

const char* word_for(Verdict verdict) {
  constexpr std::array<const char*, 4> kNames{"", "same", "better", "worse"};
  return kNames[static_cast<std::size_t>(verdict)];
}

/// Of which values a difference is. A member that is null, or is not there, is "none".
std::string text_of(const Difference& d) {
  const auto value = [](const std::string& text) { return text == "null" || text == "-" ? "none" : text; };
  return fmt::format("{}: {} and {}", d.name, value(d.a), value(d.b));
}

/// Why times are not to be believed; empty if nothing speaks against them.
std::vector<std::string> doubts(const WalkComparison& comparison) {
  std::vector<std::string> doubts;
  const auto add = [&](const char* times, const char* longer, const std::optional<double>& control) {
    if (is_same_pace(control)) return;
    doubts.push_back(
        fmt::format("Times {} cannot be compared, and are not judged: the view frustum alone, which both walks cull alike, "
                    "took {:.2f} times "
                    "as {} in B. The machine was another one, or busy.",
                    times, *control, longer));
  };
  add("by the clock", "long", comparison.control);
  add("of the processor", "much", comparison.control_of_processor);
  for (const auto* walk : {&comparison.a, &comparison.b}) {
    if (!walk->busy.empty()) doubts.push_back(fmt::format("{}: {}", walk->label, walk->busy));
  }
  return doubts;
}

/// What the comparison rests on, and what got worse.
std::string conclusion(const WalkComparison& comparison) {
  const std::vector<std::string> worse = comparison.worse();
  const std::string frames = comparison.frames
                                 ? fmt::format("{} frames that both have", comparison.frames->size())
                                 : "no frames.csv on both sides: the noise of times is not known, so they are not judged";
  return fmt::format("{}; worse: {}", frames, worse.empty() ? "nothing" : fmt::format("{}", fmt::join(worse, ", ")));
}

std::optional<Colour> colour_of(const std::string& mark) {
  if (mark == word_for(Verdict::worse)) return Colour::red;
  return mark == word_for(Verdict::better) ? std::optional(Colour::green) : std::nullopt;
}

Table table_of(const WalkComparison& comparison) {
  Table table{"",
              {{"figure", "name"},
               {"A: " + comparison.a.label, "a", short_of},
               {"B: " + comparison.b.label, "b", short_of},
               {"B/A", "ratio", rounded<3>},
               {"", "per_frame"},
               {"median of frames", "", rounded<3>},
               {"5 %", "", rounded<3>},
               {"95 %", "", rounded<3>},
               {"", "verdict"},
               {"change", "", grouped, colour_of}},
              {}};
  for (const ComparedFigure& f : comparison.figures) {
    const auto of = [&](double Spread::*member) { return f.per_frame ? Cell((*f.per_frame).*member) : Cell(nullptr); };
    // A mark stands at what changed, for better or worse.
    const char* const mark = f.verdict == Verdict::same ? "" : word_for(f.verdict);
    table.rows.push_back({f.name, if_known(f.a), if_known(f.b), if_known(f.ratio()), json_of(f.per_frame),
                          of(&Spread::median), of(&Spread::percentile_5), of(&Spread::percentile_95),
                          f.verdict == Verdict::unjudged ? Cell(nullptr) : Cell(word_for(f.verdict)), mark});
  }
  return table;
}

/// For people: without the figures that neither has.
Table known_figures(const WalkComparison& comparison) {
  Table table = table_of(comparison);
  std::erase_if(table.rows, [](const auto& row) { return row[1].is_null() && row[2].is_null(); });
  return table;
}

std::string curves(const WalkComparison& comparison, const std::string& name, const std::string& title,
                   const std::string& unit) {
  const auto figure = std::ranges::find(comparison.figures, name, &ComparedFigure::name);
  if (figure->frames_of_a.empty() || figure->frames_of_b.empty()) return "";
  return fmt::format("<h2>{}</h2><figure>{}</figure>", title,
                     line_chart({"frame"}, {unit}, *comparison.frames,
                                {{"A: " + escaped(comparison.a.label), "#8a94a3", figure->frames_of_a},
                                 {"B: " + escaped(comparison.b.label), "#1565c0", figure->frames_of_b}}));
}

std::string plate(const char* letter, const ComparedWalk& walk) {
  const auto& [frame, file] = *walk.plate;
  return picture_html(read_input(file), fmt::format("{}: {}: frame {} from outside", letter, walk.label, frame));
}

}  // namespace

std::string text_of(const WalkComparison& comparison, const Paint& paint) {
  std::string text = fmt::format("A: {}\nB: {}\n", comparison.a.name, comparison.b.name);
  for (const Difference& d : comparison.differences) {
    text += paint(Colour::yellow, "not the same: " + text_of(d)) + '\n';
  }
  for (const std::string& doubt : doubts(comparison)) text += paint(Colour::yellow, "warning: " + doubt) + '\n';
  return text + '\n' + text_of(known_figures(comparison), paint) + '\n' + conclusion(comparison) + '\n';
}

Json json_of(const WalkComparison& comparison) {
  Json json{{"a", comparison.a.name}, {"b", comparison.b.name}};
  json["common_frames"] = comparison.frames ? Json(comparison.frames->size()) : Json();
  json["differences"] = Json::array();
  for (const Difference& d : comparison.differences)
    json["differences"].push_back({{"name", d.name}, {"a", d.a}, {"b", d.b}});
  json["control"] = if_known(comparison.control);
  json["control_of_processor"] = if_known(comparison.control_of_processor);
  json["warnings"] = doubts(comparison);
  json["figures"] = json_of(table_of(comparison));
  json["worse"] = comparison.worse();
  return json;
}

std::string comparison_page(const WalkComparison& comparison) {
  std::string body =
      fmt::format("<h1>{} and {}</h1><p class=\"lead\">Two walks compared. A: {}<br>B: {}</p>", escaped(comparison.a.label),
                  escaped(comparison.b.label), escaped(comparison.a.name), escaped(comparison.b.name));
  for (const Difference& d : comparison.differences) {
    body += fmt::format("<p>Not the same: {}</p>", escaped(text_of(d)));
  }
  for (const std::string& doubt : doubts(comparison)) body += fmt::format(R"(<p class="note">{}</p>)", escaped(doubt));
  if (comparison.a.plate) {
    body += fmt::format(R"(<div class="beside">{}{}</div>)", plate("A", comparison.a), plate("B", comparison.b));
  }
  if (comparison.frames && !comparison.frames->empty()) {
    body += curves(comparison, "mean.frame_ms", "Frame time", "milliseconds") +
            curves(comparison, "mean.cull_ms", "Culling", "milliseconds") +
            curves(comparison, "mean.cull_processor_ms", "Culling, time of the processor", "milliseconds") +
            curves(comparison, "mean.rendered_polygons", "Polygons drawn", "polygons");
  }
  body += section("Figures", html_of(known_figures(comparison)));
  body += fmt::format("<p class=\"soft\">{}.</p>", conclusion(comparison));
  return page("occlude compare", body);
}

}  // namespace occlude::render
