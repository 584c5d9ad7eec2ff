// SPDX-License-Identifier: MIT
#include "any_case.h"
#include "experiment.h"
#include "occlude/fuzz/spoil.h"
#include "overlap.h"
#include "rows.h"

namespace occlude::fuzz {

void run_refusals(std::uint64_t seed, Report& report) {
  Random random(seed);
  for (std::uint64_t i = 0; i < kGroup; ++i) {
    Case question = any_case(random);
    spoil(random, question);
    judge_overlap(question, {&question.box, 1}, seed, report);
  }
}

}  // namespace occlude::fuzz
