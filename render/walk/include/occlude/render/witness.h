// SPDX-License-Identifier: MIT
// The proof of a cull in numbers, for independent checks: one line of JSON per culled subtree.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::render {

/// Appends one line, without line break, for each culled subtree of a frame that was culled with these options. A cover of
/// more than kMostCoverVertices vertices is written as covers of smaller subtrees, or of single polygons. If the leaves of
/// the tree are not of the size that is best for frusta, each line has their size: the order of the triangles depends on it.
void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const culler::Camera& camera,
                      const culler::Culler& culler, const culler::CullResult& result, const culler::CullOptions& options);

}  // namespace occlude::render
