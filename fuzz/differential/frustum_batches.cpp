// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "answers.h"
#include "any_case.h"
#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/kernel/batch.h"
#include "rows.h"

namespace occlude::fuzz {
namespace {

using kernel::NearBoundary;
using kernel::Relation;

/// Cases that have a shadow.
std::vector<Case> cases_of(Random& random) {
  std::vector<Case> cases;
  while (cases.size() < kGroup) {
    cases.push_back(any_legal_case(random));
  }
  return cases;
}

/// The first box that a batch accepts. It touches the shadow of its own case, and its relation to the others is arbitrary.
kernel::Aabb box_of(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    if (const auto* const box = std::get_if<kernel::Aabb>(&c.box)) return *box;
  }
  return {};
}

/// The answers of all frusta about the box, from one call.
struct Answers {
  Answers(const kernel::FrustumBatch& batch, const kernel::Aabb& box, NearBoundary near) {
    kernel::overlap_certified(batch, box, near, overlap);
    kernel::conservative_certified(batch, box, near, conservative);
  }

  std::vector<Relation> overlap = std::vector<Relation>(kGroup), conservative = overlap;
};

/// What is wrong with the answers about frustum i. Empty when nothing is.
std::string fault_of(const Answers& answers, std::size_t i, Relation truth) {
  const bool is_undecided = truth == Relation::outside && answers.conservative[i] == Relation::partial;
  if (answers.overlap[i] == truth && (answers.conservative[i] == truth || is_undecided)) return "";
  return "overlap " + text(answers.overlap[i]) + ", conservative " + text(answers.conservative[i]) +
         ", the oracle: " + text(truth);
}

}  // namespace

void run_frustum_batch(std::uint64_t seed, Report& report) {
  Random random(seed);
  std::vector<Case> cases = cases_of(random);
  const kernel::Aabb box = box_of(cases);
  std::vector<kernel::ShadowFrustum> frusta;
  for (const Case& c : cases) frusta.push_back(*make_frustum(c).frustum);
  const kernel::FrustumBatch batch(frusta);
  const Answers closed(batch, box, NearBoundary::closed), open(batch, box, NearBoundary::open);
  for (std::size_t i = 0; i < kGroup; ++i) {
    Case& c = cases[i];
    c.box = box;
    oracle::Shadow shadow(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, {frusta[i], {}}));
    const oracle::Answer answer = shadow.relation(to_oracle(c.box));
    const Relation truth = relation_of(answer.relation);
    const bool touches = truth == Relation::inside && !shadow.refute_cull(to_oracle(c.box)).empty();
    ++report.tally.cases;
    report.tally.count(truth, overlap(frusta[i], c.box).stage);
    report.tally.planes_asked += truth == Relation::outside ? 1 : 0;
    report.tally.undecided += truth == Relation::outside && closed.conservative[i] == Relation::partial ? 1 : 0;
    std::string fault = answer.refusal.empty() ? fault_of(closed, i, truth) : "the oracle: " + answer.refusal;
    std::string kind = "batch of frusta";
    if (fault.empty()) {
      fault = fault_of(open, i, touches ? Relation::partial : truth);
      kind += ", near plane open";
    }
    if (fault.empty()) continue;
    ++report.tally.disagreements;
    report.findings.push_back(
        {kind, "number " + std::to_string(i) + ": " + fault, std::move(c), answer.refusal.empty() ? text(truth) : ""});
  }
}

}  // namespace occlude::fuzz
