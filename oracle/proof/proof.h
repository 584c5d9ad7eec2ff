// SPDX-License-Identifier: MIT
// The proof of one witness: everything that culling promises about one culled subtree, in exact arithmetic.
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

#include "cases/json_input.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/oracle.h"

namespace occlude::proof {

using namespace cases;  // witnesses are of what cases are

/// What became of a witness.
struct Proof {
  std::string failure;               ///< empty when it is proved, else what is wrong with it
  std::size_t frame = 0;             ///< of the path
  std::size_t first = 0, count = 0;  ///< the triangles it says are culled; none where the line names none of the model
};

/// Culler::leaf_size of the tree whose triangles the witness on this line counts: "leaf", or what is best for frusta.
/// LineError when it is no witness.
[[nodiscard]] std::uint32_t leaf_size_of(std::string_view line);

/// The cameras of a walk.
struct Cameras {
  std::size_t frames = 0;
  std::function<culler::Camera(std::size_t frame)> at;  ///< may be called on several threads at once
};

/// Checks witnesses against the model and walk they claim to be of. prove() may run on several threads at once.
class Prover {
 public:
  /// `hierarchy` gives the order in which a witness counts triangles. REQUIRES: it outlives the prover.
  Prover(const culler::Hierarchy& hierarchy, Cameras cameras);

  /// Proves the witness on this line (LineError when it is no witness at all, or counts triangles of another tree):
  /// - the triangles named exist and lie in the box named, which keeps the margin named, if any, to the planes that cull it;
  /// - by view: the box is exactly beyond the plane, whose numbers are legal, and of what the renderer may draw of the model
  ///   (camera_picture.h) nothing is on the plane or beyond it;
  /// - by shadow: seen from the frame's eye the box lies exactly in the shadow of the occluder and strictly beyond its near
  ///   planes, or of two occluders together, each point beyond those of one that hides it; an occluder is a polygon of the
  ///   model that is not among the triangles, or the loop about such polygons ("parts"), or a polytope all of whose faces
  ///   are such polygons, and the renderer clips none of it;
  /// - by cover: each point of the box has a polygon of the list strictly between it and the frame's viewpoint, counting
  ///   what the renderer surely draws of them. These may be culled themselves: of all that a ray meets the first is hidden
  ///   by nothing.
  /// None of a frame that is not wanted; one that is not of the path is none.
  [[nodiscard]] std::optional<Proof> prove(
      std::string_view line, const std::function<bool(std::optional<std::size_t> frame)>& is_wanted = {}) const;

 private:
  /// What is wrong with a witness about these triangles, which exist; empty when it is proved.
  [[nodiscard]] std::string fault(const nlohmann::json& witness, const culler::Camera& camera, std::size_t first,
                                  std::size_t count) const;
  /// Why the renderer does not draw the occluder whole outside of those triangles; empty when it does.
  [[nodiscard]] std::string fault_of_occluder(const nlohmann::json& described, const culler::Camera& camera,
                                              std::size_t first, std::size_t count) const;
  /// The polygons, from .first to before .second, that any of the triangles belong to.
  [[nodiscard]] std::pair<std::size_t, std::size_t> polygons_with(std::size_t first, std::size_t count) const;
  /// Whether those polygons lie in the box, exactly.
  [[nodiscard]] bool lie_in(const Box& box, std::size_t first, std::size_t count) const;
  [[nodiscard]] kernel::Aabb box_of_triangles(std::size_t first, std::size_t count) const;
  [[nodiscard]] bool is_model_polygon_outside(const Polygon& loop, std::size_t first, std::size_t count) const;
  /// Why the polygons do not hide the box together; empty when they do.
  [[nodiscard]] std::string fault_of_cover(const nlohmann::json& polygons, const kernel::Viewpoint& view,
                                           const culler::Camera& camera, const Box& box) const;
  /// Whether the loop is the border of what `parts` lists, runs of triangles each of one polygon, none of them among those
  /// triangles.
  [[nodiscard]] bool is_joined_outside(const Polygon& loop, const nlohmann::json& parts, std::size_t first,
                                       std::size_t count) const;
  /// The loop about triangles [first, first + count) of the fan of polygon p.
  [[nodiscard]] Polygon polygon(std::size_t p, std::size_t first, std::size_t count) const;

  const culler::Hierarchy& hierarchy_;
  Cameras cameras_;
  oracle::Aabb model_;
  std::vector<std::size_t> first_triangle_;  ///< of each polygon, and the total
  std::vector<std::uint32_t> by_vertices_;   ///< polygons, sorted by their vertices, equal ones by their place
  std::vector<std::uint32_t> place_;         ///< of each polygon of the model file
  /// Boxes of triangle runs: the subtrees of one hierarchy recur from frame to frame.
  mutable std::shared_mutex mutex_;
  mutable std::unordered_map<std::uint64_t, kernel::Aabb> boxes_;
  mutable std::unordered_map<std::uint64_t, kernel::Obb> holding_;  ///< the last oriented box found to hold the run
};

}  // namespace occlude::proof
