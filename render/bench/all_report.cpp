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

/// What was measured of boxes; the culls beside ours have a table of their own.
Table boxes_beside(const AllResult& all) {
  Table table{
      .title = "Boxes against one shadow frustum, beside other projects",
      .head = {"test", "ns a box", "certified overlap test, ns", "ratio", "wrong, %"},
      .rows = {},
      .notes = {"Times are of random boxes. Wrong are answers where boxes touch within an ulp; none of the certified "
                "test's are."}};
  for (const Beside& row : beside(all)) {
    if (row.what != Beside::What::box) continue;
    const auto two = [](double number) { return fmt::format("{:.2f}", number); };
    table.rows.push_back({row.way, two(row.theirs), two(row.ours), two(row.ratio), two(100 * row.wrong)});
  }
  for (const bench::PeerSummary& peer : all.kernel.result.peers) {
    table.notes.push_back(fmt::format("{}: {}", peer.name, peer.shown_version()));
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
  return text_of(boxes_beside(all)) + "\n" + text_of(table_of(all.visibility.result, all.visibility.options)) + "\n" +
         report_text(all.kernel.result, all.kernel.options) + "\n" + report_text(all.culler.result, all.culler.options) +
         "\n" + text_of(table_of(all.scene.result, all.scene.options)) + "\n" +
         text_of(table_of(all.town.result, all.town.options));
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
  body += section(boxes_beside(all)) + section(table_of(all.visibility.result, all.visibility.options));
  body += "<h1>The kernel</h1>";
  for (const Table& table : tables_of(all.kernel.result, all.kernel.options)) body += section(table);
  body += "<h1>The culler on " + render::escaped(all.culler.result.model) + "</h1>";
  body += report_sections(all.culler.result, all.culler.options);
  body += "<h1>Worlds that change</h1>" + section(table_of(all.scene.result, all.scene.options)) +
          section(table_of(all.town.result, all.town.options));
  return render::page("occlude: all benchmarks", body);
}

}  // namespace occlude::experiments
