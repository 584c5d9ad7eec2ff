// SPDX-License-Identifier: MIT
// What a viewpoint sees of a convex polytope: the faces turned to it and the loop of edges around them, followed from
// viewpoint to viewpoint (section 5 of the paper).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// The silhouette of one polytope. It is exact and independent of earlier viewpoints; the last silhouette only tells where
/// to start looking. A face is turned to an eye strictly on its outer side, and to a direction of view that points strictly
/// to its inner side; a face seen edge-on is not turned.
class PolytopeSilhouette {
 public:
  /// A vertex of the loop, and the turned face at the edge from it to the next vertex.
  struct Step {
    std::uint32_t vertex, face;  ///< indices in vertices() and faces() of the polytope
  };

  /// Moves the silhouette to this viewpoint. Tests whether faces are turned: those along the last silhouette and those that
  /// it moves across; all faces if there was no silhouette, or if that leads to none.
  /// REQUIRES (not checked): check(viewpoint) == Refusal::none, rounding to nearest (validity.h), and the same polytope at
  /// every call since clear().
  void update(const Viewpoint& viewpoint, const ConvexPolytope& polytope);

  /// Forgets the silhouette, so that the next polytope may be a different one. Keeps the memory.
  void clear();
  /// Reserves memory: update() does not allocate for polytopes of at most so many faces() and edges().
  void reserve(std::size_t faces, std::size_t edges);

  /// The faces turned to the viewpoint, in ascending order; indices in faces() of the polytope.
  [[nodiscard]] std::span<const std::uint32_t> turned_faces() const { return turned_faces_; }
  /// Clockwise seen from the viewpoint (right-handed axes). Empty if the viewpoint is in the polytope or on its surface, and
  /// before the first update().
  [[nodiscard]] std::span<const Step> loop() const { return loop_; }
  /// How many faces the last update() tested.
  [[nodiscard]] std::size_t faces_asked() const { return faces_asked_; }

 private:
  /// An edge of the loop, in its direction.
  struct LoopEdge {
    std::uint32_t from, to, face;
  };

  void ask(const Viewpoint& viewpoint, const ConvexPolytope& polytope, std::uint32_t face);
  void ask_along_border(const Viewpoint& viewpoint, const ConvexPolytope& polytope);
  void link(const ConvexPolytope& polytope);

  std::vector<char> turned_, is_asked_;  ///< of each face
  std::vector<std::uint32_t> turned_faces_;
  std::vector<LoopEdge> edges_;
  std::vector<Step> loop_;
  std::size_t faces_asked_ = 0;
};

}  // namespace occlude::kernel
