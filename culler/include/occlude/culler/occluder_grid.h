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

class OccluderGrid {
 public:
  struct Config {
    /// An occluder is listed in every region that holds a viewpoint from which its area-angle exceeds this, steradians.
    double threshold = 0.01;
    /// Number of regions aimed at, from 1 to 2^30.
    double regions = 32768;
    /// Most entries of all lists together. Where there would be more, the longest lists are cut to one length and keep what
    /// looks largest from their regions. 2^25 entries take 128 MiB, and no list of the models tried is cut (README.md).
    std::size_t entries = std::size_t{1} << 25U;
    /// They have at most so many for each occluder as well, so that small models cost less, yet always this many in all, so
    /// that a few occluders that look large from everywhere are not cut. The lists of real models have 13 to 116 for each
    /// polygon, those of a city of 20,010 polygons 560.
    static constexpr std::size_t kEntriesOfEach = 1024, kEntriesOfFew = std::size_t{1} << 22U;
  };

  /// The lists of all regions, one after another, ascending within each: what a preprocess stores.
  struct Lists {
    std::vector<std::uint64_t> first = {0};  ///< region r has the entries [first[r], first[r + 1])
    std::vector<std::uint32_t> occluders;
    /// Of each entry, what the occluder hides as seen from the region, polygons; empty where that was not sampled.
    std::vector<float> hidden;
  };

  /// What a region lists.
  struct List {
    std::span<const std::uint32_t> occluders;
    std::span<const float> hidden;  ///< of each, or empty
  };

  /// A grid over `model`, which lists the occluders that have an area. The lists are conservative as far as the budget goes:
  /// the area-angle is bounded from above over each region of the grid. Throws std::invalid_argument for a config out of
  /// range.
  [[nodiscard]] static OccluderGrid build(const PotentialOccluders& occluders, const kernel::Aabb& model,
                                          const Config& config, const Checkpoint& checkpoint = {});

  /// The grid that has these lists. Throws std::invalid_argument when they cannot be lists of these occluders and regions.
  [[nodiscard]] static OccluderGrid restore(const PotentialOccluders& occluders, const kernel::Aabb& model,
                                            const Config& config, Lists lists);

  [[nodiscard]] const Lists& lists() const { return lists_; }
  /// Of the region that holds the point; points outside the model go to the nearest region.
  [[nodiscard]] List list(const glm::dvec3& point) const { return list(region_at(point)); }
  [[nodiscard]] List list(std::size_t region) const;
  /// Entries of the longest list.
  [[nodiscard]] std::size_t longest() const { return longest_; }
  [[nodiscard]] std::size_t region_at(const glm::dvec3& point) const;

  [[nodiscard]] const std::array<std::size_t, 3>& size() const { return size_; }
  [[nodiscard]] std::size_t regions() const { return size_[0] * size_[1] * size_[2]; }
  /// Length of the edges of all regions, which are cubes.
  [[nodiscard]] double edge() const { return edge_; }
  /// The corner of a region at its lowest coordinates.
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
