// SPDX-License-Identifier: MIT
//
// The grid is halved again and again. A half lists what its whole lists and what may look large from somewhere in it, and at
// the end a half is one region. No step takes more than twice the budget, however many occluders look large from everywhere.
#include "region_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <vector>

#include "occlude/culler/parallel.h"

namespace occlude::culler {
namespace {

using Cells = std::array<std::uint32_t, 3>;

/// Regions from `low` to before `high`, and where their list ends; it begins where that of the block before ends.
struct Block {
  Cells low, high;
  std::size_t end;

  [[nodiscard]] bool is_region() const { return size() == Cells{1, 1, 1}; }
  [[nodiscard]] Cells size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
};

/// Blocks that have something to list, and their lists, one after another.
struct Blocks {
  std::vector<Block> blocks;
  std::vector<std::uint32_t> occluders;

  [[nodiscard]] std::size_t first(std::size_t b) const { return b == 0 ? 0 : blocks[b - 1].end; }
  [[nodiscard]] std::span<const std::uint32_t> list(std::size_t b) const {
    return std::span(occluders).subspan(first(b), blocks[b].end - first(b));
  }
  /// Ends the list of a block, of what was appended since the block before.
  void end_block(Block block) {
    block.end = occluders.size();
    if (block.end != first(blocks.size())) blocks.push_back(block);
  }
};

/// As many that all processors have work to the end.
constexpr std::size_t kShares = 64;

/// The place of a block in space.
class Place {
 public:
  Place(const OccluderGrid& grid, const Block& block) {
    const Cells size = block.size();
    const double edge = grid.edge();
    const glm::dvec3 sizes(size[0], size[1], size[2]);
    middle_ = grid.corner(0) + edge * (glm::dvec3(block.low[0], block.low[1], block.low[2]) + sizes / 2.0);
    sizes_ = sizes;
    half_ = edge / 2 * sizes;
    half_edge_ = edge / 2;
    // From the point of the block that is nearest to something to that of any region of it, and across the region.
    across_ = edge * (glm::length(sizes - 1.0) + std::sqrt(3.0));
  }

  /// Whether the area-angle may exceed the threshold from somewhere in the block. That is so of viewpoints within `reach`,
  /// sqrt(a / threshold), of the centre. Within the block |N . V| is at most its value at the middle plus what half the
  /// diagonal adds along N, and |V| at least the distance to the block.
  [[nodiscard]] bool may_see(const PotentialOccluder& occluder, double reach, double threshold) const {
    const glm::dvec3 to_middle = occluder.centre - middle_;
    const double nearest = glm::length(glm::max(glm::abs(to_middle) - half_, 0.0));
    if (nearest > reach) return false;
    const double round = occluder.round_area * (nearest + across_);
    return projected(occluder, to_middle) + round >= threshold * nearest * nearest * nearest;
  }

  /// How large the occluder looks from the block at most, seen from no nearer than the middle is to a corner: a heuristic.
  [[nodiscard]] double looks(const PotentialOccluder& occluder) const {
    const glm::dvec3 to_middle = occluder.centre - middle_;
    const double distance = std::max(glm::length(to_middle), glm::length(half_));
    return (projected(occluder, to_middle) + occluder.round_area * distance) / (distance * distance * distance);
  }

 private:
  [[nodiscard]] double projected(const PotentialOccluder& occluder, const glm::dvec3& to_middle) const {
    const glm::dvec3 n = glm::abs(occluder.area_normal);
    const double slack = (n.x * sizes_.x + n.y * sizes_.y + n.z * sizes_.z) * half_edge_;
    return std::fabs(glm::dot(occluder.area_normal, to_middle)) + slack;
  }

  glm::dvec3 middle_{0, 0, 0}, sizes_{1, 1, 1}, half_{0, 0, 0};
  double half_edge_ = 0, across_ = 0;
};

/// The greatest length to which all lists are cut when they have to fit into the budget together.
std::size_t length_within(std::vector<std::size_t> lengths, std::size_t budget) {
  std::ranges::sort(lengths);
  std::size_t left = budget;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::size_t even = left / (lengths.size() - i);
    if (lengths[i] > even) return even;
    left -= lengths[i];
  }
  return lengths.empty() ? 0 : lengths.back();
}

class Descent {
 public:
  Descent(const OccluderGrid& grid, const PotentialOccluders& occluders, const OccluderGrid::Config& config,
          const Checkpoint& checkpoint)
      : grid_(grid), occluders_(occluders), config_(config), checkpoint_(checkpoint), reach_(occluders.size()) {
    for (std::uint32_t i = 0; i < occluders.size(); ++i) {
      reach_[i] = std::sqrt(occluders[i].area() / config.threshold);
      if (reach_[i] > 0 && std::isfinite(reach_[i])) blocks_.occluders.push_back(i);
    }
    listed_ = blocks_.occluders.size();
    using Config = OccluderGrid::Config;
    entries_ = std::min(config.entries, std::max(Config::kEntriesOfFew, Config::kEntriesOfEach * listed_));
    const auto& [x, y, z] = grid.size();
    blocks_.end_block(
        {{0, 0, 0}, {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)}, 0});
  }

  /// Blocks of one region each.
  const Blocks& regions() {
    bool is_done = false;
    while (!is_done) {
      cut_to_budget();
      is_done = std::ranges::all_of(blocks_.blocks, &Block::is_region);
      if (!is_done) halve();
    }
    return blocks_;
  }

