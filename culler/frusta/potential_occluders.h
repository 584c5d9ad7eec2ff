// SPDX-License-Identifier: MIT
// Everything that may be chosen as an occluder: convex regions, and convex shells. Reading order: 6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <variant>
#include <vector>

#include "frusta/convex_regions.h"
#include "frusta/convex_shells.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

/// What the choice of occluders knows about one of them. Lengths are in model units. Two kinds of polygons have no area
/// here, and so are in no list: one that repeats another and is no part of anything larger, and one with more than
/// ConvexRegions::kMostSides sides, which hides as pieces.
struct PotentialOccluder {
  glm::dvec3 centre{0, 0, 0};
  glm::dvec3 area_normal{0, 0, 0};  ///< of a region: unit normal times area; of a shell: 0
  double round_area = 0;            ///< of a shell: its mean projected area, a quarter of its surface (Cauchy 1832)
  double radius = 0;                ///< no vertex is farther from the centre, up to rounding

  /// The area-angle seen from `eye`, which approximates the solid angle in steradians (Coorg and Teller 1996). Of a region
  /// it is a |N . V| / |V|^2: a is the area, N the unit normal, V the unit vector to the centre, and |V| the distance to the
  /// centre. Of a shell it is round_area / |V|^2. 0 if the eye is at the centre.
  [[nodiscard]] double area_angle(const glm::dvec3& eye) const;
  /// area_angle(eye) is at most area() / |V|^2, up to rounding. Of a region: its area. Of a shell: round_area, which is a
  /// mean; its projection can be up to twice as large.
  [[nodiscard]] double area() const;
};

using OccluderGeometry = std::variant<std::vector<kernel::Vec3>, kernel::Polytope>;

/// Const calls may run on several threads at once. Occluder numbers are not checked.
class PotentialOccluders {
 public:
  /// All potential occluders of the soup: its polygons, the regions that they make up and the shells that they form. Keeps
  /// the soup. What `checkpoint` throws is thrown on. REQUIRES: the soup is well formed and has finite coordinates.
  [[nodiscard]] static PotentialOccluders find(SharedSoup soup, const OccluderConfig& config,
                                               const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The potential occluders with these parts. Throws std::invalid_argument as those of ConvexRegions and ConvexShells, and
  /// if what is known of occluders is not finite. REQUIRES as find().
  [[nodiscard]] static PotentialOccluders from_parts(const PartReader& parts, SharedSoup soup,
                                                     const Checkpoint& checkpoint = {});

  [[nodiscard]] const SoupView& soup() const { return soup_.view; }
  /// Occluders 0, ..., size() - 1: first the regions, then the shells.
  [[nodiscard]] std::size_t size() const { return known_.size(); }
  [[nodiscard]] const PotentialOccluder& operator[](std::size_t i) const { return known_[i]; }
  [[nodiscard]] const ConvexRegions& regions() const { return regions_; }
  [[nodiscard]] const ConvexShells& shells() const { return shells_; }

  [[nodiscard]] bool is_shell(std::size_t i) const { return i >= regions_.size(); }
  /// Whether occluder i hides anything: that of a see-through polygon does not.
  [[nodiscard]] bool hides(std::size_t i) const { return is_shell(i) || !loop(i).empty(); }
  /// REQUIRES: is_shell(i).
  [[nodiscard]] const kernel::ConvexPolytope& polytope(std::size_t i) const { return shells_.polytope(i - regions_.size()); }
  /// The corners of a region in loop order, as indices of soup vertices. REQUIRES: !is_shell(i).
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t i) const { return regions_.loop(i); }
  /// The polygons of the soup that occluder i is drawn as, ascending.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t i) const {
    return is_shell(i) ? shells_.parts(i - regions_.size()) : regions_.parts(i);
  }
  /// Replaces `vertices` with the vertices of occluder i; for a region, its corners in loop order.
  void vertices(std::size_t i, std::vector<kernel::Vec3>& vertices) const;
  /// Occluder i as the kernel takes it: a polygon or a polytope.
  [[nodiscard]] OccluderGeometry geometry(std::size_t i) const;
  /// The shadow of occluder i from the viewpoint, or why it has none from there.
  [[nodiscard]] kernel::ShadowFrustumResult shadow(std::size_t i, const kernel::Viewpoint& viewpoint,
                                                   kernel::Near near) const;
  /// The next larger occluder that i is a part of, which hides everything that i hides; i itself if there is none. From a
  /// polygon to its joined region, if any, and from there to its shell.
  [[nodiscard]] std::uint32_t container(std::uint32_t i) const;

 private:
  SharedSoup soup_;
  ConvexRegions regions_;
  ConvexShells shells_;
  Array<PotentialOccluder> known_;
};

}  // namespace occlude::culler
