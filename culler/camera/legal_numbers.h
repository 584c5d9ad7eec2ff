// SPDX-License-Identifier: MIT
// Which numbers a camera may have: those that are legal for the kernel.
#pragma once

#include <glm/vec3.hpp>

#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

[[nodiscard]] inline bool is_legal(const glm::dvec3& v) { return kernel::check(to_kernel(v)) == kernel::Refusal::none; }
[[nodiscard]] inline bool is_legal_length(double x) { return x > 0 && kernel::check(x) == kernel::Refusal::none; }

}  // namespace occlude::culler