 private:
  /// Puts what work(b, result) appends to `result` for each block in the place of the blocks.
  template <class Work>
  void replace_each(Work&& work) {
    std::vector<Blocks> shares(kShares);
    const std::size_t all = blocks_.occluders.size();
    const auto first_of = [&](std::size_t share) {  // the blocks whose lists begin in that share of all
      return static_cast<std::size_t>(std::ranges::lower_bound(blocks_.blocks, all / kShares * share + 1, {}, &Block::end) -
                                      blocks_.blocks.begin());
    };
    parallel_for(kShares, [&](std::size_t s) {
      const std::size_t end = s + 1 < kShares ? first_of(s + 1) : blocks_.blocks.size();
      for (std::size_t b = first_of(s); b < end; ++b) {
        checkpoint_();
        work(b, shares[s]);
      }
    });
    blocks_ = {};
    std::size_t blocks = 0, occluders = 0;
    for (const Blocks& share : shares) {
      blocks += share.blocks.size();
      occluders += share.occluders.size();
    }
    blocks_.blocks.reserve(blocks);
    blocks_.occluders.reserve(occluders);
    for (Blocks& share : shares) {
      for (Block& block : share.blocks) {
        block.end += blocks_.occluders.size();
        blocks_.blocks.push_back(block);
      }
      blocks_.occluders.insert(blocks_.occluders.end(), share.occluders.begin(), share.occluders.end());
      share = {};
    }
  }

  /// Halves every block along its longest side.
  void halve() {
    replace_each([&](std::size_t b, Blocks& result) {
      const Block& whole = blocks_.blocks[b];
      const Cells size = whole.size();
      const auto axis = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
      Block low = whole, high = whole;
      low.high[axis] = high.low[axis] = whole.low[axis] + size[axis] / 2;
      if (size[axis] > 1) list(low, b, result);
      list(high, b, result);
    });
  }

  /// Lists for a part of block b what may be seen from there.
  void list(const Block& part, std::size_t b, Blocks& result) const {
    const Place place(grid_, part);
    for (const std::uint32_t i : blocks_.list(b)) {
      if (place.may_see(occluders_[i], reach_[i], config_.threshold)) result.occluders.push_back(i);
    }
    result.end_block(part);
  }

  /// Of all lists together at this step. The lists of real models grow by 1.6 to 1.7 with a halving, once each block has
  /// few of their occluders; here the budget grows by the root of 2, and all steps together take 3.4 times as much as the
  /// last. Where more looks large from blocks that large, what is cut is the least of it.
  [[nodiscard]] std::size_t budget() const {
    constexpr double kFew = 4;
    const double share = static_cast<double>(blocks_.blocks.size()) / static_cast<double>(grid_.regions());
    const double budget = kFew * static_cast<double>(listed_) + std::sqrt(share) * static_cast<double>(entries_);
    return std::min(entries_, static_cast<std::size_t>(budget));
  }

  /// Leaves of lists that are too long what looks largest; of equals the first.
  void cut_to_budget() {
    const std::size_t entries = budget();
    if (blocks_.occluders.size() <= entries) return;
    std::vector<std::size_t> lengths;
    for (std::size_t b = 0; b < blocks_.blocks.size(); ++b) lengths.push_back(blocks_.list(b).size());
    const std::size_t most = length_within(std::move(lengths), entries);
    replace_each([&](std::size_t b, Blocks& result) {
      const auto list = blocks_.list(b);
      if (list.size() <= most) {
        result.occluders.insert(result.occluders.end(), list.begin(), list.end());
      } else {
        append_largest(list, Place(grid_, blocks_.blocks[b]), most, result.occluders);
      }
      result.end_block(blocks_.blocks[b]);
    });
  }

  void append_largest(std::span<const std::uint32_t> list, const Place& place, std::size_t count,
                      std::vector<std::uint32_t>& result) const {
    if (count == 0) return;
    std::vector<double> looks;
    looks.reserve(list.size());
    for (const std::uint32_t i : list) looks.push_back(place.looks(occluders_[i]));
    std::vector<double> sorted = looks;
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(count - 1);
    std::ranges::nth_element(sorted, last, std::greater());
    auto equal = static_cast<std::size_t>(std::count(sorted.begin(), last + 1, *last));
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (looks[k] > *last || (looks[k] == *last && equal > 0)) {
        if (looks[k] == *last) --equal;
        result.push_back(list[k]);
      }
    }
  }

  const OccluderGrid& grid_;
  const PotentialOccluders& occluders_;
  const OccluderGrid::Config& config_;
  const Checkpoint& checkpoint_;
  std::vector<double> reach_;  ///< of each occluder, how far from its centre it is listed
  std::size_t listed_ = 0;     ///< occluders that the whole grid lists
  std::size_t entries_ = 0;    ///< of all lists together at most
  Blocks blocks_;
};

}  // namespace

OccluderGrid::Lists list_occluders(const OccluderGrid& grid, const PotentialOccluders& occluders,
                                   const OccluderGrid::Config& config, const Checkpoint& checkpoint) {
  Descent descent(grid, occluders, config, checkpoint);
  const Blocks& regions = descent.regions();
  OccluderGrid::Lists lists;
  lists.first.assign(grid.regions() + 1, 0);
  const auto region_of = [&](const Block& block) {
    return (block.low[2] * grid.size()[1] + block.low[1]) * grid.size()[0] + block.low[0];
  };
  for (std::size_t b = 0; b < regions.blocks.size(); ++b) {
    lists.first[region_of(regions.blocks[b]) + 1] = regions.list(b).size();
  }
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  lists.occluders.resize(regions.occluders.size());
  for (std::size_t b = 0; b < regions.blocks.size(); ++b) {
    const std::size_t first = lists.first[region_of(regions.blocks[b])];
    std::ranges::copy(regions.list(b), lists.occluders.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return lists;
}

}  // namespace occlude::culler
