// SPDX-License-Identifier: MIT
#include "occlude/render/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "occlude/render/chart.h"
#include "occlude/render/page.h"
#include "occlude/render/summary.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

const char* word_for(Verdict verdict) {
  constexpr std::array<const char*, 4> kNames{"", "same", "better", "worse"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string number(const std::optional<double>& value) { return value ? fmt::format("{:.6g}", *value) : "-"; }

std::string ratio(const std::optional<double>& value) { return value ? fmt::format("{:.3f}", *value) : "-"; }

/// A mark stands at what changed, for better or worse.
std::string mark(const ComparedFigure& figure) { return figure.verdict == Verdict::same ? "" : word_for(figure.verdict); }

/// What the comparison rests on, and what got worse.
std::string conclusion(const WalkComparison& comparison) {
  const std::vector<std::string> worse = comparison.worse();
  const std::string frames = comparison.frames
                                 ? fmt::format("{} frames that both have", comparison.frames->size())
                                 : "no frames.csv on both sides: the noise of times is not known, so they are not judged";
  return fmt::format("{}; worse: {}", frames, worse.empty() ? "nothing" : fmt::format("{}", fmt::join(worse, ", ")));
}

/// A figure's cells, without its mark.
std::array<std::string, 7> cells(const ComparedFigure& f) {
  const auto of = [&](double Spread::*member) {
    return ratio(f.per_frame ? std::optional((*f.per_frame).*member) : std::nullopt);
  };
  return {f.name,
          number(f.a),
          number(f.b),
          ratio(f.ratio()),
          of(&Spread::median),
          of(&Spread::percentile_5),
          of(&Spread::percentile_95)};
}

constexpr std::array<const char*, 7> kHead{"", "A", "B", "B/A", "median of frames", "5 %", "95 %"};

std::string curves(const WalkComparison& comparison, const std::string& name, const std::string& title,
                   const std::string& unit) {
  const auto figure = std::ranges::find(comparison.figures, name, &ComparedFigure::name);
  if (figure->frames_of_a.empty() || figure->frames_of_b.empty()) return "";
  return fmt::format("<h2>{}</h2><figure>{}</figure>", title,
                     line_chart({"frame"}, {unit}, *comparison.frames,
                                {{"A", "#8a94a3", figure->frames_of_a}, {"B", "#1565c0", figure->frames_of_b}}));
}

}  // namespace

std::string text_of(const WalkComparison& comparison, const Paint& paint) {
  std::string text = fmt::format("A: {}\nB: {}\n", comparison.a, comparison.b);
  for (const Difference& d : comparison.differences) {
    text += paint(Colour::yellow, fmt::format("not the same: {}: {} and {}", d.name, d.a, d.b)) + '\n';
  }
  constexpr const char* kRow = "{:<36}{:>12}{:>12}{:>8}{:>18}{:>8}{:>8}  ";
  const auto row = [&](const auto& c) { return fmt::format(kRow, c[0], c[1], c[2], c[3], c[4], c[5], c[6]); };
  text += '\n' + row(kHead) + '\n';
  for (const ComparedFigure& figure : comparison.figures) {
    if (!figure.a && !figure.b) continue;
    const std::string marked = mark(figure);
    text +=
        row(cells(figure)) + (marked.empty() ? "" : paint(marked == "worse" ? Colour::red : Colour::green, marked)) + '\n';
  }
  return text + '\n' + conclusion(comparison) + '\n';
}

Json json_of(const WalkComparison& comparison) {
  const auto if_known = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  Json json{{"a", comparison.a}, {"b", comparison.b}};
  json["common_frames"] = comparison.frames ? Json(comparison.frames->size()) : Json();
  json["differences"] = Json::array();
  for (const Difference& d : comparison.differences)
    json["differences"].push_back({{"name", d.name}, {"a", d.a}, {"b", d.b}});
  json["figures"] = Json::array();
  for (const ComparedFigure& f : comparison.figures) {
    json["figures"].push_back({{"name", f.name},
                               {"a", if_known(f.a)},
                               {"b", if_known(f.b)},
                               {"ratio", if_known(f.ratio())},
                               {"per_frame", json_of(f.per_frame)},
                               {"verdict", f.verdict == Verdict::unjudged ? Json() : Json(word_for(f.verdict))}});
  }
  json["worse"] = comparison.worse();
  return json;
}

std::string comparison_page(const WalkComparison& comparison) {
  std::string body = fmt::format("<h1>Two walks compared</h1><p class=\"lead\">A: {}<br>B: {}</p>", escaped(comparison.a),
                                 escaped(comparison.b));
  for (const Difference& d : comparison.differences) {
    body += fmt::format("<p>Not the same: {}: {} and {}</p>", escaped(d.name), escaped(d.a), escaped(d.b));
  }
  if (comparison.frames && !comparison.frames->empty()) {
    body += curves(comparison, "mean.frame_ms", "Frame time", "milliseconds") +
            curves(comparison, "mean.cull_ms", "Culling", "milliseconds") +
            curves(comparison, "mean.rendered_polygons", "Polygons drawn", "polygons");
  }
  body += R"(<h2>Figures</h2><div class="wide"><table><thead><tr>)";
  for (const char* head : kHead) body += fmt::format("<th>{}</th>", head);
  body += "<th></th></tr></thead><tbody>\n";
  for (const ComparedFigure& figure : comparison.figures) {
    if (!figure.a && !figure.b) continue;
    body += "<tr>";
    for (const std::string& cell : cells(figure)) body += fmt::format("<td>{}</td>", cell);
    body += fmt::format("<td>{}</td></tr>\n", mark(figure));
  }
  body += fmt::format("</tbody></table></div><p class=\"soft\">{}.</p>", conclusion(comparison));
  return page("occlude compare", body);
}

}  // namespace occlude::render
