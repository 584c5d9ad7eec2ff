// SPDX-License-Identifier: MIT
#include "overlap.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "answers.h"
#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/batch.h"
#include "occlude/oracle/second.h"
#include "rivals.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::NearBoundary;
using kernel::Relation;
using kernel::ShadowFrustum;

constexpr const char* kSecondOracle = "second oracle";

oracle::Shadow shadow_of(const Case& c, const kernel::ShadowFrustumResult& made) {
  return {to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made)};
}

/// One shadow, and the judgement of the boxes that are asked about it.
class Judgement {
 public:
  Judgement(const Case& question, Report& report)
      : question_(question), report_(report), made_(make_frustum(question)), shadow_(shadow_of(question, made_)) {}

  void judge(const Box& box, bool twice) {
    ++report_.tally.cases;
    is_wrong_ = false;
    judge_answers(box, twice);
  }

  /// Asks the axis-aligned boxes again, all at once.
  void judge_batches() {
    if (boxes_.empty()) return;
    judge_batch(NearBoundary::closed);
    judge_batch(NearBoundary::open);
  }

 private:
  /// Whether `conservative` says inside exactly when that is true, and outside only when that is true.
  static bool is_sound(Relation conservative, Relation truth) {
    return conservative == truth || (conservative == Relation::partial && truth == Relation::outside);
  }

  void judge_answers(const Box& box, bool twice) {
    const oracle::Answer answer = shadow_.relation(to_oracle(box));
    const bool refused = !made_.frustum || check(box) != kernel::Refusal::none;
    if (refused != !answer.refusal.empty()) {
      return add_finding(
          box, "refusal",
          refused ? "the kernel refuses, the oracle answers" : "the kernel answers, the oracle refuses: " + answer.refusal);
    }
    if (refused) {
      ++report_.tally.refused;
      return;
    }
    const Relation truth = relation_of(answer.relation);
    if (has_needless_support_plane()) add_finding(box, "near plane", "a support plane for what has its own");
    if (twice) judge_again(box, truth);
    judge_certified(box, truth);
    judge_conservative(box, truth);
    const Relation open = truth_if_open(box, truth);
    judge_open(box, open);
    count_others(box, truth);
    if (const auto* const aabb = std::get_if<kernel::Aabb>(&box)) {
      boxes_.push_back(*aabb);
      asked_.push_back({truth, open, is_wrong_});
    }
  }

  /// Only polygons that are not coplanar have a support plane, and the oracle refuses these with near `surface`. Elsewhere a
  /// support plane would be believed even if it were far behind the occluder.
  bool has_needless_support_plane() const {
    if (!made_.frustum->support_plane()) return false;
    const oracle::Shadow flat(to_oracle(question_.viewpoint), to_oracle(question_.occluder), to_oracle(Near::surface));
    return question_.near != Near::surface || flat.refusal().empty();
  }

  void judge_certified(const Box& box, Relation truth) {
    const kernel::Decision certified = overlap(*made_.frustum, box);
    report_.tally.count(truth, certified.stage);
    if (certified.relation != truth) add_finding(box, "certified", certified.relation, truth);
  }

  void judge_conservative(const Box& box, Relation truth) {
    const Relation planes = conservative(*made_.frustum, box).relation;
    report_.tally.planes_asked += truth == Relation::outside ? 1 : 0;
    report_.tally.undecided += truth == Relation::outside && planes == Relation::partial ? 1 : 0;
    if (!is_sound(planes, truth)) add_finding(box, "conservative", planes, truth);
  }

  /// With an open near plane, a box that is inside stays inside when it is strictly beyond that plane. Else it is partial.
  /// The other relations stay the same.
  Relation truth_if_open(const Box& box, Relation truth) {
    const bool touches = truth == Relation::inside && !shadow_.refute_cull(to_oracle(box)).empty();
    return touches ? Relation::partial : truth;
  }

  void judge_open(const Box& box, Relation truth) {
    const Relation answer = overlap(*made_.frustum, box, NearBoundary::open).relation;
    if (answer != truth) add_finding(box, "certified, near plane open", answer, truth);
    const Relation planes = conservative(*made_.frustum, box, NearBoundary::open).relation;
    if (!is_sound(planes, truth)) add_finding(box, "conservative, near plane open", planes, truth);
  }

