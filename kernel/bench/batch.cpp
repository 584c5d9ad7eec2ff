// SPDX-License-Identifier: MIT
#include "batch.h"

#include <hwy/targets.h>

#include <array>
#include <cstdint>
#include <memory>

#include "occlude/kernel/batch.h"

namespace occlude::bench {
namespace {

using kernel::BoxBatch;
using kernel::NearBoundary;
using kernel::ShadowFrustum;

/// While this object lives, Highway chooses only among these targets.
class OnlyTargets {
 public:
  explicit OnlyTargets(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(targets);
  }
  ~OnlyTargets() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();  // the next call chooses again
  }
  OnlyTargets(const OnlyTargets&) = delete;
  OnlyTargets& operator=(const OnlyTargets&) = delete;
};

struct InstructionSet {
  const char* subject;
  std::int64_t targets;
};

/// SSSE3 stands for SSE2: it is the lowest target of Highway 1.0, and also has two doubles per vector.
constexpr std::array kInstructionSets{InstructionSet{"batch_conservative_sse2", HWY_SSSE3},
                                      InstructionSet{"batch_conservative_avx2", HWY_AVX2},
                                      InstructionSet{"batch_conservative_avx512", HWY_AVX3 | HWY_AVX3_DL}};

/// A pass that gives all boxes to `test` at once, as a batch made beforehand.
template <class Test>
Pass batch_pass(const Workload& workload, Test test) {
  return [&workload, test, batch = std::make_shared<const BoxBatch>(workload.boxes)](std::span<kernel::Relation> answers) {
    test(workload.frustum, *batch, answers);
  };
}

void plane_stage(const ShadowFrustum& frustum, const BoxBatch& batch, std::span<kernel::Relation> answers) {
  kernel::conservative_certified(frustum, batch, NearBoundary::closed, answers);
}

void overlap(const ShadowFrustum& frustum, const BoxBatch& batch, std::span<kernel::Relation> answers) {
  kernel::overlap_certified(frustum, batch, NearBoundary::closed, answers);
}

Subject plane_stage_by(const InstructionSet& set) {
  return {set.subject, Question::conservative, [targets = set.targets](const Workload& workload) {
            return batch_pass(workload, [targets](const auto& frustum, const auto& batch, auto answers) {
              const OnlyTargets only(targets);
              plane_stage(frustum, batch, answers);
            });
          }};
}

}  // namespace

std::vector<Subject> batch_subjects() {
  std::vector<Subject> subjects{
      {"batch_overlap", Question::relation, [](const Workload& workload) { return batch_pass(workload, overlap); }},
      {"batch_conservative", Question::conservative,
       [](const Workload& workload) { return batch_pass(workload, plane_stage); }}};
  for (const InstructionSet& set : kInstructionSets) {
    if ((hwy::SupportedTargets() & set.targets) != 0) subjects.push_back(plane_stage_by(set));
  }
  return subjects;
}

}  // namespace occlude::bench
