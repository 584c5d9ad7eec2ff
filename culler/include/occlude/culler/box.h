// SPDX-License-Identifier: MIT
// The bounding volumes that the culler asks about. Reading order: 3.
#pragma once

#include <variant>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// An axis-aligned or an oriented box. It is legal if kernel::check(box) == Refusal::none (occlude/kernel/validity.h).
using Box = std::variant<kernel::Aabb, kernel::Obb>;

}  // namespace occlude::culler
