// SPDX-License-Identifier: MIT
// A frame of a walk as a line of a log of culls, for `occlude audit` (docs/audit.md).
#pragma once

#include <string>

#include "occlude/culler/hierarchy.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// Lists what the frame draws. Of a polygon in pieces, all of it is drawn if one of them is.
[[nodiscard]] std::string log_line(const ShownFrame& frame, const culler::Hierarchy& hierarchy, const WalkOptions& options);

}  // namespace occlude::render
