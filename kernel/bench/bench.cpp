// SPDX-License-Identifier: MIT
#include "bench.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "batch.h"
#include "kernel_subjects.h"
#include "subject.h"

namespace occlude::bench {
namespace {

using kernel::Relation;

WorkloadSummary summary(const Workload& workload) {
  const std::vector<Relation> truth = exact_answers(workload);
  const auto count = [&](Relation relation) { return static_cast<std::size_t>(std::ranges::count(truth, relation)); };
  return {workload.name, workload.about, count(Relation::inside), count(Relation::partial), count(Relation::outside)};
}

PeerResults peer_results(const Options& options, const Progress& progress) {
  if (options.peers.empty()) return {};
  return run_peers(
      {options.peers, std::to_string(options.boxes), std::to_string(options.repetitions), std::to_string(options.seed)},
      [&](std::size_t round) { progress(options.repetitions + round); });
}

void add_peers(Result& result, PeerResults&& found) {
  for (const KnownPeer& known : kKnownPeers) {
    const auto peer = std::ranges::find(found.peers, known.name, &PeerSummary::name);
    result.peers.push_back(peer == found.peers.end() ? PeerSummary{known.name, ""} : *peer);
  }
  std::ranges::move(found.measurements, std::back_inserter(result.measurements));
}

std::string fastest_gjk(const Result& result) {
  std::string fastest;
  double least = 0;
  for (const Measurement& m : result.measurements) {
    if (!m.gjk || m.workload != "random") continue;
    const double ns = median(m.ns);
    if (fastest.empty() || ns < least) {
      fastest = m.subject;
      least = ns;
    }
  }
  return fastest;
}

}  // namespace

Result run(const Options& options, const Progress& progress) {
  Result result;
  result.options = options;
  const std::vector<Workload> workloads = make_workloads(options.boxes, options.seed);
  std::vector<Subject> subjects = kernel_subjects();
  std::ranges::move(batch_subjects(), std::back_inserter(subjects));
  std::ranges::transform(workloads, std::back_inserter(result.workloads), summary);
  result.measurements = measure(workloads, subjects, options.repetitions, progress);
  PeerResults found;
  try {
    found = peer_results(options, progress);
  } catch (const PeersFault& fault) {
    result.peers_fault = fault.what();
  }
  add_peers(result, std::move(found));
  for (const Measurement& m : result.measurements) {
    if (m.workload == workloads[0].name) result.subjects.push_back(m.subject);
  }
  result.fastest_gjk = fastest_gjk(result);
  result.costs = measured_costs(workloads);
  return result;
}

const Measurement* find(const Result& result, std::string_view subject, std::string_view workload) {
  const auto found = std::ranges::find_if(
      result.measurements, [&](const Measurement& m) { return m.subject == subject && m.workload == workload; });
  return found == result.measurements.end() ? nullptr : &*found;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

double median_ratio(std::vector<double> values, const std::vector<double>& references) {
  std::ranges::transform(values, references, values.begin(), std::divides());
  return median(std::move(values));
}

double ratio(const Measurement& subject, const Measurement& reference) { return median_ratio(subject.ns, reference.ns); }

}  // namespace occlude::bench
