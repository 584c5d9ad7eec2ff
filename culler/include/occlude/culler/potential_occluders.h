// SPDX-License-Identifier: MIT
// Everything that may be chosen as an occluder: convex regions, and convex shells. Reading order: 6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/convex_regions.h"
#include "occlude/culler/convex_shells.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

/// What the choice of occluders knows about one of them. A polygon that repeats another and is no part of anything larger,
/// or has so many sides that it hides as pieces, has no area: it is in no list.
struct PotentialOccluder {
  glm::dvec3 centre{0, 0, 0};
  glm::dvec3 area_normal{0, 0, 0};  ///< of a region: unit normal times area
  double round_area = 0;            ///< of a shell: its mean area as projected, a quarter of its surface (Cauchy 1832)
  double radius = 0;                ///< no vertex is farther from the centre, up to rounding

  /// The area-angle a |N . V| / |V|^2 seen from `eye`, an approximation of the solid angle in steradians (Coorg and Teller
  /// 1996): a the area, N the unit normal, V the unit and |V| the full distance to the centre.
  [[nodiscard]] double area_angle(const glm::dvec3& eye) const;
  /// An upper bound of its area as projected in any direction.
  [[nodiscard]] double area() const;
};

using OccluderGeometry = std::variant<std::vector<kernel::Vec3>, kernel::Polytope>;

class PotentialOccluders {
 public:
  struct Config {
    /// Whether to look for convex shells: without them every occluder is flat.
    bool shells = true;
  };

  /// Those that the polygons of the soup are, make up and enclose. REQUIRES: finite coordinates.
  [[nodiscard]] static PotentialOccluders find(std::shared_ptr<const PolygonSoup> soup, const Config& config,
                                               const Checkpoint& checkpoint = {});

  [[nodiscard]] const PolygonSoup& soup() const { return *soup_; }
  /// Occluders 0, ..., size() - 1: first the regions, then the shells.
  [[nodiscard]] std::size_t size() const { return known_.size(); }
  [[nodiscard]] const PotentialOccluder& operator[](std::size_t i) const { return known_[i]; }
  [[nodiscard]] const ConvexRegions& regions() const { return regions_; }
  [[nodiscard]] const ConvexShells& shells() const { return shells_; }

  [[nodiscard]] bool is_shell(std::size_t i) const { return i >= regions_.size(); }
  /// REQUIRES: is_shell(i).
  [[nodiscard]] const kernel::ConvexPolytope& polytope(std::size_t i) const { return shells_.polytope(i - regions_.size()); }
  /// The corners of a region, as vertices of the soup, in order. REQUIRES: !is_shell(i).
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t i) const { return regions_.loop(i); }
  /// The polygons of the soup that it is drawn as, in ascending order.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t i) const {
    return is_shell(i) ? shells_.parts(i - regions_.size()) : regions_.parts(i);
  }
  /// Fills `vertices` with all of its own: of a region its corners in order.
  void vertices(std::size_t i, std::vector<kernel::Vec3>& vertices) const;
  /// What the kernel takes for the occluder: a polygon or a polytope.
  [[nodiscard]] OccluderGeometry geometry(std::size_t i) const;
  /// Its shadow, or why it has none from there.
  [[nodiscard]] kernel::ShadowFrustumResult shadow(std::size_t i, const kernel::Viewpoint& viewpoint,
                                                   kernel::Near near) const;
  /// The next larger occluder that i is a part of, which hides all that i does; i itself if there is none.
  [[nodiscard]] std::uint32_t container(std::uint32_t i) const;

 private:
  std::shared_ptr<const PolygonSoup> soup_;
  ConvexRegions regions_;
  ConvexShells shells_;
  std::vector<PotentialOccluder> known_;
};

}  // namespace occlude::culler
