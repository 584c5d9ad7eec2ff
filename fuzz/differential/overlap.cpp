// SPDX-License-Identifier: MIT
#include "overlap.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "answers.h"
#include "experiment.h"
#include "occlude/fuzz/ask.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/batch.h"
#include "occlude/oracle/second.h"
#include "rivals.h"
#include "to_oracle.h"

namespace occlude::fuzz {
namespace {

using kernel::NearBoundary;
using kernel::Relation;
using kernel::ShadowFrustum;

/// The second oracle is slow: it judges one case in so many.
constexpr std::uint64_t kJudgedTwice = 100;

oracle::Shadow shadow_of(const Case& c, const kernel::ShadowFrustumResult& made) {
  return {to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made)};
}

/// One shadow, and what becomes of the boxes put to it.
class Judgement {
 public:
  Judgement(const Case& question, const std::string& family, std::uint64_t seed, Report& report)
      : question_(question),
        family_(family),
        seed_(seed),
        report_(report),
        made_(make_frustum(question)),
        shadow_(shadow_of(question, made_)) {}

  /// `number` tells the cases of the family apart.
  void judge(const Box& box, std::uint64_t number) {
    ++report_.tally.cases;
    const oracle::Answer answer = shadow_.relation(to_oracle(box));
    const bool refused = !made_.frustum || check(box) != kernel::Refusal::none;
    if (refused != !answer.refusal.empty()) {
      const std::string theirs = answer.refusal.empty() ? "answers" : "refuses: " + answer.refusal;
      return add_finding(box, "the kernel " + std::string(refused ? "refuses" : "answers") + ", the oracle " + theirs);
    }
    if (refused) {
      ++report_.tally.refused;
      return;
    }
    const Relation truth = relation_of(answer.relation);
    if (number % kJudgedTwice == 0) judge_again(box, truth);
    const kernel::Decision certified = overlap(*made_.frustum, box);
    report_.tally.count(truth, certified.stage);
    if (const std::string fault = fault_of(box, certified.relation, truth); !fault.empty()) add_finding(box, fault);
    count_rivals(box, truth);
    if (const auto* const aabb = std::get_if<kernel::Aabb>(&box)) {
      batch_.push_back(*aabb);
      truths_.push_back(truth);
    }
  }

  /// The axis-aligned boxes once more, all at once.
  void judge_batch() {
    if (batch_.empty()) return;
    std::vector<Relation> overlap(batch_.size()), conservative(batch_.size());
    const kernel::BoxBatch boxes(batch_);
    kernel::overlap_certified(*made_.frustum, boxes, NearBoundary::closed, overlap);
    kernel::conservative_certified(*made_.frustum, boxes, NearBoundary::closed, conservative);
    const kernel::FrustumBatch frusta({&*made_.frustum, 1});
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      std::array<Relation, 1> one{};
      kernel::overlap_certified(frusta, batch_[i], NearBoundary::closed, one);
      if (overlap[i] != truths_[i]) add_finding(batch_[i], "batch of boxes: " + text(overlap[i]));
      if (one[0] != truths_[i]) add_finding(batch_[i], "batch of frusta: " + text(one[0]));
      if (!is_sound(conservative[i], truths_[i])) add_finding(batch_[i], "conservative batch: " + text(conservative[i]));
    }
  }

 private:
  /// `conservative` says inside when, and only when, that is so, and outside only then.
  static bool is_sound(Relation conservative, Relation truth) {
    return conservative == truth || (conservative == Relation::partial && truth == Relation::outside);
  }

  /// What an answer that claims to be right has wrong.
  std::string fault_of(const Box& box, Relation certified, Relation truth) {
    if (certified != truth) return "certified: " + text(certified) + ", the oracle: " + text(truth);
    const ShadowFrustum& frustum = *made_.frustum;
    const Relation planes = conservative(frustum, box).relation;
    if (!is_sound(planes, truth)) return "conservative: " + text(planes) + ", the oracle: " + text(truth);
    report_.tally.undecided += planes != truth;
    if (truth != Relation::inside) return "";
    const Relation beyond = shadow_.refute_cull(to_oracle(box)).empty() ? Relation::inside : Relation::partial;
    const Relation open = overlap(frustum, box, NearBoundary::open).relation;
    if (open != beyond) return "certified, near plane open: " + text(open) + ", the oracle: " + text(beyond);
    const Relation open_planes = conservative(frustum, box, NearBoundary::open).relation;
    if (open_planes != beyond)
      return "conservative, near plane open: " + text(open_planes) + ", the oracle: " + text(beyond);
    return "";
  }

  void judge_again(const Box& box, Relation truth) {
    ++report_.tally.judged_twice;
    const oracle::Answer second = oracle::second::relation(to_oracle(question_.viewpoint), to_oracle(question_.occluder),
                                                           to_oracle(question_.near, made_), to_oracle(box));
    const Relation answer = relation_of(second.relation);
    if (answer != truth) add_finding(box, "the second oracle: " + text(answer) + ", the first: " + text(truth));
  }

  void count_rivals(const Box& box, Relation truth) {
    report_.tally.plain.count(overlap_plain(*made_.frustum, box), truth);
    report_.tally.float32.count(overlap_float32(*made_.frustum, box), truth);
    report_.tally.fused.count(overlap_fused(*made_.frustum, box), truth);
  }

  void add_finding(const Box& box, const std::string& what) {
    ++report_.tally.disagreements;
    Case found{question_.viewpoint, question_.occluder, question_.near, box};
    std::string expect = judged_answer(found);
    report_.findings.push_back({family_, seed_, what, std::move(found), std::move(expect)});
  }

  const Case& question_;
  const std::string& family_;
  std::uint64_t seed_;
  Report& report_;
  kernel::ShadowFrustumResult made_;
  oracle::Shadow shadow_;
  std::vector<kernel::Aabb> batch_;
  std::vector<Relation> truths_;
};

}  // namespace

void judge_overlap(const Case& question, std::span<const Box> boxes, const std::string& family, std::uint64_t seed,
                   Report& report) {
  Judgement judgement(question, family, seed, report);
  for (std::size_t i = 0; i < boxes.size(); ++i) judgement.judge(boxes[i], seed * kGroup + i);
  judgement.judge_batch();
}

void run_overlap(Family family, std::uint64_t seed, Report& report) {
  const Case question = make_case(family, seed);
  std::vector<Box> boxes{question.box};
  while (boxes.size() < kGroup) boxes.push_back(neighbour(question.box, seed * kGroup + boxes.size()));
  judge_overlap(question, boxes, std::string(name(family)), seed, report);
}

std::string judged_answer(const Case& question) {
  const kernel::ShadowFrustumResult made = make_frustum(question);
  const oracle::Answer answer = shadow_of(question, made).relation(to_oracle(question.box));
  return answer.refusal.empty() ? text(relation_of(answer.relation)) : "";
}

bool is_disagreement(const Case& question) {
  Report report;
  judge_overlap(question, {&question.box, 1}, "", 0, report);
  return report.tally.disagreements != 0;
}

}  // namespace occlude::fuzz
