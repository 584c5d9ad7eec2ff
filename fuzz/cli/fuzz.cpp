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
#include <utility>

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

/// Says when to stop: when the time is over, a finding is enough, or the user has seen enough.
class Watch {
 public:
  Watch(const Arguments& a, std::uint64_t groups)
      : seconds_(a.seconds),
        stop_at_first_(a.stop_at_first),
        progress_(a.seconds > 0 ? "seconds" : "groups", a.seconds > 0 ? static_cast<std::size_t>(a.seconds) : groups) {}

  /// Called from any thread; that of the command also shows the progress.
  bool go_on(std::uint64_t groups, std::uint64_t findings) {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (std::this_thread::get_id() == thread_) {
      look_for_interrupt();
      progress_.update(seconds_ > 0 ? static_cast<std::size_t>(seconds) : groups);
    }
    const bool is_over = seconds_ > 0 && seconds >= seconds_;
    return !interrupted_ && !is_over && !(stop_at_first_ && findings > 0);
  }

  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  void look_for_interrupt() {
    try {
      render::check_interrupt();
    } catch (const render::Interrupted&) {
      interrupted_ = true;
    }
  }

  double seconds_;
  bool stop_at_first_;
  render::Progress progress_;
  Clock::time_point start_ = Clock::now();
  std::thread::id thread_ = std::this_thread::get_id();
  std::atomic<bool> interrupted_ = false;
};

void minimise_findings(std::vector<fuzz::Report>& reports) {
  for (fuzz::Report& report : reports) {
    for (fuzz::Finding& finding : report.findings) {
      render::check_interrupt();
      if (!finding.question || !fuzz::is_disagreement(*finding.question)) continue;
      finding.question = fuzz::minimise(*finding.question, fuzz::is_disagreement);
      finding.expect = fuzz::judged_answer(*finding.question);
    }
  }
}

FuzzResults fuzz_families(const Arguments& a) {
  const std::vector<fuzz::Experiment> experiments = chosen(a.families);
  const fuzz::Campaign campaign = campaign_of(a, experiments.size());
  std::optional<Watch> watch(std::in_place, a, campaign.rounds / campaign.shards * experiments.size());
  std::vector<fuzz::Report> reports = fuzz::run(
      campaign, experiments, [&](std::uint64_t groups, std::uint64_t findings) { return watch->go_on(groups, findings); });
  FuzzResults results{campaign.seed, campaign.shards, {campaign.shard}, watch->interrupted(), {}};
  watch.reset();
  if (!results.interrupted) minimise_findings(reports);
  for (std::size_t i = 0; i < experiments.size(); ++i) results.rows.push_back({experiments[i].name, std::move(reports[i])});
  return results;
}

/// One row a case file, each line put as it stands.
FuzzResults fuzz_files(const std::vector<std::string>& files) {
  FuzzResults results{1, 1, {0}, false, {}};
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

FuzzResults results_of(const Arguments& a) {
  if (!a.merged.empty()) return merge(a.merged);
  return a.files.empty() ? fuzz_families(a) : fuzz_files(a.files);
}

int fuzz_command(const Arguments& a) {
  std::vector<std::string> files{a.findings, a.out};
  files.insert(files.end(), a.files.begin(), a.files.end());
  files.insert(files.end(), a.merged.begin(), a.merged.end());
  std::erase(files, "");
  check_distinct(files);
  // Opened before the work: what cannot be written is known at once.
  render::OutputFile findings(a.findings);
  std::optional<render::OutputFile> out;
  if (!a.out.empty()) out.emplace(a.out);

  const FuzzResults results = results_of(a);
  fmt::print("{}", a.json ? to_json(results) : table(results));
  if (const std::string lines = case_lines(results); !lines.empty()) {
    findings.write(lines);
    findings.commit();
    fmt::print(stderr, "{}see {}, occlude classify replays it\n", lines, a.findings);
  }
  if (results.interrupted) {
    fmt::print(stderr, "occlude: interrupted; the table has what was done till then\n");
    return 130;
  }
  if (out) {
    out->write(to_json(results));
    out->commit();
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
