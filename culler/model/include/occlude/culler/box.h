// SPDX-License-Identifier: MIT
// The bounding volumes that the culler asks about. Reading order: 3.
#pragma once

#include <string_view>
#include <variant>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// An axis-aligned or an oriented box. It is legal if kernel::check(box) == Refusal::none (occlude/kernel/validity.h).
using Box = std::variant<kernel::Aabb, kernel::Obb>;

/// Why a scene refuses the box: a number that is NaN, or min > max. Empty if it takes it. A box that a scene takes need not
/// be legal.
[[nodiscard]] std::string_view fault(const Box& box);

}  // namespace occlude::culler
