// SPDX-License-Identifier: MIT
// The preprocess of section 4.1: a uniform grid over the model, each cell (the paper's region) with its list of potential
// occluders.
// Reading order: 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/convex_regions.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// What the choice of occluders knows about a convex region.
struct PotentialOccluder {
  glm::dvec3 centre{0, 0, 0};
  glm::dvec3 area_normal{0, 0, 0};  ///< unit normal times area
  kernel::Aabb box;

  /// The area-angle a |N . V| / |V|^2 seen from `eye`, an approximation of the solid angle in steradians (Coorg and Teller
  /// 1996): a the area, N the unit normal, V the unit and |V| the full distance to the centre.
  [[nodiscard]] double area_angle(const glm::dvec3& eye) const;
};

class OccluderGrid {
 public:
  struct Config {
    /// An occluder is listed in every region that holds a viewpoint from which its area-angle exceeds this, steradians.
    double threshold = 0.03;
    /// Number of regions aimed at.
    double regions = 32768;
  };

  /// A grid over `model`, which lists the convex regions of the soup; degenerate ones are left out. The lists are
  /// conservative: the area-angle is bounded from above over each region of the grid.
  [[nodiscard]] static OccluderGrid build(const PolygonSoup& soup, const ConvexRegions& occluders, const kernel::Aabb& model,
                                          const Config& config);

  /// Potential occluders of the region that holds the point; points outside the model go to the nearest region.
  [[nodiscard]] std::span<const std::uint32_t> list(const glm::dvec3& point) const;
  [[nodiscard]] const PotentialOccluder& occluder(std::uint32_t i) const { return occluders_[i]; }

  [[nodiscard]] const std::array<std::size_t, 3>& size() const { return size_; }
  /// Length of all lists together.
  [[nodiscard]] std::size_t entries() const { return lists_.size(); }

 private:
  [[nodiscard]] std::array<std::size_t, 3> region_of(const glm::dvec3& point) const;
  [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * size_[1] + y) * size_[0] + x;
  }
  template <class Visit>
  void for_each_region(const PotentialOccluder& occluder, double threshold, Visit&& visit) const;

  glm::dvec3 origin_{0, 0, 0};
  double edge_ = 1;  ///< of a region, model units
  std::array<std::size_t, 3> size_{1, 1, 1};
  std::vector<std::size_t> first_;  ///< region r lists lists_[first_[r], first_[r + 1])
  std::vector<std::uint32_t> lists_;
  std::vector<PotentialOccluder> occluders_;
};

}  // namespace occlude::culler