  void judge_batch(NearBoundary near) {
    const std::string ending = near == NearBoundary::open ? ", near plane open" : "";
    std::vector<Relation> overlap(boxes_.size()), conservative(boxes_.size());
    const kernel::BoxBatch boxes(boxes_);
    kernel::overlap_certified(*made_.frustum, boxes, near, overlap);
    kernel::conservative_certified(*made_.frustum, boxes, near, conservative);
    const kernel::FrustumBatch frusta({&*made_.frustum, 1});
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      std::array<Relation, 1> one{};
      kernel::overlap_certified(frusta, boxes_[i], near, one);
      const Relation truth = near == NearBoundary::open ? asked_[i].open : asked_[i].closed;
      is_wrong_ = asked_[i].is_wrong;
      if (overlap[i] != truth) add_finding(boxes_[i], "batch of boxes" + ending, overlap[i], truth);
      if (one[0] != truth) add_finding(boxes_[i], "batch of frusta" + ending, one[0], truth);
      if (!is_sound(conservative[i], truth)) add_finding(boxes_[i], "conservative batch" + ending, conservative[i], truth);
      asked_[i].is_wrong = is_wrong_;
    }
  }

  void judge_again(const Box& box, Relation truth) {
    ++report_.tally.judged_twice;
    const oracle::Answer second = oracle::second::relation(to_oracle(question_.viewpoint), to_oracle(question_.occluder),
                                                           to_oracle(question_.near, made_), to_oracle(box));
    const Relation answer = relation_of(second.relation);
    if (answer != truth) add_finding(box, kSecondOracle, answer, truth);
  }

  void count_others(const Box& box, Relation truth) {
    ++report_.tally.others_asked;
    report_.tally.plain.count(overlap_plain(*made_.frustum, box), truth);
    report_.tally.float32.count(overlap_float32(*made_.frustum, box), truth);
    report_.tally.fused.count(overlap_fused(*made_.frustum, box), truth);
  }

  void add_finding(const Box& box, const std::string& kind, Relation answer, Relation truth) {
    add_finding(box, kind, text(answer) + ", the oracle: " + text(truth));
  }

  void add_finding(const Box& box, const std::string& kind, const std::string& what) {
    if (!std::exchange(is_wrong_, true)) ++report_.tally.disagreements;
    Case found{question_.viewpoint, question_.occluder, question_.near, box};
    std::string expect = judged_answer(found);
    report_.findings.push_back({kind, what, std::move(found), std::move(expect)});
  }

  const Case& question_;
  Report& report_;
  kernel::ShadowFrustumResult made_;
  oracle::Shadow shadow_;
  bool is_wrong_ = false;  ///< the current case has a wrong answer

  /// The facts about an axis-aligned box.
  struct Asked {
    Relation closed, open;  ///< the right answers
    bool is_wrong;          ///< some answer so far was wrong
  };
  std::vector<kernel::Aabb> boxes_;
  std::vector<Asked> asked_;  ///< for each of the boxes
};

}  // namespace

void judge_overlap(const Case& question, std::span<const Box> boxes, std::uint64_t seed, Report& report) {
  Judgement judgement(question, report);
  for (std::size_t i = 0; i < boxes.size(); ++i) judgement.judge(boxes[i], is_judged_twice(seed * kGroup + i));
  judgement.judge_batches();
}

void run_overlap(Family family, std::uint64_t seed, Report& report) {
  const Case question = make_case(family, seed);
  std::vector<Box> boxes{question.box};
  while (boxes.size() < kGroup) boxes.push_back(neighbour(question.box, seed * kGroup + boxes.size()));
  judge_overlap(question, boxes, seed, report);
}

std::string judged_answer(const Case& question) {
  const kernel::ShadowFrustumResult made = make_frustum(question);
  const oracle::Near near = made.frustum ? to_oracle(question.near, made) : to_oracle(question.near);
  const oracle::Answer answer =
      oracle::relation(to_oracle(question.viewpoint), to_oracle(question.occluder), near, to_oracle(question.box));
  return answer.refusal.empty() ? text(relation_of(answer.relation)) : "";
}

std::optional<Finding> find_again(const Case& question, const std::string& kind) {
  Report report;
  Judgement judgement(question, report);
  judgement.judge(question.box, kind == kSecondOracle);
  judgement.judge_batches();
  const auto same = std::ranges::find(report.findings, kind, &Finding::kind);
  return same != report.findings.end() ? std::optional(*same) : std::nullopt;
}

}  // namespace occlude::fuzz
