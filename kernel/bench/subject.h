// SPDX-License-Identifier: MIT
// The subject of a measurement: something that answers a question about boxes.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "occlude/kernel/types.h"
#include "workloads.h"

namespace occlude::bench {

/// The question that a subject answers. `relation`: all three relations. `overlap`: `outside` or not, where `partial` stands
/// for not. `containment`: `inside` or not. `conservative`: as `relation`, but it may answer `partial` where it does not
/// know.
enum class Question { relation, overlap, containment, conservative };

/// Answers every box of a workload once, in order.
using Pass = std::function<void(std::span<kernel::Relation>)>;

struct Subject {
  std::string name;
  Question question = Question::relation;
  /// Makes whatever the subject has ready before it is asked: shapes, centres, batches. This is not timed. The workload
  /// outlives the pass.
  std::function<Pass(const Workload&)> prepare;
  bool gjk = false;  ///< an iterative search over support points, the kind of test that the paper compares with
};

[[nodiscard]] constexpr bool is_wrong(Question question, kernel::Relation answer, kernel::Relation truth) {
  using kernel::Relation;
  switch (question) {
    case Question::overlap:
      return (answer == Relation::outside) != (truth == Relation::outside);
    case Question::containment:
      return (answer == Relation::inside) != (truth == Relation::inside);
    case Question::conservative:
      return answer != Relation::partial && answer != truth;
    case Question::relation:
      break;
  }
  return answer != truth;
}

/// A pass that calls `answer(i)` for every box.
template <class Answer>
[[nodiscard]] Pass each_box(Answer answer) {
  return [answer = std::move(answer)](std::span<kernel::Relation> answers) mutable {
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = answer(i);
  };
}

}  // namespace occlude::bench
