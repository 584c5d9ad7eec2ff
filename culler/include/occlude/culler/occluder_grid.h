// SPDX-License-Identifier: MIT
// The preprocess of section 4.1: a uniform grid over the model, each cell (the paper's region) with its list of potential
// occluders.
// Reading order: 7.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/potential_occluders.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Const calls may run on several threads at once. Region numbers are not checked.
class OccluderGrid {
 public:
  struct Config {
    /// An occluder is listed in every region that holds a viewpoint from which its area-angle exceeds this: steradians,
    /// above 0.
    double threshold = 0.01;
    /// About how many regions to make, from 1 to 2^30.
    double regions = 32768;
    /// The most entries of all lists together. If there would be more, the longest lists are cut to a common length; they
    /// keep the occluders that look largest from their regions. 2^25 entries take 128 MiB. No list of the models tried is
    /// cut (README.md).
    std::size_t entries = std::size_t{1} << 25U;
    /// A second limit, so that small models cost less: kEntriesOfEach entries for each occluder, but never less than
    /// kEntriesOfFew in all, so that a few occluders that look large from everywhere are not cut. The lists of real models
    /// have 13 to 116 entries for each polygon, those of a city of 20,010 polygons 560.
    static constexpr std::size_t kEntriesOfEach = 1024, kEntriesOfFew = std::size_t{1} << 22U;
  };

  /// The lists of all regions, one after another, each ascending: what a preprocess stores.
  struct Lists {
    std::vector<std::uint64_t> first = {0};  ///< region r has the entries [first[r], first[r + 1])
    std::vector<std::uint32_t> occluders;
    /// For each entry, the mean number of polygons that the occluder hides as seen from the region. Empty if not sampled.
    std::vector<float> hidden;
  };

  /// The list of one region.
  struct List {
    std::span<const std::uint32_t> occluders;  ///< ascending indices in PotentialOccluders
    std::span<const float> hidden;             ///< for each, as in Lists; or empty
  };

  /// A grid over `model`, and its lists of the occluders that have an area.
  /// 1. Unless lists are cut, they are conservative: over each region the area-angle is bounded from above.
  /// 2. The work is on all processors; the lists do not depend on their number.
  /// Throws std::invalid_argument for a threshold or a number of regions out of range, and what `checkpoint` throws.
  /// REQUIRES: kernel::check(model) == Refusal::none.
  [[nodiscard]] static OccluderGrid build(const PotentialOccluders& occluders, const kernel::Aabb& model,
                                          const Config& config, const Checkpoint& checkpoint = {});

  /// The grid that has these lists. Throws std::invalid_argument for a config out of range, and for lists that cannot be of
  /// these occluders and regions.
  [[nodiscard]] static OccluderGrid restore(const PotentialOccluders& occluders, const kernel::Aabb& model,
                                            const Config& config, Lists lists);

  [[nodiscard]] const Lists& lists() const { return lists_; }
  /// The list of region_at(point).
  [[nodiscard]] List list(const glm::dvec3& point) const { return list(region_at(point)); }
  [[nodiscard]] List list(std::size_t region) const;
  /// Entries of the longest list.
  [[nodiscard]] std::size_t longest() const { return longest_; }
  /// The region that holds the point; for a point outside the grid, the nearest region. REQUIRES: the point is finite.
  [[nodiscard]] std::size_t region_at(const glm::dvec3& point) const;

  /// Number of regions along x, y and z.
  [[nodiscard]] const std::array<std::size_t, 3>& size() const { return size_; }
  [[nodiscard]] std::size_t regions() const { return size_[0] * size_[1] * size_[2]; }
  /// Edge length of a region, in model units. All regions are cubes of one size.
  [[nodiscard]] double edge() const { return edge_; }
  /// The corner of a region with the lowest coordinates.
  [[nodiscard]] glm::dvec3 corner(std::size_t region) const;

 private:
  OccluderGrid(const kernel::Aabb& model, const Config& config);

  void take(Lists lists);
  [[nodiscard]] std::array<std::size_t, 3> cell_of(const glm::dvec3& point) const;
  [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * size_[1] + y) * size_[0] + x;
  }

  glm::dvec3 origin_{0, 0, 0};
  double edge_ = 1;  ///< of a region, model units
  std::array<std::size_t, 3> size_{1, 1, 1};
  Lists lists_;
  std::size_t longest_ = 0;
};

}  // namespace occlude::culler
