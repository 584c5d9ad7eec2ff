// SPDX-License-Identifier: MIT
// Convex polytopes recovered from the soup (section 4): polygons that meet edge to edge and enclose a convex solid. Reading
// order: 5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/convex_polytope.h"

namespace occlude::culler {

struct SidePair;  // src/adjacency.h

/// 1. Every shell is closed and convex exactly: the kernel has checked it.
/// 2. No polygon is in two shells.
/// 3. A shell is a whole set of polygons connected over shared edges, where exactly two sides run along an edge, in opposite
///    directions. A solid with a further polygon attached over such an edge is not found.
/// 4. A shell has 4 to 64 polygons, with at most 768 sides together.
/// Const calls may run on several threads at once. Indices are not checked.
class ConvexShells {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Called by PotentialOccluders::find(). REQUIRES as ConvexRegions::find(). What `checkpoint` throws is thrown on.
  [[nodiscard]] static ConvexShells find(const PolygonSoup& soup, std::span<const SidePair> adjacency,
                                         const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return shells_.size(); }
  /// The most faces, and the most edges, that any shell has; 0 if there is no shell.
  [[nodiscard]] std::size_t most_faces() const { return most_faces_; }
  [[nodiscard]] std::size_t most_edges() const { return most_edges_; }
  [[nodiscard]] const kernel::ConvexPolytope& polytope(std::size_t s) const { return shells_[s].polytope; }
  /// The polygons of the soup that are the faces of shell s, ascending.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t s) const { return shells_[s].parts; }
  /// The shell that the polygon is a face of, or kNone.
  [[nodiscard]] std::uint32_t shell_of(std::uint32_t polygon) const {
    return shell_of_.empty() ? kNone : shell_of_[polygon];
  }

 private:
  struct Shell {
    std::vector<std::uint32_t> parts;
    kernel::ConvexPolytope polytope;
  };
  std::vector<Shell> shells_;
  std::size_t most_faces_ = 0, most_edges_ = 0;
  std::vector<std::uint32_t> shell_of_;  ///< of each polygon; empty where there are no shells
};

/// The solid with these polygons as its faces. Its vertices are numbered in the order in which the loops first name them.
/// Not checked: whether it is closed or convex. Takes time quadratic in the number of corners.
[[nodiscard]] kernel::Polytope polytope_of(const PolygonSoup& soup, std::span<const std::uint32_t> polygons);

}  // namespace occlude::culler
