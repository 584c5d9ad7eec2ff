// SPDX-License-Identifier: MIT
// The kernel's own tests, and the naive test that the paper starts from.
#pragma once

#include <vector>

#include "subject.h"

namespace occlude::bench {

[[nodiscard]] std::vector<Subject> kernel_subjects();

/// The certified overlap test, under the name that comparisons with peers use.
[[nodiscard]] Subject reference_subject();

}  // namespace occlude::bench
