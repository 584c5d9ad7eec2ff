// SPDX-License-Identifier: MIT
#include "bench.h"

#include <algorithm>

#include "batch.h"
#include "kernel_subjects.h"
#include "occlude/kernel/overlap.h"
#include "peers/peers.h"
#include "subject.h"

namespace occlude::bench {
namespace {

using kernel::Relation;

std::vector<Relation> exact_answers(const Workload& workload) {
  std::vector<Relation> answers;
  answers.reserve(workload.boxes.size());
  for (const kernel::Aabb& box : workload.boxes) {
    answers.push_back(kernel::overlap_certified(workload.frustum, box).relation);
  }
  return answers;
}

WorkloadSummary summary(const Workload& workload, const std::vector<Relation>& truth) {
  const auto count = [&](Relation relation) { return static_cast<std::size_t>(std::ranges::count(truth, relation)); };
  return {workload.name, workload.about, count(Relation::inside), count(Relation::partial), count(Relation::outside)};
}

std::size_t count_wrong(Question question, const std::vector<Relation>& answers, const std::vector<Relation>& truth) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) wrong += is_wrong(question, answers[i], truth[i]) ? 1 : 0;
  return wrong;
}

/// Every subject on every workload, workload by workload.
std::vector<Trial> make_trials(const std::vector<Workload>& workloads, const std::vector<Subject>& subjects) {
  std::vector<Trial> trials;
  for (const Workload& workload : workloads) {
    for (const Subject& subject : subjects) {
      trials.push_back({subject.prepare(workload), std::vector<Relation>(workload.boxes.size()), {}});
    }
  }
  return trials;
}

/// Moves the installed peers' subjects to the others and notes who is there.
std::vector<PeerSummary> add_peers(std::vector<Subject>& subjects) {
  std::vector<PeerSummary> summaries;
  for (Peer& peer : peers()) {
    summaries.push_back({peer.name, peer.version});
    std::ranges::move(peer.subjects, std::back_inserter(subjects));
  }
  return summaries;
}

std::string fastest_gjk(const Result& result, const std::vector<Subject>& subjects) {
  std::string fastest;
  double least = 0;
  for (const Subject& subject : subjects) {
    if (!subject.gjk) continue;
    const double ns = median(find(result, subject.name, "random")->ns);
    if (fastest.empty() || ns < least) {
      fastest = subject.name;
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
  result.peers = add_peers(subjects);
  for (const Subject& subject : subjects) result.subjects.push_back(subject.name);

  std::vector<Trial> trials = make_trials(workloads, subjects);
  measure(trials, options.repetitions, progress);

  auto trial = trials.begin();
  for (const Workload& workload : workloads) {
    const std::vector<Relation> truth = exact_answers(workload);
    result.workloads.push_back(summary(workload, truth));
    for (const Subject& subject : subjects) {
      const std::size_t wrong = count_wrong(subject.question, trial->answers, truth);
      result.measurements.push_back({subject.name, workload.name, std::move(trial->ns), wrong});
      ++trial;
    }
  }
  result.fastest_gjk = fastest_gjk(result, subjects);
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

double ratio(const Measurement& subject, const Measurement& reference) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < subject.ns.size(); ++round) {
    ratios.push_back(subject.ns[round] / reference.ns[round]);
  }
  return median(std::move(ratios));
}

}  // namespace occlude::bench
