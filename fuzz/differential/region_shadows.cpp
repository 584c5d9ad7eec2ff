// SPDX-License-Identifier: MIT
// Compares boxes with the umbra and penumbra for a region of viewpoints.
#include <string>

#include "any_case.h"
#include "cases/case_json.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/oracle/region.h"
#include "occlude/oracle/region_shadow.h"
#include "occlude/oracle/second.h"
#include "region_questions.h"
#include "rows.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::NearBoundary;
using kernel::Relation;

/// Boxes that share what is expensive to prepare, the oracle's planes.
constexpr std::uint64_t kBoxes = 4 * kGroup;

class RegionJudgement {
 public:
  RegionJudgement(const RegionCase& question, Report& report)
      : question_(question),
        report_(report),
        made_(make_shadow(question_)),
        truth_(to_oracle(question_.region), to_oracle(question_.occluder), to_oracle(question_.kind)) {}

  void judge(const Box& box, bool twice) {
    box_ = box;
    is_wrong_ = false;
    ++report_.tally.cases;
    const oracle::Answer answer = truth_.relation(to_oracle(box));
    const bool refused = !made_.shadow || check(box) != kernel::Refusal::none;
    if (refused != !answer.refusal.empty()) {
      return add(refused ? "the kernel refuses: " + std::string(to_string(made_.refusal))
                         : "the kernel answers, the oracle refuses: " + answer.refusal,
                 "refusal", "");
    }
    report_.tally.refused += refused ? 1 : 0;
    if (!refused) judge_answers(relation_of(answer.relation), twice);
  }

 private:
  void judge_answers(Relation truth, bool twice) {
    const kernel::Decision certified = overlap(*made_.shadow, box_);
    report_.tally.count(truth, certified.stage);
    compare("certified", certified.relation, truth);
    const Relation planes = conservative(*made_.shadow, box_).relation;
    report_.tally.planes_asked += truth == Relation::outside ? 1 : 0;
    report_.tally.undecided += truth == Relation::outside && planes == Relation::partial ? 1 : 0;
    if (planes != Relation::partial || truth == Relation::inside) compare("conservative", planes, truth);
    const bool touches = truth == Relation::inside && truth_.reaches_surface(to_oracle(box_));
    const Relation open = touches ? Relation::partial : truth;
    compare("certified, near plane open", overlap(*made_.shadow, box_, NearBoundary::open).relation, open);
    if (twice) judge_again(truth, open);
  }

  void judge_again(Relation truth, Relation open) {
    ++report_.tally.judged_twice;
    const oracle::Answer second = oracle::second::relation(to_oracle(question_.region), to_oracle(question_.occluder),
                                                           to_oracle(question_.kind), to_oracle(box_));
    compare("second oracle", relation_of(second.relation), truth);
    // What the oracle proves of culls: eyes that a polygon is strictly before.
    const bool is_cull = question_.kind == kernel::ShadowKind::umbra &&
                         question_.region.kind == kernel::Viewpoint::Kind::eye &&
                         std::holds_alternative<Polygon>(question_.occluder);
    if (!is_cull) return;
    const oracle::Answer hidden =
        oracle::relation_to_umbra(to_oracle(question_.region.box), to_oracle(question_.occluder), to_oracle(box_));
    const bool agree = hidden.refusal.empty() && (hidden.relation == oracle::Relation::inside) == (open == Relation::inside);
    if (!agree) add("relation_to_umbra: " + hidden.refusal + text(relation_of(hidden.relation)), "cull", text(truth));
  }

  void compare(const std::string& kind, Relation answer, Relation truth) {
    if (answer != truth) add(text(answer) + ", the oracle: " + text(truth), kind, text(truth));
  }

  void add(const std::string& what, const std::string& kind, const std::string& expect) {
    if (!is_wrong_) ++report_.tally.disagreements;
    is_wrong_ = true;
    const RegionCase found{question_.region, question_.kind, question_.occluder, box_};
    report_.findings.push_back({kind, what + "; " + cases::write_case(kind, found, expect)});
  }

  const RegionCase& question_;
  Report& report_;
  Box box_;
  kernel::RegionShadowResult made_;
  oracle::RegionShadow truth_;
  bool is_wrong_ = false;  ///< the current case has a wrong answer
};

}  // namespace

void run_region_shadows(kernel::ShadowKind kind, std::uint64_t seed, Report& report) {
  Random random(seed);
  const RegionCase question = region_question(random, kind);
  RegionJudgement judgement(question, report);
  for (std::uint64_t i = 0; i < kBoxes; ++i) {
    judgement.judge(i == 0 ? question.box : neighbour(question.box, random.bits()), is_judged_twice(seed * kBoxes + i));
  }
}

}  // namespace occlude::fuzz
