// SPDX-License-Identifier: MIT
#include "results.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "cases/case_line.h"
#include "differential/campaign.h"
#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"
#include "occlude/render/printable.h"

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
          {"disagreements", t.disagreements},
          {"conservative_asked_outside", t.planes_asked},
          {"conservative_undecided", t.undecided},
          {"others_asked", t.others_asked},
          {"plain", json(t.plain)},
          {"float32", json(t.float32)},
          {"fma", json(t.fused)},
          {"core_seconds", row.report.core_seconds}};
}

std::uint64_t count(const nlohmann::json& object, const char* name) {
  const nlohmann::json& value = cases::member(object, name);
  if (!value.is_number_unsigned()) throw cases::LineError(fmt::format("\"{}\": expected a whole number from 0", name));
  return value.get<std::uint64_t>();
}

/// A string made printable, because a table will show it.
std::string word(const nlohmann::json& object, const char* name) {
  const nlohmann::json& value = cases::member(object, name);
  if (!value.is_string()) throw cases::LineError(fmt::format("\"{}\": expected a string", name));
  return render::printable(value.get_ref<const std::string&>());
}

const nlohmann::json& list(const nlohmann::json& object, const char* name) {
  const nlohmann::json& value = cases::member(object, name);
  if (!value.is_array() || value.empty()) throw cases::LineError(fmt::format("\"{}\": expected a list, not empty", name));
  return value;
}

fuzz::WrongAnswers wrong_answers(const nlohmann::json& row, const char* name) {
  const nlohmann::json& object = cases::member(row, name);
  return {count(object, "wrong_culls"), count(object, "wrong_draws")};
}

Tally tally(const nlohmann::json& row) {
  Tally t;
  t.cases = count(row, "cases");
  const auto part = [&](const char* name) {
    const std::uint64_t some = count(row, name);
    if (some > t.cases) throw cases::LineError(fmt::format("\"{}\": more than there are cases", name));
    return some;
  };
  t.refused = part("refused");
  t.relations = {part("inside"), part("partial"), part("outside")};
  t.stages = {part("filter"), part("exact")};
  t.judged_twice = part("judged_twice");
  t.disagreements = part("disagreements");
  t.planes_asked = part("conservative_asked_outside");
  t.undecided = part("conservative_undecided");
  t.others_asked = part("others_asked");
  t.plain = wrong_answers(row, "plain");
  t.float32 = wrong_answers(row, "float32");
  t.fused = wrong_answers(row, "fma");
  return t;
}

Finding finding(const nlohmann::json& object) {
  Finding result{word(object, "kind"), word(object, "what")};
  result.family = word(object, "family");
  result.seed = count(object, "seed");
  if (object.contains("case")) {
    cases::CaseLine line = cases::read_case(object.at("case"));
    result.question = std::move(line.question);
    result.expect = line.expect.value_or("");
  }
  return result;
}

FuzzResults::Row row_of(const nlohmann::json& object) {
  FuzzResults::Row row{word(object, "name"), {}};
  row.report.tally = tally(object);
  row.report.core_seconds = cases::number(cases::member(object, "core_seconds"), "core_seconds");
  if (!(row.report.core_seconds >= 0)) throw cases::LineError("\"core_seconds\": expected a number from 0");
  const nlohmann::json& findings = cases::member(object, "findings");
  if (!findings.is_array()) throw cases::LineError("\"findings\": expected a list");
  std::ranges::transform(findings, std::back_inserter(row.report.findings), finding);
  return row;
}

FuzzResults read(const nlohmann::json& object) {
  FuzzResults results;
  if (!cases::member(object, "seed").is_null()) results.seed = count(object, "seed");
  results.rounds = count(object, "rounds");
  results.shards = count(object, "shards");
  const nlohmann::json& interrupted = cases::member(object, "interrupted");
  if (!interrupted.is_boolean()) throw cases::LineError("\"interrupted\": expected true or false");
  results.interrupted = interrupted.get<bool>();
  for (const nlohmann::json& part : list(object, "parts")) {
    if (!part.is_number_unsigned() || part.get<std::uint64_t>() >= results.shards) {
      throw cases::LineError("\"parts\": expected numbers of shards");
    }
    results.parts.push_back(part.get<std::uint64_t>());
  }
  std::ranges::transform(list(object, "families"), std::back_inserter(results.rows), row_of);
  return results;
}

FuzzResults read_file(const std::string& file) {
  const nlohmann::json object = render::read_json(file);
  try {
    return read(object);
  } catch (const cases::LineError& error) {
    throw render::InputError(fmt::format("{}: not a result of occlude fuzz --out: {}", file, error.what()));
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

void add_parts(FuzzResults& whole, const std::vector<std::uint64_t>& parts, const std::string& file) {
  for (const std::uint64_t shard : parts) {
    if (std::ranges::find(whole.parts, shard) != whole.parts.end()) {
      throw render::InputError(fmt::format("{}: shard {} of {} was given before", file, shard, whole.shards));
    }
    whole.parts.push_back(shard);
  }
  std::ranges::sort(whole.parts);
}

void add(FuzzResults& whole, FuzzResults&& part, const std::string& file) {
  if (!is_same_run(whole, part))
    throw render::InputError(file + ": a result of another run: other seed, cases, shards or families");
  add_parts(whole, part.parts, file);
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
  const Json object{{"seed", results.seed ? Json(*results.seed) : Json()},
                    {"rounds", results.rounds},
                    {"shards", results.shards},
                    {"parts", results.parts},
                    {"interrupted", results.interrupted},
                    {"cases", all.tally.cases},
                    {"disagreements", all.tally.disagreements},
                    {"core_seconds", all.core_seconds},
                    {"families", std::move(families)}};
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

FuzzResults merge(const std::vector<std::string>& files) {
  FuzzResults whole = read_part(files[0]);
  add_parts(whole, std::exchange(whole.parts, {}), files[0]);
  for (std::size_t i = 1; i < files.size(); ++i) add(whole, read_part(files[i]), files[i]);
  return whole;
}

}  // namespace occlude::cli
