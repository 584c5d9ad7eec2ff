// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "ratios.h"
#include "report.h"

namespace occlude::bench {
namespace {

double percent(std::size_t part, std::size_t whole) { return 100 * static_cast<double>(part) / static_cast<double>(whole); }

Table workloads_table(const Result& result) {
  Table table{.title = fmt::format("Workloads of {} boxes, seed {}", result.options.boxes, result.options.seed),
              .head = {"% of the boxes", "inside", "partial", "outside"},
              .rows = {},
              .notes = {}};
  for (const WorkloadSummary& w : result.workloads) {
    const auto share = [&](std::size_t part) { return fmt::format("{:.1f}", percent(part, result.options.boxes)); };
    table.rows.push_back({w.name, share(w.inside), share(w.partial), share(w.outside)});
    table.notes.push_back(fmt::format("{}: {}", w.name, w.about));
  }
  return table;
}

Table times_table(const Result& result) {
  Table table{.title = fmt::format("Nanoseconds a box, medians of {} rounds, and % of the answers that are wrong",
                                   result.options.repetitions),
              .head = {"test"},
              .rows = {},
              .notes = {}};
  for (const WorkloadSummary& workload : result.workloads) table.head.push_back(workload.name);
  for (const std::string& subject : result.subjects) {
    table.rows.push_back({subject});
    for (const WorkloadSummary& workload : result.workloads) {
      const Measurement* m = find(result, subject, workload.name);
      table.rows.back().push_back(
          m ? fmt::format("{:.1f} ({:.2f} %)", median(m->ns), percent(m->wrong, result.options.boxes)) : "-");
    }
  }
  for (const PeerSummary& peer : result.peers) table.notes.push_back(fmt::format("{}: {}", peer.name, peer.shown_version()));
  return table;
}

Table ratios_table(const Result& result) {
  Table table{.title = "Ratios, medians of the rounds", .head = {"ratio", "value"}, .rows = {}, .notes = {}};
  for (const Ratio& ratio : ratios(result)) {
    table.rows.push_back({ratio.name.empty() ? ratio.group : ratio.group + '.' + ratio.name,
                          ratio.value ? fmt::format("{:.2f}", *ratio.value) : "-"});
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
              .head = {"test", "dot", "scalar", "add/sub", "cross"},
              .rows = {},
              .notes = {}};
  add_costs(table, paper_costs(), ", of the paper");
  add_costs(table, result.costs, ", counted here");
  return table;
}

}  // namespace

std::vector<Table> tables_of(const Result& result, const Machine& machine) {
  std::vector<Table> tables{workloads_table(result), times_table(result), ratios_table(result), table1(result)};
  tables.back().notes.push_back(
      fmt::format("{}, {} threads, {}, {}", machine.processor, machine.threads, machine.compiler, machine.flags));
  return tables;
}

std::string report_text(const Result& result, const Machine& machine) {
  std::string text;
  for (const Table& table : tables_of(result, machine)) text += (text.empty() ? "" : "\n") + text_of(table);
  return text;
}

}  // namespace occlude::bench
