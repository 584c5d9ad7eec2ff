// SPDX-License-Identifier: MIT
#include "all_bench.h"

#include <algorithm>

#include "own_ways.h"
#include "ratios.h"

namespace occlude::experiments {
namespace {

void add_boxes(const AllResult& all, std::vector<Beside>& rows) {
  const bench::Result& kernel = all.kernel;
  for (const bench::Ratio& ratio : bench::peer_ratios(kernel)) {
    const bench::Measurement* const touching = bench::find(kernel, ratio.slow, "ulp_touching");
    if (!ratio.value || touching == nullptr) continue;
    const auto ns = [&](const std::string& subject) {
      return bench::median(bench::find(kernel, subject, ratio.workload)->ns);
    };
    rows.push_back({ratio.group, Beside::What::box, ratio.slow, ns(ratio.slow), ns(ratio.fast), *ratio.value,
                    static_cast<double>(touching->wrong) / static_cast<double>(kernel.options.boxes)});
  }
}

void add_culls(const AllResult& all, std::vector<Beside>& rows) {
  const VisibilityResult& visibility = all.visibility.result;
  const double ours = way_of(visibility, kByCover).cull_ms;
  for (const WayResult& way : visibility.ways) {
    if (way.project == kOurs) continue;
    rows.push_back({way.project, Beside::What::cull, way.name, way.cull_ms, ours, way.cull_ms / ours,
                    static_cast<double>(way.false_culls)});
  }
}

}  // namespace

std::vector<bench::PeerSummary> projects(const AllResult& all) {
  std::vector<bench::PeerSummary> projects = all.kernel.peers;
  for (const bench::PeerSummary& rival : all.visibility.result.rivals) {
    const auto known = std::ranges::find(projects, rival.name, &bench::PeerSummary::name);
    if (known == projects.end()) {
      projects.push_back(rival);
    } else if (known->version.empty()) {
      *known = rival;
    }
  }
  return projects;
}

std::vector<Beside> beside(const AllResult& all) {
  std::vector<Beside> rows;
  add_boxes(all, rows);
  add_culls(all, rows);
  return rows;
}

}  // namespace occlude::experiments
