// SPDX-License-Identifier: MIT
// The proof of a cull in numbers, for independent checks: one line of JSON per culled subtree.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::render {

/// The covers of what the cover of a frame that was culled with these options hides; none by Method::frusta. A cover of more
/// than kMostCoverVertices vertices is told as covers of smaller subtrees, or of single polygons.
[[nodiscard]] std::vector<culler::CoverWitness> covers_of(const culler::Culler& culler, const culler::Camera& camera,
                                                          const culler::CullResult& result,
                                                          const culler::CullOptions& options);

/// Appends one line, without line break, for each culled subtree of a frame. If the leaves of the tree are not of the size
/// that is best for frusta, each line has their size: the order of the triangles depends on it. REQUIRES: culled with these
/// options; `covers` are covers_of() it.
void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const culler::Camera& camera,
                      const culler::Culler& culler, const culler::CullResult& result, const culler::CullOptions& options,
                      std::span<const culler::CoverWitness> covers);

}  // namespace occlude::render
