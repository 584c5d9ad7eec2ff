// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "occlude/render/machine.h"
#include "ratios.h"
#include "report.h"

namespace occlude::bench {
namespace {

using render::percent;
using render::rounded;
using render::Table;

double share(std::size_t part, const Result& result) {
  return static_cast<double>(part) / static_cast<double>(result.options.boxes);
}

Table workloads_table(const Result& result) {
  Table table{.title = fmt::format("Workloads of {} boxes, seed {}", result.options.boxes, result.options.seed),
              .columns = {{"of the boxes"}, {"inside", "", percent}, {"partial", "", percent}, {"outside", "", percent}},
              .rows = {}};
  for (const WorkloadSummary& w : result.workloads) {
    table.rows.push_back({w.name, share(w.inside, result), share(w.partial, result), share(w.outside, result)});
    table.notes.push_back(fmt::format("{}: {}", w.name, w.about));
  }
  return table;
}

Table times_table(const Result& result) {
  Table table{.title = fmt::format("Nanoseconds a box, medians of {} rounds, and % of the answers that are wrong",
                                   result.options.repetitions),
              .columns = {{"test"}},
              .rows = {}};
  for (const WorkloadSummary& workload : result.workloads) table.columns.push_back({workload.name});
  for (const std::string& subject : result.subjects) {
    table.rows.push_back({subject});
    for (const WorkloadSummary& workload : result.workloads) {
      const Measurement* m = find(result, subject, workload.name);
      table.rows.back().push_back(
          m ? render::Cell(fmt::format("{:.1f} ({:.2f} %)", median(m->ns), 100 * share(m->wrong, result))) : nullptr);
    }
  }
  for (const PeerSummary& peer : result.peers) table.notes.push_back(fmt::format("{}: {}", peer.name, peer.shown_version()));
  return table;
}

Table ratios_table(const Result& result) {
  Table table{.title = "Ratios, medians of the rounds", .columns = {{"ratio"}, {"value", "", rounded<2>}}, .rows = {}};
  for (const Ratio& ratio : ratios(result)) {
    table.rows.push_back({ratio.name.empty() ? ratio.group : ratio.group + '.' + ratio.name, render::if_known(ratio.value)});
    if (ratio.group == "gjk_over_certified") {
      table.notes.push_back(
          fmt::format("gjk_over_certified: {}; the paper: at least 2", ratio.slow.empty() ? "no such library" : ratio.slow));
    }
  }
  return table;
}

void add_costs(Table& table, const std::vector<Cost>& costs, const char* source) {
  const auto cell = [](const auto& most, const auto& fewest) { return fmt::format("{} /{:>3}", most, fewest); };
  for (const auto& [test, worst, best] : costs) {
    table.rows.push_back({test + source, cell(worst.dot, best.dot), cell(worst.scalar, best.scalar),
                          cell(worst.vector, best.vector), cell(worst.cross, best.cross)});
  }
}

Table table1(const Result& result) {
  Table table{.title = "Operations, worst / best (Table 1 of the paper)",
              .columns = {{"test"}, {"dot"}, {"scalar"}, {"add/sub"}, {"cross"}},
              .rows = {}};
  add_costs(table, paper_costs(), ", of the paper");
  add_costs(table, result.costs, ", counted here");
  return table;
}

}  // namespace

std::vector<Table> tables_of(const Result& result) {
  std::vector<Table> tables{workloads_table(result), times_table(result), ratios_table(result), table1(result)};
  tables.back().notes.push_back(text_of(render::this_machine()) + ", " + OCCLUDE_BENCH_FLAGS);
  return tables;
}

std::string report_text(const Result& result) {
  std::string text;
  for (const Table& table : tables_of(result)) text += (text.empty() ? "" : "\n") + text_of(table);
  return text;
}

}  // namespace occlude::bench
