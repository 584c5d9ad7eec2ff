// SPDX-License-Identifier: MIT
#include "measure.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>

namespace occlude::bench {
namespace {

/// How long a trial runs in a round: long compared with the clock's resolution, short compared with changes in the speed of
/// the machine.
constexpr double kSeconds = 0.01;

/// Reports the time of each trial to `sink`. A benchmark is named by the index of its trial.
class Collector : public benchmark::BenchmarkReporter {
 public:
  using Sink = std::function<void(std::size_t trial, double seconds_a_pass)>;
  explicit Collector(Sink sink) : sink_(std::move(sink)) {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        sink_(std::stoul(run.run_name.function_name), run.cpu_accumulated_time / static_cast<double>(run.iterations));
      }
    }
  }

 private:
  Sink sink_;
};

/// While this object lives, the trials are registered as benchmarks.
class Registration {
 public:
  explicit Registration(std::span<Trial> trials) {
    for (std::size_t i = 0; i < trials.size(); ++i) {
      benchmarks_.push_back(
          benchmark::RegisterBenchmark(std::to_string(i).c_str(), [&trial = trials[i]](benchmark::State& state) {
            for (auto _ : state) {
              trial.pass(trial.answers);
              benchmark::ClobberMemory();
            }
          }));
      benchmarks_.back()->Iterations(1);
    }
  }
  ~Registration() { benchmark::ClearRegisteredBenchmarks(); }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

  void set_passes(std::size_t trial, double seconds_a_pass) {
    const double passes = seconds_a_pass > 0 ? std::ceil(kSeconds / seconds_a_pass) : 1;
    benchmarks_[trial]->Iterations(static_cast<benchmark::IterationCount>(passes));
  }

 private:
  std::vector<benchmark::internal::Benchmark*> benchmarks_;
};

void shuffle_each_round() {
  std::string program = "occlude bench", shuffle = "--benchmark_enable_random_interleaving=true";
  std::array<char*, 3> arguments{program.data(), shuffle.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
}

void run_round(Collector::Sink sink) {
  Collector collector(std::move(sink));
  benchmark::RunSpecifiedBenchmarks(&collector, "all");
}

}  // namespace

void measure(std::span<Trial> trials, std::size_t rounds, const Progress& progress) {
  shuffle_each_round();
  Registration registration(trials);
  run_round([&](std::size_t trial, double seconds) { registration.set_passes(trial, seconds); });
  for (std::size_t round = 0; round < rounds; ++round) {
    progress(round);
    run_round([&](std::size_t trial, double seconds) {
      const auto boxes = static_cast<double>(trials[trial].answers.size());
      trials[trial].ns.push_back(1e9 * seconds / boxes);
    });
  }
  progress(rounds);
}

}  // namespace occlude::bench
