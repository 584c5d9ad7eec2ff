// SPDX-License-Identifier: MIT
#include "kernel_subjects.h"

#include "naive.h"
#include "occlude/kernel/overlap.h"
#include "peer_results.h"

namespace occlude::bench {
namespace {

using kernel::Aabb;
using kernel::ShadowFrustum;

/// A subject that calls `test` for each box.
template <class Test>
Subject kernel_subject(const char* name, Question question, Test test) {
  return {name, question, [test](const Workload& workload) {
            return each_box([&workload, test](std::size_t i) { return test(workload.frustum, workload.boxes[i]); });
          }};
}

Pass prepare_naive(const Workload& workload) {
  return each_box([&workload, frustum = NaiveFrustum(BoundedFrustum(workload))](std::size_t i) {
    return naive_overlap(frustum, workload.boxes[i]);
  });
}

Subject certified_overlap(const char* name) {
  return kernel_subject(name, Question::relation,
                        [](const ShadowFrustum& f, const Aabb& b) { return kernel::overlap_certified(f, b).relation; });
}

}  // namespace

Subject reference_subject() { return certified_overlap(kReference); }

std::vector<Subject> kernel_subjects() {
  return {
      certified_overlap("overlap_certified"),
      kernel_subject("overlap_plain", Question::relation,
                     [](const ShadowFrustum& f, const Aabb& b) { return kernel::overlap_plain(f, b); }),
      kernel_subject("conservative_certified", Question::conservative,
                     [](const ShadowFrustum& f, const Aabb& b) { return kernel::conservative_certified(f, b).relation; }),
      kernel_subject("conservative_plain", Question::conservative,
                     [](const ShadowFrustum& f, const Aabb& b) { return kernel::conservative_plain(f, b); }),
      {"naive", Question::relation, prepare_naive},
  };
}

}  // namespace occlude::bench
