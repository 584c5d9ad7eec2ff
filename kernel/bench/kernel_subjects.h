// SPDX-License-Identifier: MIT
// The kernel's own tests, and the one that the paper sets out from.
#pragma once

#include <vector>

#include "subject.h"

namespace occlude::bench {

[[nodiscard]] std::vector<Subject> kernel_subjects();

}  // namespace occlude::bench
