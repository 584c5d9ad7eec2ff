// SPDX-License-Identifier: MIT
#include "measurement.h"

#include <utility>

#include "occlude/kernel/overlap.h"

namespace occlude::bench {
namespace {

using kernel::Relation;

std::size_t count_wrong(Question question, const std::vector<Relation>& answers, const std::vector<Relation>& truth) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) wrong += is_wrong(question, answers[i], truth[i]) ? 1 : 0;
  return wrong;
}

}  // namespace

std::vector<Relation> exact_answers(const Workload& workload) {
  std::vector<Relation> answers;
  answers.reserve(workload.boxes.size());
  for (const kernel::Aabb& box : workload.boxes) {
    answers.push_back(kernel::overlap_certified(workload.frustum, box).relation);
  }
  return answers;
}

std::vector<Measurement> measure(std::span<const Workload> workloads, std::span<const Subject> subjects, std::size_t rounds,
                                 const Progress& progress) {
  std::vector<Trial> trials;
  for (const Workload& workload : workloads) {
    for (const Subject& subject : subjects) {
      trials.push_back({subject.prepare(workload), std::vector<Relation>(workload.boxes.size()), {}});
    }
  }
  measure(trials, rounds, progress);
  std::vector<Measurement> measurements;
  auto trial = trials.begin();
  for (const Workload& workload : workloads) {
    const std::vector<Relation> truth = exact_answers(workload);
    for (const Subject& subject : subjects) {
      const std::size_t wrong = count_wrong(subject.question, trial->answers, truth);
      measurements.push_back({subject.name, workload.name, std::move(trial->ns), wrong, subject.gjk});
      ++trial;
    }
  }
  return measurements;
}

}  // namespace occlude::bench
