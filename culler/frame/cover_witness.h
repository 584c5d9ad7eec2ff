// SPDX-License-Identifier: MIT
// Names what hides each cull by cover, and what was asked by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

/// As Culler::append_covers(), and then a witness for each of these polygons. REQUIRES: the cover of the frame hides their
/// boxes (cover/asked_box.h).
void append_covers(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options,
                   std::size_t most, std::span<const std::uint32_t> asked, std::vector<CoverWitness>& witnesses);

}  // namespace occlude::culler
