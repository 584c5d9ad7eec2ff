// SPDX-License-Identifier: MIT
// occlude fuzz: the kernel and the culler against the exact oracle, case by case.
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

#include "case_line.h"
#include "command_arguments.h"
#include "commands.h"
#include "differential/campaign.h"
#include "differential/minimise.h"
#include "differential/overlap.h"
#include "occlude/render/errors.h"
#include "occlude/render/output_file.h"
#include "occlude/render/progress.h"
#include "results.h"

namespace occlude::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kDefaultCases = 1'000'000;

struct Arguments {
  std::vector<std::string> families, files, merged;
  std::uint64_t cases = 0;
  double seconds = 0;
  std::string seed = "1", shard = "0/1", findings = "fuzz_findings.jsonl", out;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool stop_at_first = false, json = false;
};

std::vector<fuzz::Experiment> chosen(const std::vector<std::string>& families) {
  std::vector<fuzz::Experiment> result;
  for (const fuzz::Experiment& experiment : fuzz::experiments()) {
    if (families.empty() || std::ranges::find(families, experiment.name) != families.end()) result.push_back(experiment);
  }
  return result;
}

/// "i/n" as shard i of n.
void read_shard(const std::string& text, fuzz::Campaign& campaign) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  campaign.shard = whole_number("--shard", text.substr(0, slash));
  campaign.shards = whole_number("--shard", text.substr(std::min(slash + 1, text.size())));
  if (campaign.shard >= campaign.shards) throw CLI::ValidationError("--shard", "expected i/n with i from 0 to n - 1");
}

fuzz::Campaign campaign_of(const Arguments& a, std::size_t experiments) {
  fuzz::Campaign campaign;
  campaign.seed = whole_number("--seed", a.seed);
  read_shard(a.shard, campaign);
  campaign.jobs = a.jobs;
  const std::uint64_t per_round = experiments * fuzz::kGroup;
  const std::uint64_t cases = a.cases != 0 ? a.cases : kDefaultCases;
  constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max() / 1'000'000;
  campaign.rounds = a.seconds > 0 ? kEndless : (cases + per_round - 1) / per_round;
  return campaign;
}

/// Runs until the cases are done, the time is over, a finding is enough, or the user has seen enough.
std::vector<fuzz::Report> run_watched(const Arguments& a, const fuzz::Campaign& campaign,
                                      const std::vector<fuzz::Experiment>& experiments, bool& interrupted) {
  const auto end = Clock::now() + std::chrono::duration<double>(a.seconds > 0 ? a.seconds : 1e9);
  const std::uint64_t groups = campaign.rounds / campaign.shards * experiments.size();
  render::Progress progress(a.seconds > 0 ? "seconds" : "groups",
                            a.seconds > 0 ? static_cast<std::size_t>(a.seconds) : groups);
  const auto start = Clock::now();
  const auto watcher = std::this_thread::get_id();
  std::atomic<bool> stop = false;
  const auto go_on = [&](std::uint64_t done, std::uint64_t findings) {
    if (std::this_thread::get_id() == watcher) {
      try {
        render::check_interrupt();
      } catch (const render::Interrupted&) {
        interrupted = true;
        stop = true;
      }
      progress.update(a.seconds > 0 ? static_cast<std::size_t>(std::chrono::duration<double>(Clock::now() - start).count())
                                    : done);
    }
    return !stop && Clock::now() < end && !(a.stop_at_first && findings > 0);
  };
  return fuzz::run(campaign, experiments, go_on);
}

void minimise_findings(std::vector<fuzz::Report>& reports) {
  for (fuzz::Report& report : reports) {
    for (fuzz::Finding& finding : report.findings) {
      if (!finding.question || !fuzz::is_disagreement(*finding.question)) continue;
      finding.question = fuzz::minimise(*finding.question, fuzz::is_disagreement);
      finding.expect = fuzz::judged_answer(*finding.question);
    }
  }
}

FuzzResults fuzz_families(const Arguments& a, bool& interrupted) {
  const std::vector<fuzz::Experiment> experiments = chosen(a.families);
  const fuzz::Campaign campaign = campaign_of(a, experiments.size());
  std::vector<fuzz::Report> reports = run_watched(a, campaign, experiments, interrupted);
  FuzzResults results{campaign.seed, campaign.shards, {campaign.shard}, {}};
  minimise_findings(reports);
  for (std::size_t i = 0; i < experiments.size(); ++i) results.rows.push_back({experiments[i].name, std::move(reports[i])});
  return results;
}

