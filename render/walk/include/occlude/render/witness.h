// SPDX-License-Identifier: MIT
// The proof of a cull in numbers, as others can check it: one JSON line per culled subtree.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::render {

/// Appends one line, without its end, for each culled subtree of the frame, which was culled with these options. A cover of
/// more than kMostCoverVertices is written as those of smaller subtrees, or of polygons.
void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const culler::Camera& camera,
                      const culler::Culler& culler, const culler::CullResult& result, const culler::CullOptions& options);

}  // namespace occlude::render
