// SPDX-License-Identifier: MIT
// The mesh of a weld: occluders of a scene that hide as one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/occluder_mesh.h"
#include "occlude/culler/scene.h"

namespace occlude::culler {

/// An occluder of a weld.
struct WeldedPart {
  OccluderId id;
  const OccluderMesh* mesh;
  const Placement* placement;
};

/// The polygons of all parts where they stand. What is there to the bit is the same vertex, so that edges are shared as in
/// any mesh, and all that is known of meshes holds.
class WeldedMesh {
 public:
  /// REQUIRES: the placements were found to be right.
  WeldedMesh(std::span<const WeldedPart> parts, const Executor& executor);

  [[nodiscard]] const OccluderMesh& mesh() const { return mesh_; }
  /// A polygon of a part, by its number in the soup of the part's mesh.
  struct Polygon {
    OccluderId part;
    std::uint32_t number;
    bool is_turned = false;  ///< its corners but the first are in the opposite order
  };
  [[nodiscard]] const Polygon& polygon(std::uint32_t of_mesh) const { return polygons_[of_mesh]; }

 private:
  std::vector<Polygon> polygons_;
  OccluderMesh mesh_;
};

}  // namespace occlude::culler
