// SPDX-License-Identifier: MIT
// occlude fuzz: compares the kernel and the culler with the exact oracle, case by case.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "cases/case_line.h"
#include "command_arguments.h"
#include "commands.h"
#include "differential/campaign.h"
#include "differential/minimise.h"
#include "differential/overlap.h"
#include "occlude/render/console.h"
#include "occlude/render/digest.h"
#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/job.h"
#include "occlude/render/output_file.h"
#include "occlude/render/packing.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/ranks.h"
#include "occlude/render/stopwatch.h"
#include "packed_reports.h"
#include "results.h"

namespace occlude::cli {
namespace {

/// The default takes some ten seconds. The most is below 2^53, so every reader of JSON counts exactly.
constexpr std::uint64_t kDefaultCases = 1'000'000, kMostCases = std::uint64_t{1} << 50U;
/// A part has at least so many groups, some tenths of a second, so that threads seldom wait for its end.
constexpr std::uint64_t kGroupsOfPart = 2048;
/// A run that is counted has at most so many parts, each a file where they are kept.
constexpr std::uint64_t kMostParts = 1024;

struct FuzzArguments {
  std::vector<std::string> families, files;
  double seconds = 0;
  std::string cases = std::to_string(kDefaultCases), seed = "1", out;
  std::optional<std::string> findings;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool stop_at_first = false, json = false;
  PartsArguments parts;
  std::string given;  ///< the options on which results depend

  /// Whether the number of cases decides when the run ends.
  [[nodiscard]] bool is_counted() const { return seconds == 0 && !stop_at_first; }
};

std::vector<fuzz::Experiment> chosen(const std::vector<std::string>& families) {
  std::vector<fuzz::Experiment> result;
  for (const fuzz::Experiment& experiment : fuzz::experiments()) {
    if (families.empty() || std::ranges::find(families, experiment.name) != families.end()) result.push_back(experiment);
  }
  return result;
}

fuzz::Campaign campaign_of(const FuzzArguments& a, std::size_t experiments) {
  fuzz::Campaign campaign;
  campaign.seed = whole_number("--seed", a.seed);
  campaign.jobs = a.jobs;
  const std::uint64_t per_round = experiments * fuzz::kGroup;
  const std::uint64_t cases = whole_number("--cases", a.cases);
  if (cases == 0 || cases > kMostCases) refuse("--cases", fmt::format("expected 1 to {}", kMostCases));
  campaign.rounds = a.seconds > 0 ? kMostCases : (cases + per_round - 1) / per_round;
  return campaign;
}

/// Says when to stop: when the time is over, when one finding is enough, or when the user interrupts.
class Watch {
 public:
  explicit Watch(const FuzzArguments& a) : seconds_(a.seconds), stop_at_first_(a.stop_at_first) {}

  /// May be called from any thread.
  [[nodiscard]] bool go_on(std::uint64_t findings) const {
    try {
      render::check_interrupt();
    } catch (const render::Interrupted&) {
      return false;
    }
    const bool is_over = seconds_ > 0 && seconds() >= seconds_;
    return !is_over && !(stop_at_first_ && findings > 0);
  }

  [[nodiscard]] double seconds() const { return stopwatch_.seconds(); }

