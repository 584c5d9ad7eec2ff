// SPDX-License-Identifier: MIT
// Proves one witness: everything that culling promises about one culled subtree, in exact arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "camera_picture.h"
#include "model_polygons.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/oracle.h"
#include "occlude/oracle/region.h"

namespace occlude::proof {

/// The outcome for one witness.
struct Proof {
  std::string failure;               ///< empty when the witness is proved, else what is wrong with it
  std::size_t frame = 0;             ///< its number in the path
  std::size_t first = 0, count = 0;  ///< the triangles that it culls; none when the model does not have them
};

/// Hierarchy::leaf_size() of the tree whose triangles the witness on this line counts. A line without "leaf" counts those of
/// a tree for frusta. Throws LineError when the line is not a witness.
[[nodiscard]] std::uint32_t leaf_size_of(std::string_view line);

/// The cameras of a walk.
struct Cameras {
  std::size_t frames = 0;
  std::function<AnyCamera(std::size_t frame)> at;  ///< may be called on several threads at once
};

/// Checks witnesses against the model and the walk that they claim to be from. Several threads may call prove() at once.
class Prover {
 public:
  /// `hierarchy` gives the order in which a witness counts triangles. REQUIRES: `hierarchy` outlives the prover.
  Prover(const culler::Hierarchy& hierarchy, Cameras cameras);

  /// Proves the witness on this line. Throws LineError when the line is not a witness, or says that it counts
  /// triangles of another tree. These things must hold:
  /// - The triangles exist and lie in the box. If a margin is given, the box keeps that distance to the planes that cull it.
  /// - By view: the box is exactly beyond the plane, whose numbers are legal. The renderer draws nothing of the model on the
  ///   plane or beyond it (camera_picture.h).
  /// - By shadow: seen from the frame's viewpoint, the box is exactly in the shadow of the occluder and strictly beyond its
  ///   near planes. With two occluders, each point is in the shadow of one of them and strictly beyond its near planes. An
  ///   occluder is an opaque polygon of the model that is not among the triangles, or the border of several such polygons
  ///   ("parts"), or a polytope whose faces are all such polygons. The renderer clips none of it.
  /// - By cover: each point of the box has an opaque polygon of the list strictly between it and the frame's viewpoint.
  ///   Only the part of a polygon that the renderer certainly draws counts. The polygons may be culled themselves, because
  ///   nothing hides the first polygon that a ray meets.
  /// Of a cull for a region of eyes, to which the frame's eye belongs, all of this must hold for a camera with the frame's
  /// axes at each of these eyes. A shadow is of one occluder. What a cover must show is said in
  /// occlude/oracle/region.h.
  [[nodiscard]] Proof prove(std::string_view line) const;

 private:
  /// The fault of a witness about these triangles, which exist. Empty when the witness is proved.
  [[nodiscard]] std::string fault(const nlohmann::json& witness, const AnyCamera& camera, std::size_t first,
                                  std::size_t count) const;
  /// Why the renderer does not draw the occluder completely by polygons outside of those triangles. Empty when it does.
  [[nodiscard]] std::string fault_of_occluder(const nlohmann::json& described, const AnyCamera& camera, const Eyes& eyes,
                                              std::size_t first, std::size_t count) const;
  /// Why one occluder does not hide the box from all eyes. Empty when it does.
  [[nodiscard]] std::string fault_of_umbra(const oracle::EyeRegion& eyes, const nlohmann::json& object,
                                           const AnyCamera& camera, const Box& box, std::size_t first,
                                           std::size_t count) const;
  /// The range of polygons [.first, .second) to which the triangles belong.
  [[nodiscard]] std::pair<std::size_t, std::size_t> polygons_with(std::size_t first, std::size_t count) const;
  /// Whether the polygons of those triangles lie in the box, exactly.
  [[nodiscard]] bool lie_in(const Box& box, std::size_t first, std::size_t count) const;
  [[nodiscard]] kernel::Aabb box_of_triangles(std::size_t first, std::size_t count) const;
  [[nodiscard]] bool is_model_polygon_outside(const Polygon& loop, std::size_t first, std::size_t count) const;
  /// Whether the loop is the border of the `parts`. Each part is a run of triangles of one polygon, none of them among those
  /// triangles.
  [[nodiscard]] bool is_joined_outside(const Polygon& loop, const nlohmann::json& parts, std::size_t first,
                                       std::size_t count) const;
  /// The border of triangles [first, first + count) of the fan of polygon p.
  [[nodiscard]] Polygon polygon(std::size_t p, std::size_t first, std::size_t count) const;

  const culler::Hierarchy& hierarchy_;
  ModelPolygons polygons_;
  Cameras cameras_;
  oracle::Aabb model_;
  std::vector<std::size_t> first_triangle_;  ///< for each polygon, and the total at the end
  std::vector<std::uint32_t> by_vertices_;   ///< opaque polygons sorted by their vertices, equal ones by index
  /// Boxes of triangle runs are kept, because the same subtrees are culled in many frames.
  mutable std::shared_mutex mutex_;
  mutable std::unordered_map<std::uint64_t, kernel::Aabb> boxes_;
  mutable std::unordered_map<std::uint64_t, kernel::Obb> holding_;  ///< the last oriented box found to contain the run
};

}  // namespace occlude::proof
