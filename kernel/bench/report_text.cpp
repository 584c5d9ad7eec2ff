// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>

#include "ratios.h"
#include "report.h"

namespace occlude::bench {
namespace {

using Text = fmt::memory_buffer;

template <class... Arguments>
void print(Text& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

double percent(std::size_t part, std::size_t whole) { return 100 * static_cast<double>(part) / static_cast<double>(whole); }

void print_workloads(Text& text, const Result& result) {
  print(text, "{} boxes a workload, seed {}, medians of {} rounds\n\n", result.options.boxes, result.options.seed,
        result.options.repetitions);
  print(text, "{:<18}{:>9}{:>9}{:>9}\n", "% of the boxes", "inside", "partial", "outside");
  for (const WorkloadSummary& w : result.workloads) {
    const auto share = [&](std::size_t part) { return percent(part, result.options.boxes); };
    print(text, "{:<18}{:>9.1f}{:>9.1f}{:>9.1f}  {}\n", w.name, share(w.inside), share(w.partial), share(w.outside),
          w.about);
  }
}

void print_times(Text& text, const Result& result) {
  print(text, "\n{:<30}", "ns a box, % wrong");
  for (const WorkloadSummary& workload : result.workloads) print(text, "{:>20}", workload.name);
  print(text, "\n");
  for (const std::string& subject : result.subjects) {
    print(text, "{:<30}", subject);
    for (const WorkloadSummary& workload : result.workloads) {
      if (const Measurement* m = find(result, subject, workload.name)) {
        print(text, "{:>12.1f}{:>8.2f}", median(m->ns), percent(m->wrong, result.options.boxes));
      }
    }
    print(text, "\n");
  }
  for (const PeerSummary& peer : result.peers) {
    print(text, "{}: {}\n", peer.name, peer.version.empty() ? "not installed" : peer.version);
  }
}

void print_ratios(Text& text, const Result& result) {
  print(text, "\nRatios, median over the rounds\n");
  for (const Ratio& ratio : ratios(result)) {
    print(text, "{:<40}", ratio.name.empty() ? ratio.group : ratio.group + '.' + ratio.name);
    print(text, "{}", ratio.value ? fmt::format("{:>7.2f}", *ratio.value) : "      -");
    if (ratio.group == "gjk_over_certified") {
      print(text, "  {}; the paper: at least 2", ratio.slow.empty() ? "no such library" : ratio.slow);
    }
    print(text, "\n");
  }
}

void print_costs(Text& text, const std::vector<Cost>& costs) {
  for (const auto& [test, worst, best] : costs) {
    print(text, "{:<28}{:>6} /{:>4}{:>6} /{:>4}{:>6} /{:>4}{:>6} /{:>4}\n", test, worst.dot, best.dot, worst.scalar,
          best.scalar, worst.vector, best.vector, worst.cross, best.cross);
  }
}

void print_table1(Text& text, const Result& result) {
  print(text, "\n{:<28}{:>12}{:>12}{:>12}{:>12}\n", "Table 1, worst / best", "dot", "scalar", "add/sub", "cross");
  print(text, "of the paper\n");
  print_costs(text, paper_costs());
  print(text, "counted here\n");
  print_costs(text, result.costs);
}

}  // namespace

std::string report_text(const Result& result, const Machine& machine) {
  Text text;
  print_workloads(text, result);
  print_times(text, result);
  print_ratios(text, result);
  print_table1(text, result);
  print(text, "\n{}, {} threads, {}, {}\n", machine.processor, machine.threads, machine.compiler, machine.flags);
  return fmt::to_string(text);
}

}  // namespace occlude::bench
