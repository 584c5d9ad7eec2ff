// SPDX-License-Identifier: MIT
// Convex polytopes recovered from the soup (section 4): polygons that, edge to edge, enclose a convex solid. Reading
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

struct SidePair;

/// Every shell is closed and convex exactly: the kernel has checked it. No polygon is in two.
class ConvexShells {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// REQUIRES: finite coordinates, and the adjacency of this soup.
  [[nodiscard]] static ConvexShells find(const PolygonSoup& soup, std::span<const SidePair> adjacency,
                                         const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return shells_.size(); }
  /// No shell has more.
  [[nodiscard]] std::size_t most_faces() const { return most_faces_; }
  [[nodiscard]] std::size_t most_edges() const { return most_edges_; }
  [[nodiscard]] const kernel::ConvexPolytope& polytope(std::size_t s) const { return shells_[s].polytope; }
  /// The polygons of the soup that are its faces, in ascending order.
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

/// The solid with these polygons as its faces, vertices in the order in which the loops first name them.
[[nodiscard]] kernel::Polytope polytope_of(const PolygonSoup& soup, std::span<const std::uint32_t> polygons);

}  // namespace occlude::culler
