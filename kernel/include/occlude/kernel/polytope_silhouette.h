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

/// The silhouette of one polytope. Exact whatever the viewpoints were before: what was seen last only says where to look.
class PolytopeSilhouette {
 public:
  /// A vertex of the loop and the turned face at the edge from it to the next.
  struct Step {
    std::uint32_t vertex, face;
  };

  /// Moves on to this viewpoint. Asks the faces along the silhouette last seen and those that it moves across; all of them
  /// the first time. REQUIRES: a legal viewpoint, which is not checked, rounding to nearest
  /// (validity.h), and the same polytope at every call since clear().
  void update(const Viewpoint& viewpoint, const ConvexPolytope& polytope);

  /// Forgets what it has seen, so that the next polytope may be another. Keeps its memory.
  void clear();
  /// Makes room for a polytope of so many faces and edges: up to that update() allocates nothing even the first time.
  void reserve(std::size_t faces, std::size_t edges);

  /// In ascending order.
  [[nodiscard]] std::span<const std::uint32_t> turned_faces() const { return turned_faces_; }
  /// Clockwise seen from the viewpoint (right-handed axes); empty when the viewpoint is in the polytope.
  [[nodiscard]] std::span<const Step> loop() const { return loop_; }
  /// How many faces the last update asked for their side.
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