 private:
  double seconds_;
  bool stop_at_first_;
  render::Stopwatch stopwatch_;
};

/// Makes the finding smaller while it keeps its kind.
void minimise(fuzz::Finding& finding) {
  const auto again = [&](const fuzz::Case& c) { return fuzz::find_again(c, finding.kind); };
  if (!finding.question || !again(*finding.question)) return;
  const fuzz::Case small = fuzz::minimise(*finding.question, [&](const fuzz::Case& c) { return again(c).has_value(); });
  const fuzz::Finding found = *again(small);
  finding.question = found.question;
  finding.what = found.what;
  finding.expect = found.expect;
}

void minimise_findings(FuzzResults& results) {
  std::size_t all = 0, done = 0;
  for (const FuzzResults::Row& row : results.rows) all += row.report.findings.size();
  render::Progress progress("findings minimised", all);
  for (FuzzResults::Row& row : results.rows) {
    for (fuzz::Finding& finding : row.report.findings) {
      render::check_interrupt();
      minimise(finding);
      progress.update(++done);
    }
  }
}

/// The rounds of a campaign in parts, and the sum of their reports.
class Rounds {
 public:
  explicit Rounds(const FuzzArguments& a)
      : experiments_(chosen(a.families)),
        campaign_(campaign_of(a, experiments_.size())),
        watch_(a),
        reports_(experiments_.size()),
        is_timed_(a.seconds > 0),
        progress_(is_timed_ ? "seconds" : "rounds", is_timed_ ? static_cast<std::size_t>(a.seconds) : campaign_.rounds) {
    of_part_ = (kGroupsOfPart + experiments_.size() - 1) / experiments_.size();
    if (a.is_counted()) of_part_ = std::max(of_part_, (campaign_.rounds + kMostParts - 1) / kMostParts);
  }

  [[nodiscard]] render::Stage stage() {
    return {[this] { return next(); }, [this](const std::string& input) { return work(input); },
            [this](const std::string& result) { take(result); }};
  }

  [[nodiscard]] const fuzz::Campaign& campaign() const { return campaign_; }
  /// One for each experiment, with its name.
  [[nodiscard]] std::vector<FuzzResults::Row> rows() && {
    std::vector<FuzzResults::Row> rows;
    for (std::size_t i = 0; i < experiments_.size(); ++i) rows.push_back({experiments_[i].name, std::move(reports_[i])});
    return rows;
  }

 private:
  std::optional<std::string> next() {
    if (begun_ >= campaign_.rounds || !watch_.go_on(findings_)) return std::nullopt;
    const fuzz::Campaign part = part_from(begun_);
    begun_ += part.rounds;
    return render::Packer().put(part.seed).put(part.rounds).bytes();
  }

  /// The part that begins with this round.
  [[nodiscard]] fuzz::Campaign part_from(std::uint64_t round) const {
    return {campaign_.seed + round, std::min(of_part_, campaign_.rounds - round), campaign_.jobs};
  }

  [[nodiscard]] std::string work(const std::string& input) const {
    render::Unpacker part(input);
    fuzz::Campaign campaign = campaign_;
    campaign.seed = part.get<std::uint64_t>();
    campaign.rounds = part.get<std::uint64_t>();
    part.finish();
    const std::vector<fuzz::Report> reports =
        fuzz::run(campaign, experiments_, [this](std::uint64_t findings) { return watch_.go_on(findings); });
    render::check_interrupt();  // then the part is not whole
    return pack(reports);
  }

  void take(const std::string& result) {
    const fuzz::Campaign asked = part_from(taken_);
    std::vector<fuzz::Report> part = unpack(result, asked, experiments_);
    for (std::size_t i = 0; i < reports_.size(); ++i) {
      findings_ += part[i].tally.disagreements;
      fuzz::add(reports_[i], std::move(part[i]));
    }
    taken_ += asked.rounds;
    progress_.update(is_timed_ ? static_cast<std::size_t>(watch_.seconds()) : taken_);
  }

