// SPDX-License-Identifier: MIT
// The kernel's own tests, and the one that the paper sets out from.
#pragma once

#include <vector>

#include "subject.h"

namespace occlude::bench {

[[nodiscard]] std::vector<Subject> kernel_subjects();

/// The certified overlap test under the name by which peers are compared to it.
[[nodiscard]] Subject reference_subject();

}  // namespace occlude::bench
