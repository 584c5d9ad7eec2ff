// SPDX-License-Identifier: MIT
// One instruction set of those that this machine has.
#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace occlude {

/// Lets Highway choose this target alone while it lives.
class OnlyTarget {
 public:
  explicit OnlyTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
  }
  ~OnlyTarget() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();  // the next call chooses anew
  }
  OnlyTarget(const OnlyTarget&) = delete;
  OnlyTarget& operator=(const OnlyTarget&) = delete;
};

}  // namespace occlude