  std::vector<fuzz::Experiment> experiments_;
  fuzz::Campaign campaign_;
  Watch watch_;
  std::vector<fuzz::Report> reports_;
  bool is_timed_;
  render::Progress progress_;
  std::uint64_t of_part_ = 0, begun_ = 0, taken_ = 0, findings_ = 0;
};

FuzzResults fuzz_families(const FuzzArguments& a, render::Job& job) {
  Rounds rounds(a);
  bool interrupted = false;
  try {
    job.run(rounds.stage());
  } catch (const render::Interrupted&) {
    if (render::ranks() > 1) throw;  // mpirun leaves no time for a table
    interrupted = true;
  }
  const fuzz::Campaign campaign = rounds.campaign();
  return {campaign.seed, a.is_counted() ? campaign.rounds : 0, interrupted, std::move(rounds).rows()};
}

/// The kind of finding in which the user's file may be wrong and not the program.
constexpr const char* kExpect = "expect";

/// Judges the case on a line of a case file, and compares it with the answer that the line expects.
fuzz::Report judge_line(const cases::CaseLine& line, const std::string& name, std::size_t number) {
  fuzz::Report report;
  fuzz::judge_overlap(line.question, {&line.question.box, 1}, number, report);
  const std::string judged = fuzz::judged_answer(line.question);
  if (line.expect && *line.expect != judged) {
    report.tally.disagreements = 1;
    report.findings.push_back({kExpect, fmt::format("{}, the oracle: {}", *line.expect, judged.empty() ? "none" : judged),
                               line.question, *line.expect});
  }
  fuzz::sign(report, name, number);
  return report;
}

/// Makes one row for each case file. Each line is asked as it is.
FuzzResults fuzz_files(const std::vector<std::string>& files) {
  FuzzResults results{std::nullopt, 0, false, {}};
  try {
    for (const std::string& file : files) {
      FuzzResults::Row& row = results.rows.emplace_back();
      row.name = render::printable(std::filesystem::path(file).filename().native());
      cases::for_each_case(file, false, [&](std::size_t number, const nlohmann::json& object) {
        fuzz::add(row.report, judge_line(cases::read_case(object), row.name, number));
      });
    }
  } catch (const render::Interrupted&) {
    results.interrupted = true;
  }
  return results;
}

/// Writes the case lines of the findings to a file. If that fails, it prints them, so that they are not lost.
void store(const FuzzResults& results, const std::string& file) {
  if (file.empty()) return;
  try {
    render::OutputFile findings(file);
    findings.write(case_lines(results));
    findings.commit();
  } catch (const render::InputError&) {
    render::say(case_lines(results));
    throw;
  }
}

bool has_defects(const FuzzResults& results) {
  return std::ranges::any_of(results.rows, [](const FuzzResults::Row& row) {
    return !std::ranges::all_of(row.report.findings, [](const fuzz::Finding& f) { return f.kind == kExpect; });
  });
}

/// Makes the findings smaller and stores them again. They were stored before, because this takes time and the user may
/// interrupt it.
void minimise_and_report(FuzzResults& results, const std::string& file) {
  try {
    minimise_findings(results);
    store(results, file);
  } catch (const render::Interrupted&) {
    results.interrupted = true;
  }
  render::say(case_lines(results));
  if (!file.empty())
    render::say(fmt::format("These lines are in {0}: occlude fuzz {0} judges them again.\n", render::printable(file)));
  if (has_defects(results)) render::say("A wrong answer of ours is a defect: please report its line.\n");
}

/// The lines of case files are in a file already, so by default they are not stored again.
std::string findings_file(const FuzzArguments& a) {
  return a.findings.value_or(a.files.empty() ? "fuzz_findings.jsonl" : "");
}

/// Parts of a run that time or a finding ends differ from run to run, so they are not kept.
render::Job job_of(const FuzzArguments& a) {
  return {a.is_counted() && a.files.empty() ? a.parts.keeping() : render::Keeping{},
          [&] { return render::Digest().add(a.given).value(); }};
}

void fuzz_command(const FuzzArguments& a, int& exit_code) {
  render::Job job = job_of(a);
  if (!render::is_first_rank()) {
    if (a.files.empty()) fuzz_families(a, job);
    return;
  }
  const std::string file = findings_file(a);
  // Files are opened before the work, so that one that cannot be written is reported at once.
  std::optional<render::OutputFile> findings, out;
  if (!file.empty()) findings.emplace(file);
  if (!a.out.empty()) out.emplace(a.out);

  FuzzResults results = a.files.empty() ? fuzz_families(a, job) : fuzz_files(a.files);
  findings.reset();
  exit_code = total(results).tally.disagreements == 0 ? kDone : kCheckFailed;
  const bool has_findings = !case_lines(results).empty();
  if (has_findings) {
    store(results, file);
  } else if (std::filesystem::is_regular_file(file)) {
    render::say(render::printable(file) + " is of an earlier run\n");
  }
  if (!a.json) render::tell(table(results));
  render::finish_printing();
  if (has_findings) minimise_and_report(results, file);
  if (a.json) render::print(to_json(results));
  if (results.interrupted) {
    render::say(fmt::format("occlude: interrupted; this is what was done till then{}\n",
                            out ? fmt::format(", {} is not written", a.out) : ""));
    if (exit_code == kDone) exit_code = kInterrupted;
    return;
  }
  if (out) {
    out->write(to_json(results));
    const render::Uninterrupted naming;
    out->commit();
  }
  render::finish_printing();
  job.finish();
}

/// From the shortest time that shows anything to about four months.
std::string check_seconds(const std::string& text) {
  const std::optional<double> seconds = parse_number(text);
  return seconds && *seconds >= 0.001 && *seconds <= 1e7 ? "" : text + " is not from 0.001 to 1e7";
}

std::string check_family(const std::string& name) {
  const auto& all = fuzz::experiments();
  const bool known = std::ranges::find(all, name, &fuzz::Experiment::name) != all.end();
  return known ? "" : fmt::format("{}: no such family (occlude fuzz --cases 1 names all)", name);
}

}  // namespace

void add_fuzz(Command app, int& exit_code) {
  Command command = app.add_command("fuzz", "Hold kernel and culler against the exact oracle on degenerate cases");
  command.footer(
      "Same seed, same cases, for any number of jobs; round r of a run has the seed S + r, so that --seed R --family F "
      "--cases 1\n"
      "makes a finding's group again. Exit code 0 when nothing is wrong, 1 for a finding (its case line is printed and "
      "stored),\n"
      "2 for bad input.\n" +
      fmt::format("A polytope in a case file has at most {} vertices, those of its faces counted.\n", cases::kMostCorners) +
      limits_help() +
      "\n"
      "Example: occlude fuzz --seconds 30\n"
      "Example: mpirun -n 16 occlude fuzz --cases 100000000 --out results.json     and, after a failure, with --resume");
  const auto a = std::make_shared<FuzzArguments>();
  Option files = add_inputs(command, "FILE", a->files, "case files to be judged instead of families");
  Option cases =
      command.add("--cases", a->cases,
                  fmt::format("at least so many, all families alike, 16 or more of each; default {}", kDefaultCases));
  Option seconds = command.add("--seconds", a->seconds, "as many as this time allows").check(check_seconds).excludes(cases);
  Option family = command.add("--family", a->families, "only these families, one or more").check(check_family);
  Option seed = command.add("--seed", a->seed, "whole number").show_default();
  Option jobs = command.add("--jobs", a->jobs, "threads").show_default().in_range(std::size_t{1}, std::size_t{1024});
  Option stop = command.add_flag("--stop-at-first", a->stop_at_first, "stop at the first finding");
  for (Option option : a->parts.add_to(command, "fuzz")) option.excludes(files).excludes(seconds).excludes(stop);
  command.add("--findings", a->findings,
              "file for the case lines of findings, written when there are any; default fuzz_findings.jsonl, and "
              "none for case files; an empty name: none");
  add_output(command, "--out", a->out, "file for the results as JSON");
  command.add_flag("--json", a->json, "print the results as JSON");
  for (Option option : {cases, seconds, family, seed, jobs, stop}) option.excludes(files);
  command.run_on_all_ranks([a, command, &exit_code] {
    a->given = command.given_but({"--jobs", "--findings", "--out", "--json", "--quiet", "--parts", "--resume"});
    fuzz_command(*a, exit_code);
  });
}

}  // namespace occlude::cli
