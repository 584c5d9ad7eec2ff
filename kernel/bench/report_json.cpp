// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "occlude/render/machine.h"
#include "ratios.h"
#include "report.h"

namespace occlude::bench {
namespace {

using Json = nlohmann::ordered_json;

Json ratios_json(const Result& result) {
  Json json;
  for (const Ratio& ratio : ratios(result)) {
    const Json value = ratio.value ? Json(*ratio.value) : Json(nullptr);
    if (ratio.name.empty()) {
      json[ratio.group] = value;
    } else {
      json[ratio.group][ratio.name] = value;
    }
  }
  return json;
}

Json operations_json(const kernel::Operations& operations) {
  return {
      {"dot", operations.dot}, {"scalar", operations.scalar}, {"vector", operations.vector}, {"cross", operations.cross}};
}

Json costs_json(const std::vector<Cost>& costs) {
  Json json;
  for (const Cost& cost : costs) {
    json[cost.test] = {{"worst", operations_json(cost.worst)}, {"best", operations_json(cost.best)}};
  }
  return json;
}

Json answers_json(const Result& result) {
  Json json;
  for (const WorkloadSummary& workload : result.workloads) {
    json[workload.name] = {{"about", workload.about},
                           {"inside", workload.inside},
                           {"partial", workload.partial},
                           {"outside", workload.outside}};
  }
  for (const Measurement& m : result.measurements) json[m.workload]["wrong"][m.subject] = m.wrong;
  return json;
}

Json ns_json(const Result& result) {
  Json json;
  for (const Measurement& m : result.measurements) json[m.workload][m.subject] = median(m.ns);
  return json;
}

}  // namespace

Json json_of(const std::vector<PeerSummary>& peers) {
  Json json = Json::array();
  for (const PeerSummary& peer : peers) json.push_back({{"name", peer.name}, {"version", peer.shown_version()}});
  return json;
}

std::string report_json(const Result& result) {
  Json machine = json_of(render::this_machine());
  machine["flags"] = OCCLUDE_BENCH_FLAGS;
  const Json json{
      {"boxes", result.options.boxes},
      {"repetitions", result.options.repetitions},
      {"seed", result.options.seed},
      {"ratios", ratios_json(result)},
      {"fastest_gjk", result.fastest_gjk.empty() ? Json(nullptr) : Json(result.fastest_gjk)},
      {"operations", {{"paper", costs_json(paper_costs())}, {"measured", costs_json(result.costs)}}},
      {"ns", ns_json(result)},
      {"answers", answers_json(result)},
      {"peers", json_of(result.peers)},
      {"machine", machine},
  };
  return json.dump(2) + '\n';
}

}  // namespace occlude::bench
