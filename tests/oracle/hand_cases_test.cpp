// SPDX-License-Identifier: MIT
// The hand cases: both oracles know their answers, no two ask the same, and they are written as they are read.
#include "hand_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "cases/case_json.h"
#include "cases/to_oracle.h"
#include "differential/answers.h"
#include "fuzz/case_hash.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/region_shadow.h"
#include "occlude/oracle/second.h"

namespace occlude::oracle {
namespace hand_cases_test {

using cases::to_oracle;

/// The answer as a word, or why there is none.
std::string text(const Answer& answer) {
  return answer.refusal.empty() ? fuzz::text(fuzz::relation_of(answer.relation)) : answer.refusal;
}

TEST(HandCases, BothOraclesAgree) {
  for (const HandCase& c : hand_cases()) {
    SCOPED_TRACE(c.id);
    const Viewpoint view = to_oracle(c.question.viewpoint);
    const Occluder occluder = to_oracle(c.question.occluder);
    const Near near = to_oracle(c.question.near);
    const Box box = to_oracle(c.question.box);
    EXPECT_EQ(text(relation(view, occluder, near, box)), fuzz::text(c.relation));
    EXPECT_EQ(text(second::relation(view, occluder, near, box)), fuzz::text(c.relation));
  }
}

TEST(HandCovers, TheOracleAgrees) {
  for (const HandCover& c : hand_covers()) {
    SCOPED_TRACE(c.id);
    const Answer answer = relation_to_cover(to_oracle(c.viewpoint), to_oracle(c.polygons), to_oracle(c.box));
    EXPECT_EQ(text(answer), fuzz::text(c.relation));
  }
}

TEST(HandRegions, BothOraclesAgree) {
  for (const HandRegion& c : hand_regions()) {
    SCOPED_TRACE(c.id);
    const ViewRegion region = to_oracle(c.question.region);
    const Occluder occluder = to_oracle(c.question.occluder);
    const ShadowKind kind = to_oracle(c.question.kind);
    const Box box = to_oracle(c.question.box);
    EXPECT_EQ(text(RegionShadow(region, occluder, kind).relation(box)), fuzz::text(c.relation));
    EXPECT_EQ(text(second::relation(region, occluder, kind, box)), fuzz::text(c.relation));
  }
}

TEST(HandCases, AskNothingTwice) {
  std::map<std::string, std::string> asked;
  for (const HandCase& c : hand_cases()) {
    const auto [other, is_new] = asked.emplace(cases::write_case("", c.question, ""), c.id);
    EXPECT_TRUE(is_new) << c.id << " asks what " << other->second << " asks";
  }
}

TEST(HandRegions, AskNothingTwiceAndAreWrittenAsTheyAreRead) {
  std::map<std::string, std::string> asked;
  for (const HandRegion& c : hand_regions()) {
    const std::string line = cases::write_case("", c.question, "");
    const auto [other, is_new] = asked.emplace(line, c.id);
    EXPECT_TRUE(is_new) << c.id << " asks what " << other->second << " asks";
    EXPECT_EQ(cases::write_case("", cases::read_region(nlohmann::json::parse(line)).question, ""), line);
  }
}

TEST(HandCovers, AskNothingTwice) {
  const auto question = [](const HandCover& c) { return std::tie(c.viewpoint.kind, c.viewpoint.value, c.polygons, c.box); };
  for (const HandCover& c : hand_covers()) {
    const auto same = std::ranges::find(hand_covers(), question(c), question);
    EXPECT_EQ(same->id, c.id);
  }
}

std::uint64_t hash_of(const cases::Case& c) {
  fuzz::CaseHash hash;
  hash.add(c);
  return hash.value();
}

/// To the last bit.
TEST(HandCases, AreWrittenAsTheyAreRead) {
  for (const HandCase& c : hand_cases()) {
    const cases::CaseLine again = cases::read_case(nlohmann::json::parse(cases::write_case(c.id, c.question, "")));
    EXPECT_EQ(hash_of(again.question), hash_of(c.question)) << c.id;
  }
}

}  // namespace hand_cases_test
}  // namespace occlude::oracle
