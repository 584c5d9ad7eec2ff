// SPDX-License-Identifier: MIT
#include "results.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "case_line.h"
#include "differential/campaign.h"
#include "occlude/render/errors.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::Finding;
using fuzz::Tally;

Json json(const fuzz::WrongAnswers& wrong) { return {{"wrong_culls", wrong.culls}, {"wrong_draws", wrong.draws}}; }

std::string id_of(const Finding& finding) {
  return fmt::format("{} {}: {}: {}", finding.family, finding.seed, finding.kind, finding.what);
}

std::string case_line(const Finding& finding) { return write_case(id_of(finding), *finding.question, finding.expect); }

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
          {"disagreements", t.disagreements},
          {"conservative_asked_outside", t.planes_asked},
          {"conservative_undecided", t.undecided},
          {"others_asked", t.others_asked},
          {"plain", json(t.plain)},
          {"float32", json(t.float32)},
          {"fma", json(t.fused)},
          {"core_seconds", row.report.core_seconds}};
}

fuzz::WrongAnswers wrong_answers(const nlohmann::json& object) {
  return {object.at("wrong_culls").get<std::uint64_t>(), object.at("wrong_draws").get<std::uint64_t>()};
}

Tally tally(const nlohmann::json& row) {
  const auto count = [&](const char* name) { return row.at(name).get<std::uint64_t>(); };
  Tally t;
  t.cases = count("cases");
  t.refused = count("refused");
  t.relations = {count("inside"), count("partial"), count("outside")};
  t.stages = {count("filter"), count("exact")};
  t.judged_twice = count("judged_twice");
  t.disagreements = count("disagreements");
  t.planes_asked = count("conservative_asked_outside");
  t.undecided = count("conservative_undecided");
  t.others_asked = count("others_asked");
  t.plain = wrong_answers(row.at("plain"));
  t.float32 = wrong_answers(row.at("float32"));
  t.fused = wrong_answers(row.at("fma"));
  return t;
}

Finding finding(const nlohmann::json& object) {
  Finding result{object.at("family").get<std::string>(),
                 object.at("seed").get<std::uint64_t>(),
                 object.at("kind").get<std::string>(),
                 object.at("what").get<std::string>(),
                 std::nullopt,
                 ""};
  if (object.contains("case")) {
    CaseLine line = read_case(object.at("case"));
    result.question = std::move(line.question);
    result.expect = line.expect.value_or("");
  }
  return result;
}

FuzzResults read(const nlohmann::json& object) {
  FuzzResults results;
  results.seed = object.at("seed").get<std::uint64_t>();
  results.rounds = object.at("rounds").get<std::uint64_t>();
  results.shards = object.at("shards").get<std::uint64_t>();
  results.interrupted = object.at("interrupted").get<bool>();
  results.parts = object.at("parts").get<std::vector<std::uint64_t>>();
  for (const auto& row : object.at("families")) {
    FuzzResults::Row& added = results.rows.emplace_back();
    added.name = row.at("name").get<std::string>();
    added.report.tally = tally(row);
    added.report.core_seconds = row.at("core_seconds").get<double>();
    for (const auto& found : row.at("findings")) added.report.findings.push_back(finding(found));
  }
  return results;
}

FuzzResults read_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw render::InputError(file + ": cannot be opened");
  try {
    return read(nlohmann::json::parse(in));
  } catch (const std::exception& error) {
    throw render::InputError(fmt::format("{}: not a result of occlude fuzz --json", file));
  }
}

bool is_same_run(const FuzzResults& a, const FuzzResults& b) {
  return a.seed == b.seed && a.rounds == b.rounds && a.shards == b.shards &&
         std::ranges::equal(a.rows, b.rows, {}, &FuzzResults::Row::name, &FuzzResults::Row::name);
}

FuzzResults read_part(const std::string& file) {
  FuzzResults results = read_file(file);
  if (results.interrupted) throw render::InputError(file + ": a run that was interrupted: the part is not whole");
  return results;
}

void add(FuzzResults& whole, FuzzResults&& part, const std::string& file) {
  if (!is_same_run(whole, part))
    throw render::InputError(file + ": a result of another run: other seed, cases, shards or families");
  for (const std::uint64_t shard : part.parts) {
    if (std::ranges::find(whole.parts, shard) != whole.parts.end()) {
      throw render::InputError(fmt::format("{}: shard {} of {} was given before", file, shard, whole.shards));
    }
    whole.parts.push_back(shard);
  }
  std::ranges::sort(whole.parts);
  for (std::size_t i = 0; i < whole.rows.size(); ++i) {
    fuzz::add(whole.rows[i].report, std::move(part.rows[i].report));
  }
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
  const Json object{{"seed", results.seed},
                    {"rounds", results.rounds},
                    {"shards", results.shards},
                    {"parts", results.parts},
                    {"interrupted", results.interrupted},
                    {"cases", all.tally.cases},
                    {"disagreements", all.tally.disagreements},
                    {"core_seconds", all.core_seconds},
                    {"families", std::move(families)}};
  return object.dump(1) + '\n';
}

FuzzResults merge(const std::vector<std::string>& files) {
  FuzzResults whole = read_part(files[0]);
  for (std::size_t i = 1; i < files.size(); ++i) add(whole, read_part(files[i]), files[i]);
  return whole;
}

}  // namespace occlude::cli
