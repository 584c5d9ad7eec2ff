// SPDX-License-Identifier: MIT
// Geometry that hides in scenes, prepared once and shared by all occluders that have it. Reading order: 13.
#pragma once

#include <cstddef>
#include <memory>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Polygons, each drawn as the fan of its loop, whatever its shape: add concave faces and openings by
/// PolygonSoup::add_face(). They may overlap and leave gaps: closed solids, single walls, whole drawn meshes. What they hide
/// together is hidden (README.md, Joined shadows). See-through ones (SoupView::see_through) hide nothing.
///
/// Const calls may run on several threads at once. Meshes may be made on any thread, also while scenes are culled.
class OccluderMesh {
 public:
  /// Copies the soup, which may be empty. Throws
  /// 1. std::invalid_argument, with the place and the reason, for a soup that is not well formed (polygon_soup.h) and for a
  ///    vertex that is not legal; coordinates nearer to zero than 2^-100 are taken for 0;
  /// 2. std::runtime_error while the processor does not round to nearest (occlude/kernel/validity.h);
  /// 3. what `checkpoint` throws.
  explicit OccluderMesh(PolygonSoup soup, const Checkpoint& checkpoint = {});
  ~OccluderMesh();
  OccluderMesh(const OccluderMesh&) = delete;
  OccluderMesh& operator=(const OccluderMesh&) = delete;

  /// The number of polygons.
  [[nodiscard]] std::size_t size() const;
  /// Holds all vertices. The origin if there are none.
  [[nodiscard]] kernel::Aabb box() const;

  struct Prepared;  ///< cover/prepared_mesh.h

 private:
  friend const Prepared& prepared_of(const OccluderMesh& mesh);

  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace occlude::culler
