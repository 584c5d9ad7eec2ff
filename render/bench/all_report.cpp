// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "all_bench.h"
#include "html_table.h"
#include "occlude/render/machine.h"
#include "occlude/render/page.h"

namespace occlude::experiments {
namespace {

using Json = nlohmann::ordered_json;

Table beside_table(const AllResult& all) {
  Table table{
      .title = "Beside other projects",
      .head = {"way", "measured", "theirs", "ours", "theirs over ours", "wrong"},
      .rows = {},
      .notes = {"Boxes are random, against one shadow frustum; ours is the certified overlap test. Wrong are answers "
                "where boxes touch within an ulp: none of ours.",
                "Culls are of the same frames and leaves; ours is by joined shadows. Wrong are false culls over all "
                "frames. What else was culled is in the last table."}};
  for (const Beside& row : beside(all)) {
    const bool is_box = row.what == Beside::What::box;
    table.rows.push_back({row.way, is_box ? "a box, ns" : "a frame's cull, ms", fmt::format("{:.2f}", row.theirs),
                          fmt::format("{:.2f}", row.ours), fmt::format("{:.2f}", row.ratio),
                          is_box ? render::percent(row.wrong) : render::grouped(row.wrong)});
  }
  for (const bench::PeerSummary& project : projects(all)) {
    table.notes.push_back(fmt::format("{}: {}", project.name, project.shown_version()));
  }
  return table;
}

/// For each project a ratio for each way to ask it, or "not installed".
Json ratios_json(const AllResult& all) {
  Json json = Json::object();
  for (const bench::PeerSummary& project : projects(all)) {
    json[project.name] = project.version.empty() ? Json(project.shown_version()) : Json{{"version", project.version}};
  }
  for (const Beside& row : beside(all)) {
    json[row.project][row.what == Beside::What::box ? "box_ns" : "cull_ms"][row.way] = {
        {"theirs", row.theirs}, {"ours", row.ours}, {"ratio", row.ratio}, {"wrong", row.wrong}};
  }
  return json;
}

}  // namespace

std::string report_text(const AllResult& all) {
  return text_of(beside_table(all)) + "\n" + report_text(all.kernel.result, all.kernel.options) + "\n" +
         report_text(all.culler.result, all.culler.options) + "\n" + text_of(table_of(all.scene.result, all.scene.options)) +
         "\n" + text_of(table_of(all.town.result, all.town.options)) + "\n" +
         text_of(table_of(all.visibility.result, all.visibility.options));
}

std::string report_json(const AllResult& all) {
  // Each part is what its own command prints.
  const Json json{{"ratios", ratios_json(all)},
                  {"kernel", Json::parse(report_json(all.kernel.result, all.kernel.options))},
                  {"culler", Json::parse(report_json(all.culler.result, all.culler.options))},
                  {"scene", Json::parse(json_of(all.scene.result, all.scene.options))},
                  {"town", Json::parse(json_of(all.town.result, all.town.options))},
                  {"rivals", Json::parse(json_of(all.visibility.result, all.visibility.options))},
                  {"machine", {{"processor", render::processor_name()}, {"compiler", render::compiler_name()}}}};
  return json.dump(2) + "\n";
}

std::string report_html(const AllResult& all) {
  std::string body = fmt::format(R"(<h1>All benchmarks</h1><p class="lead">{}; {}.</p>)",
                                 render::escaped(render::processor_name()), render::escaped(render::compiler_name()));
  body += section(beside_table(all));
  body += "<h1>The kernel</h1>";
  for (const Table& table : tables_of(all.kernel.result, all.kernel.options)) body += section(table);
  body += "<h1>The culler on " + render::escaped(all.culler.result.model) + "</h1>";
  body += report_sections(all.culler.result, all.culler.options);
  body += "<h1>Worlds that change</h1>" + section(table_of(all.scene.result, all.scene.options)) +
          section(table_of(all.town.result, all.town.options));
  body += "<h1>What is visible</h1>" + section(table_of(all.visibility.result, all.visibility.options));
  return render::page("occlude: all benchmarks", body);
}

}  // namespace occlude::experiments
