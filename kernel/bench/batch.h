// SPDX-License-Identifier: MIT
// The kernel's batches, for each instruction set.
#pragma once

#include <vector>

#include "subject.h"

namespace occlude::bench {

/// Both tests as the kernel dispatches them, `batch_overlap` and `batch_conservative`, and the conservative test with each
/// instruction set that this machine has: `batch_conservative_sse2`, `_avx2`, `_avx512`.
[[nodiscard]] std::vector<Subject> batch_subjects();

}  // namespace occlude::bench
