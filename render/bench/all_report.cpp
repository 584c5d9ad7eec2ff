// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "all_bench.h"
#include "occlude/render/machine.h"
#include "occlude/render/page.h"
#include "occlude/render/table.h"

namespace occlude::experiments {
namespace {

using Json = nlohmann::ordered_json;
using render::Table;

/// What was measured of boxes; the culls beside ours have a table of their own.
Table boxes_beside(const AllResult& all) {
  constexpr auto kTwo = render::rounded<2>;
  Table table{
      .title = "Boxes against one shadow frustum, beside other projects",
      .columns = {{"test"},
                  {"ns a box", "", kTwo},
                  {"certified overlap test, ns", "", kTwo},
                  {"ratio", "", kTwo},
                  {"wrong", "", render::percent}},
      .rows = {},
      .notes = {"Times are of random boxes. Wrong are answers where boxes touch within an ulp; none of the certified "
                "test's are."}};
  for (const Beside& row : beside(all)) {
    if (row.what != Beside::What::box) continue;
    table.rows.push_back({row.way, row.theirs, row.ours, row.ratio, row.wrong});
  }
  for (const bench::PeerSummary& peer : all.kernel.peers) {
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
         report_text(all.kernel) + "\n" + report_text(all.culler.result, all.culler.options) + "\n" +
         text_of(table_of(all.scene.result, all.scene.options)) + "\n" +
         text_of(table_of(all.town.result, all.town.options)) + "\n" + text_of(table_of(all.held.result, all.held.options));
}

std::string report_json(const AllResult& all) {
  // Each part is what its own command prints.
  const Json json{{"ratios", ratios_json(all)},
                  {"kernel", Json::parse(report_json(all.kernel))},
                  {"culler", Json::parse(report_json(all.culler.result, all.culler.options))},
                  {"scene", Json::parse(json_of(all.scene.result, all.scene.options))},
                  {"town", Json::parse(json_of(all.town.result, all.town.options))},
                  {"rivals", Json::parse(json_of(all.visibility.result, all.visibility.options))},
                  {"held", Json::parse(json_of(all.held.result, all.held.options))},
                  {"machine", json_of(render::this_machine())}};
  return json.dump(2) + "\n";
}

std::string report_html(const AllResult& all) {
  std::string body =
      fmt::format(R"(<h1>All benchmarks</h1><p class="lead">{}.</p>)", render::escaped(text_of(render::this_machine())));
  body += section(boxes_beside(all)) + section(table_of(all.visibility.result, all.visibility.options));
  body += "<h1>The kernel</h1>";
  for (const Table& table : tables_of(all.kernel)) body += section(table);
  body += "<h1>The culler on " + render::escaped(all.culler.result.model) + "</h1>";
  body += report_sections(all.culler.result, all.culler.options);
  body += "<h1>Worlds that change</h1>" + section(table_of(all.scene.result, all.scene.options)) +
          section(table_of(all.town.result, all.town.options));
  body += "<h1>Culls that hold</h1>" + section(table_of(all.held.result, all.held.options));
  return render::page("occlude: all benchmarks", body);
}

}  // namespace occlude::experiments
