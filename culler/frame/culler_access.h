// SPDX-License-Identifier: MIT
// What the project itself asks of a culler, beside what programs do. Reading order: 12.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "frusta/occluder_set.h"
#include "model/block_tree.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {

struct CullerAccess {
  [[nodiscard]] static const OccluderSet& occluders(const Culler& culler) { return culler.occluders(); }
  [[nodiscard]] static BlockTree tree(const Culler& culler) { return culler.tree(); }
  [[nodiscard]] static const CoverTriangles& triangles(const Culler& culler) { return culler.triangles(); }
  [[nodiscard]] static Culler with(const Culler& culler, OccluderSet occluders) { return {culler, std::move(occluders)}; }
};

/// The potential occluders among the polygons of the tree's soup, and the regions that list them. Made now, as by
/// Culler::prepare(), if neither that nor a frame has.
[[nodiscard]] inline const OccluderSet& occluders_of(const Culler& culler) { return CullerAccess::occluders(culler); }

/// The same culler with what listed occluders hide, in the order of the lists (OccluderLists::Stored). Throws
/// std::invalid_argument unless there is a finite number, not below 0, for each entry.
[[nodiscard]] inline Culler with_hidden(const Culler& culler, std::vector<float> hidden) {
  return CullerAccess::with(culler, occluders_of(culler).with_hidden(std::move(hidden)));
}

/// Calls `visit` for every test of a box against the shadow of one occluder that `frame` took, in the order of the
/// traversal. Tests of pairs and of probes are left out. REQUIRES: as what takes a frame in culler.h.
void visit_shadow_tests(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options,
                        const std::function<void(const Occluder& occluder, const Box& box)>& visit);

}  // namespace occlude::culler
