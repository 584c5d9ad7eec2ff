// SPDX-License-Identifier: MIT
// The edges of a shadow frustum in plain doubles, for the paper's own tests.
#pragma once

#include <vector>

#include "occlude/kernel/shadow_frustum.h"

namespace occlude::kernel {

/// The rays in which neighbouring side planes meet, from the near side outwards, and the edges of the near side; relative to
/// the origin of the frustum.
void append_plain_edges(const ShadowFrustum& frustum, std::vector<PlainEdge>& edges);

}  // namespace occlude::kernel
