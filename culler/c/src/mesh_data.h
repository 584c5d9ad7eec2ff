// SPDX-License-Identifier: MIT
// Polygons of the caller.
#pragma once

#include "occlude.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::c {

/// A copy. Throws std::invalid_argument for what is no list of polygons.
[[nodiscard]] culler::PolygonSoup soup_of(const occlude_mesh_data& data);

/// Where the caller has work on it done, and whether it still wants it.
[[nodiscard]] culler::Checkpoint checkpoint_of(const occlude_mesh_data& data);

}  // namespace occlude::c
