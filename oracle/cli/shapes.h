// SPDX-License-Identifier: MIT
// The kinds of boxes and of occluders that case files and witness files hold.
#pragma once

#include <variant>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::cli {

using Box = std::variant<kernel::Aabb, kernel::Obb>;

using Polygon = std::vector<kernel::Vec3>;
using Occluder = std::variant<Polygon, kernel::Polytope>;

}  // namespace occlude::cli