/// One row a case file, each line put as it stands.
FuzzResults fuzz_files(const std::vector<std::string>& files) {
  FuzzResults results{1, 1, {0}, {}};
  for (const std::string& file : files) {
    FuzzResults::Row& row = results.rows.emplace_back();
    row.name = std::filesystem::path(file).filename();
    for_each_case(file, [&](std::size_t number, const nlohmann::json& object) {
      render::check_interrupt();
      const fuzz::Case question = read_case(object).question;
      fuzz::Report report;
      fuzz::judge_overlap(question, {&question.box, 1}, row.name, number, report);
      fuzz::add(row.report, std::move(report));
    });
  }
  return results;
}

FuzzResults results_of(const Arguments& a, bool& interrupted) {
  if (!a.merged.empty()) return merge(a.merged);
  return a.files.empty() ? fuzz_families(a, interrupted) : fuzz_files(a.files);
}

void write(const std::string& file, const std::string& text) {
  render::OutputFile out(file);
  out.write(text);
  out.commit();
}

int fuzz_command(const Arguments& a) {
  bool interrupted = false;
  const FuzzResults results = results_of(a, interrupted);
  fmt::print("{}", a.json ? to_json(results) : table(results));
  if (!a.out.empty()) write(a.out, to_json(results));
  if (const std::string lines = case_lines(results); !lines.empty()) {
    write(a.findings, lines);
    fmt::print(stderr, "{}see {}, occlude classify replays it\n", lines, a.findings);
  }
  if (interrupted) {
    fmt::print(stderr, "occlude: interrupted; the table has what was done till then\n");
    return 130;
  }
  return total(results).tally.disagreements == 0 ? 0 : 1;
}

std::string check_family(const std::string& name) {
  const auto& all = fuzz::experiments();
  const bool known = std::ranges::find(all, name, &fuzz::Experiment::name) != all.end();
  return known ? "" : fmt::format("{}: no such family (occlude fuzz --cases 1 lists them)", name);
}

}  // namespace

void add_fuzz(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("fuzz", "Hold kernel and culler against the exact oracle on degenerate cases");
  command->footer(
      "Same seed, same cases, for any number of jobs; round r of a run has the seed S + r, so that --seed R --family F "
      "--cases 1\n"
      "makes a finding's group again. Exit code 0 when nothing is wrong, 1 for a finding (its case line is printed and "
      "stored),\n"
      "2 for bad input.\n"
      "Example: occlude fuzz --seconds 30\n"
      "Example: occlude fuzz --cases 100000000 --shard 3/16 --out part3.json     then: occlude fuzz --merge part*.json");
  const auto a = std::make_shared<Arguments>();
  CLI::Option* files = command->add_option("FILE", a->files, "case files to be judged instead of families");
  CLI::Option* cases =
      command
          ->add_option("--cases", a->cases, fmt::format("at least so many, all families alike; default {}", kDefaultCases))
          ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 50U));
  CLI::Option* seconds = command->add_option("--seconds", a->seconds, "as many as this time allows")
                             ->check(CLI::Range(0.001, 1e7))
                             ->excludes(cases);
  command->add_option("--family", a->families, "only these families; may be given several times")->check(check_family);
  command->add_option("--seed", a->seed, "whole number")->capture_default_str();
  command->add_option("--jobs", a->jobs, "threads")->capture_default_str()->check(CLI::Range(1U, 1024U));
  command->add_option("--shard", a->shard, "i/n: part i of n, i from 0; the parts together are the whole run")
      ->capture_default_str()
      ->excludes(seconds);
  CLI::Option* merged = command->add_option("--merge", a->merged, "results of shards (--out), to be added up");
  command->add_flag("--stop-at-first", a->stop_at_first, "stop at the first finding");
  command->add_option("--findings", a->findings, "file for the case lines of findings, written when there are any")
      ->capture_default_str();
  command->add_option("--out", a->out, "file for the results as JSON");
  command->add_flag("--json", a->json, "print the results as JSON");
  for (CLI::Option* option : {cases, seconds}) option->excludes(files)->excludes(merged);
  files->excludes(merged);
  command->callback([a, &exit_code] { exit_code = fuzz_command(*a); });
}

}  // namespace occlude::cli
