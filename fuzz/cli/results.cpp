// SPDX-License-Identifier: MIT
#include "results.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "cases/case_line.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::Finding;
using fuzz::Tally;

Json json(const fuzz::WrongAnswers& wrong) { return {{"wrong_culls", wrong.culls}, {"wrong_draws", wrong.draws}}; }

std::string id_of(const Finding& finding) {
  return fmt::format("{} {}: {}: {}", finding.family, finding.seed, finding.kind, finding.what);
}

std::string case_line(const Finding& finding) {
  return cases::write_case(id_of(finding), *finding.question, finding.expect);
}

Json json(const Finding& finding) {
  Json result{{"family", finding.family}, {"seed", finding.seed}, {"kind", finding.kind}, {"what", finding.what}};
  if (finding.question) result["case"] = Json::parse(case_line(finding));
  return result;
}

Json json(const FuzzResults::Row& row) {
  const Tally& t = row.report.tally;
  return {{"name", row.name},
          {"cases", t.cases},
          {"refused", t.refused},
          {"inside", t.relations[0]},
          {"partial", t.relations[1]},
          {"outside", t.relations[2]},
          {"filter", t.stages[0]},
          {"exact", t.stages[1]},
          {"judged_twice", t.judged_twice},
          {"lines_of_sight", t.lines_of_sight},
          {"disagreements", t.disagreements},
          {"conservative_asked_outside", t.planes_asked},
          {"conservative_undecided", t.undecided},
          {"others_asked", t.others_asked},
          {"plain", json(t.plain)},
          {"float32", json(t.float32)},
          {"fma", json(t.fused)},
          {"core_seconds", row.report.core_seconds}};
}

}  // namespace

fuzz::Report total(const FuzzResults& results) {
  fuzz::Report sum;
  for (const FuzzResults::Row& row : results.rows) {
    sum.tally += row.report.tally;
    sum.core_seconds += row.report.core_seconds;
  }
  return sum;
}

std::string case_lines(const FuzzResults& results) {
  std::string lines;
  for (const FuzzResults::Row& row : results.rows) {
    for (const Finding& found : row.report.findings) {
      if (found.question) lines += case_line(found) + '\n';
    }
  }
  return lines;
}

std::string to_json(const FuzzResults& results) {
  const fuzz::Report all = total(results);
  Json families = Json::array();
  for (const FuzzResults::Row& row : results.rows) {
    Json object = json(row);
    object["findings"] = Json::array();
    for (const Finding& found : row.report.findings) object["findings"].push_back(json(found));
    families.push_back(std::move(object));
  }
  const Json object{{"seed", results.seed ? Json(*results.seed) : Json()},
                    {"rounds", results.rounds},
                    {"interrupted", results.interrupted},
                    {"cases", all.tally.cases},
                    {"disagreements", all.tally.disagreements},
                    {"core_seconds", all.core_seconds},
                    {"families", std::move(families)}};
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace occlude::cli
