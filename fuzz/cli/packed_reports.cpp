// SPDX-License-Identifier: MIT
#include "packed_reports.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "cases/case_line.h"
#include "cases/json_input.h"
#include "occlude/render/packing.h"
#include "occlude/render/printable.h"

namespace occlude::cli {
namespace {

void put(render::Packer& packer, const fuzz::Finding& finding) {
  packer.put(finding.kind).put(finding.what).put(finding.expect).put(finding.family).put(finding.seed);
  packer.put(finding.question ? cases::write_case("", *finding.question, "") : "");
}

/// Throws PartError for text that is no case line.
fuzz::Case get_question(const std::string& text) {
  try {
    return cases::read_case(nlohmann::json::parse(text)).question;
  } catch (const nlohmann::json::exception&) {
    throw render::PartError("a finding has a case that is not JSON");
  } catch (const cases::LineError&) {
    throw render::PartError("a finding has a case that is none");
  }
}

fuzz::Finding get_finding(render::Unpacker& unpacker, const fuzz::Campaign& campaign, const std::string& family) {
  fuzz::Finding finding;
  for (std::string* text : {&finding.kind, &finding.what, &finding.expect}) *text = render::printable(unpacker.text());
  finding.family = unpacker.text();
  finding.seed = unpacker.get<std::uint64_t>();
  // Seeds go round after the largest.
  render::require_part(finding.family == family && finding.seed - campaign.seed < campaign.rounds,
                       "a finding is of other cases than those asked for");
  const std::string question = unpacker.text();
  if (!question.empty()) finding.question = get_question(question);
  return finding;
}

/// Whether the counts are each of some of the cases. Their sum over all parts is then far from the largest number.
bool is_sound(const fuzz::Tally& t) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::uint64_t counts[] = {t.refused,       t.relations[0],  t.relations[1], t.relations[2],
                                  t.stages[0],     t.stages[1],     t.judged_twice, t.planes_asked,
                                  t.undecided,     t.others_asked,  t.plain.culls,  t.plain.draws,
                                  t.float32.culls, t.float32.draws, t.fused.culls,  t.fused.draws};
  const auto is_of_cases = [&](std::uint64_t count) { return count <= t.cases; };
  const auto is_of_asked = [&](const fuzz::WrongAnswers& wrong) { return wrong.culls + wrong.draws <= t.others_asked; };
  return t.cases <= kMost && t.lines_of_sight <= fuzz::kLinesOfCull * t.cases && t.disagreements <= kMost &&
         std::ranges::all_of(counts, is_of_cases) &&
         t.refused + t.relations[0] + t.relations[1] + t.relations[2] <= t.cases && t.stages[0] + t.stages[1] <= t.cases &&
         t.undecided <= t.planes_asked && is_of_asked(t.plain) && is_of_asked(t.float32) && is_of_asked(t.fused);
}

fuzz::Report get_report(render::Unpacker& unpacker, const fuzz::Campaign& campaign, const std::string& family) {
  fuzz::Report report;
  report.tally = unpacker.get<fuzz::Tally>();
  report.core_seconds = unpacker.get<double>();
  const auto findings = unpacker.get<std::uint64_t>();
  render::require_part(is_sound(report.tally), "its counts contradict each other");
  render::require_part(std::isfinite(report.core_seconds) && report.core_seconds >= 0, "its time is not a time");
  render::require_part(findings <= fuzz::kKeptFindings && (findings == 0) == (report.tally.disagreements == 0),
                       "its findings are not as many as it says");
  for (std::uint64_t i = 0; i < findings; ++i) report.findings.push_back(get_finding(unpacker, campaign, family));
  return report;
}

}  // namespace

std::string pack(const std::vector<fuzz::Report>& reports) {
  render::Packer packer;
  for (const fuzz::Report& report : reports) {
    packer.put(report.tally).put(report.core_seconds).put(std::uint64_t{report.findings.size()});
    for (const fuzz::Finding& finding : report.findings) put(packer, finding);
  }
  return packer.bytes();
}

std::vector<fuzz::Report> unpack(const std::string& bytes, const fuzz::Campaign& campaign,
                                 std::span<const fuzz::Experiment> experiments) {
  std::vector<fuzz::Report> reports;
  render::Unpacker unpacker(bytes);
  for (const fuzz::Experiment& experiment : experiments) {
    reports.push_back(get_report(unpacker, campaign, experiment.name));
  }
  unpacker.finish();
  return reports;
}

}  // namespace occlude::cli
