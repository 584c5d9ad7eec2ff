// SPDX-License-Identifier: MIT
#include "frustum_batches.h"

#include <utility>
#include <variant>
#include <vector>

#include "answers.h"
#include "any_case.h"
#include "experiment.h"
#include "cases/ask.h"
#include "occlude/kernel/batch.h"
#include "cases/to_oracle.h"

namespace occlude::fuzz {
namespace {

using kernel::NearBoundary;
using kernel::Relation;

/// Cases with a shadow.
std::vector<Case> cases_of(Random& random) {
  std::vector<Case> cases;
  while (cases.size() < kGroup) {
    cases.push_back(any_legal_case(random));
  }
  return cases;
}

/// The first box that can be in a batch: touching the shadow of its own case and lying anyhow to the others.
kernel::Aabb box_of(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    if (const auto* const box = std::get_if<kernel::Aabb>(&c.box)) return *box;
  }
  return {};
}

}  // namespace

void run_frustum_batch(std::uint64_t seed, Report& report) {
  Random random(seed);
  std::vector<Case> cases = cases_of(random);
  const kernel::Aabb box = box_of(cases);
  std::vector<kernel::ShadowFrustum> frusta;
  for (const Case& c : cases) frusta.push_back(*make_frustum(c).frustum);
  const kernel::FrustumBatch batch(frusta);
  std::vector<Relation> overlaps(kGroup), planes(kGroup);
  kernel::overlap_certified(batch, box, NearBoundary::closed, overlaps);
  kernel::conservative_certified(batch, box, NearBoundary::closed, planes);
  for (std::size_t i = 0; i < kGroup; ++i) {
    Case& c = cases[i];
    c.box = box;
    const oracle::Answer answer = oracle::relation(to_oracle(c.viewpoint), to_oracle(c.occluder),
                                                   to_oracle(c.near, {frusta[i], {}}), to_oracle(c.box));
    const Relation truth = relation_of(answer.relation);
    ++report.tally.cases;
    report.tally.count(truth, overlap(frusta[i], c.box).stage);
    report.tally.planes_asked += truth == Relation::outside ? 1 : 0;
    const bool is_undecided = truth == Relation::outside && planes[i] == Relation::partial;
    report.tally.undecided += is_undecided ? 1 : 0;
    if (answer.refusal.empty() && overlaps[i] == truth && (planes[i] == truth || is_undecided)) continue;
    ++report.tally.disagreements;
    report.findings.push_back({"frustum_batch", seed, "batch of frusta",
                               "number " + std::to_string(i) + ": overlap " + text(overlaps[i]) + ", conservative " +
                                   text(planes[i]) +
                                   ", the oracle: " + (answer.refusal.empty() ? text(truth) : answer.refusal),
                               std::move(c), answer.refusal.empty() ? text(truth) : ""});
  }
}

}  // namespace occlude::fuzz
