// SPDX-License-Identifier: MIT
// Convex polytopes recovered from the soup (section 4): polygons that meet edge to edge and enclose a convex solid. Reading
// order: 5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/convex_polytope.h"

namespace occlude::culler {

struct SidePair;   // model/adjacency.h
class PartReader;  // model/part_list.h
class PartWriter;
class ShellPolytopes;  // frusta/shell_polytopes.h

/// 1. Every shell is closed and convex exactly: the kernel has checked it.
/// 2. No polygon is in two shells.
/// 3. A shell is a whole set of polygons connected over shared edges, where exactly two sides run along an edge, in opposite
///    directions. A solid with a further polygon attached over such an edge is not found.
/// 4. A shell has 4 to 64 polygons, with at most 768 sides together.
/// Const calls may run on several threads at once. Indices are not checked.
class ConvexShells {
 public:
  static constexpr std::uint32_t kNone = (std::numeric_limits<std::uint32_t>::max)();

  /// Called by PotentialOccluders::find(). REQUIRES as ConvexRegions::find(). What `checkpoint` throws is thrown on.
  [[nodiscard]] static ConvexShells find(SoupView soup, std::span<const SidePair> adjacency,
                                         const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The shells with these parts. Throws std::invalid_argument where (2) or (4) does not hold. Each is checked and made into
  /// a polytope when it is first asked for; if it is not closed and convex, that is an empty polytope, which hides nothing.
  /// REQUIRES: the soup is well formed, and its coordinates are legal.
  [[nodiscard]] static ConvexShells from_parts(const PartReader& parts, SharedSoup soup, const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return first_part_.empty() ? 0 : first_part_.size() - 1; }
  /// The most faces, and the most edges, that any shell has; 0 if there is no shell.
  [[nodiscard]] std::size_t most_faces() const { return most_.faces; }
  [[nodiscard]] std::size_t most_edges() const { return most_.edges; }
  [[nodiscard]] const kernel::ConvexPolytope& polytope(std::size_t s) const;
  /// The polygons of the soup that are the faces of shell s, ascending.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t s) const {
    return {parts_.data() + first_part_[s], parts_.data() + first_part_[s + 1]};
  }
  /// The shell that the polygon is a face of, or kNone.
  [[nodiscard]] std::uint32_t shell_of(std::uint32_t polygon) const {
    return shell_of_.empty() ? kNone : shell_of_[polygon];
  }

 private:
  struct Most {
    std::uint32_t faces = 0, edges = 0;
  };
  /// Whether shell s, with its parts in their array, has the properties (2) and (4).
  [[nodiscard]] bool is_sound(std::uint32_t s, SoupView soup) const;

  Array<std::uint32_t> parts_, first_part_;  ///< shell s has the parts [first_part_[s], first_part_[s + 1])
  Array<std::uint32_t> shell_of_;            ///< of each polygon; empty where there are no shells
  Most most_;
  SharedSoup soup_;  ///< of which polytopes are made; empty where all are
  std::shared_ptr<ShellPolytopes> polytopes_;
};

/// The solid with these polygons as its faces. Its vertices are numbered in the order in which the loops first name them.
/// Not checked: whether it is closed or convex. Takes time quadratic in the number of corners.
[[nodiscard]] kernel::Polytope polytope_of(SoupView soup, std::span<const std::uint32_t> polygons);

}  // namespace occlude::culler
