// SPDX-License-Identifier: MIT
#include "ratios.h"

namespace occlude::bench {
namespace {

std::optional<double> value(const Result& result, const std::string& slow, const std::string& fast,
                            const std::string& workload) {
  const Measurement* subject = find(result, slow, workload);
  const Measurement* reference = find(result, fast, workload);
  if (subject == nullptr || reference == nullptr) return std::nullopt;
  return ratio(*subject, *reference);
}

}  // namespace

std::vector<Ratio> ratios(const Result& result) {
  std::vector<Ratio> all;
  const auto add = [&](const char* group, const std::string& name, const std::string& slow, const std::string& fast,
                       const std::string& workload) {
    all.push_back({group, name, slow, fast, workload, value(result, slow, fast, workload)});
  };
  for (const WorkloadSummary& workload : result.workloads) {
    add("certified_over_plain", workload.name, "overlap_certified", "overlap_plain", workload.name);
  }
  for (const std::string set : {"sse2", "avx2", "avx512"}) {
    add("batch_speedup", set, "conservative_plain", "batch_conservative_" + set, "random");
  }
  add("gjk_over_certified", "", result.fastest_gjk, kReference, "random");
  return all;
}

std::vector<Ratio> peer_ratios(const Result& result) {
  std::vector<Ratio> all;
  for (const KnownPeer& peer : kKnownPeers) {
    for (const std::string& subject : result.subjects) {
      if (!subject.starts_with(peer.prefix)) continue;
      all.push_back({peer.name, subject, subject, kReference, "random", value(result, subject, kReference, "random")});
    }
  }
  return all;
}

}  // namespace occlude::bench
