// SPDX-License-Identifier: MIT
#include "campaign.h"

#include <time.h>

#include <atomic>
#include <new>

#include "base/parallel.h"

namespace occlude::fuzz {
namespace {

/// Processor time of this thread.
double core_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// An exception from an experiment is a finding, unless it is for want of memory.
void run_one(const Experiment& experiment, std::uint64_t seed, Report& report) {
  try {
    experiment.run(seed, report);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    ++report.tally.disagreements;
    report.findings.push_back({"exception", error.what()});
  }
  sign(report, experiment.name, seed);
}

}  // namespace

std::vector<Report> run(const Campaign& campaign, std::span<const Experiment> experiments,
                        const std::function<bool(std::uint64_t findings)>& go_on) {
  std::atomic<std::uint64_t> next = 0, found = 0;
  std::vector<std::vector<Report>> reports(campaign.jobs, std::vector<Report>(experiments.size()));
  const auto work = [&](std::vector<Report>& own) {
    for (std::uint64_t i = next++; i < campaign.rounds * experiments.size() && go_on(found); i = next++) {
      const std::size_t experiment = i % experiments.size();
      Report group;
      const double start = core_seconds();
      run_one(experiments[experiment], campaign.seed + i / experiments.size(), group);
      group.core_seconds = core_seconds() - start;
      found += group.tally.disagreements;
      add(own[experiment], std::move(group));
    }
  };
  // Fewer threads than there are jobs give the same result.
  const culler::Checkpoint on_own_threads(culler::Executor::own_threads(campaign.jobs));
  culler::parallel_for(
      campaign.jobs, [&](std::size_t job) { work(reports[job]); }, on_own_threads);
  std::vector<Report> whole(experiments.size());
  for (std::vector<Report>& own : reports) {
    for (std::size_t e = 0; e < whole.size(); ++e) add(whole[e], std::move(own[e]));
  }
  return whole;
}

}  // namespace occlude::fuzz
