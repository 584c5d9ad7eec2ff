// SPDX-License-Identifier: MIT
//
// All cells are divided again and again. A part lists what its whole lists and what may look large from somewhere in it, and
// at the end each cell is a region. No step takes more than twice the budget, however many occluders look large from
// everywhere.
#include "frusta/region_lists.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// A cell, and where its list ends; it begins where that of the cell before ends.
struct Listed {
  std::uint32_t cell;
  std::size_t end;
};

/// Cells that have something to list, in ascending order, and their lists, one after another.
struct CellLists {
  std::vector<Listed> cells;
  std::vector<std::uint32_t> occluders;

  [[nodiscard]] std::size_t first(std::size_t c) const { return c == 0 ? 0 : cells[c - 1].end; }
  [[nodiscard]] std::span<const std::uint32_t> list(std::size_t c) const {
    return std::span(occluders).subspan(first(c), cells[c].end - first(c));
  }
  /// Ends the list of a cell, of what was appended since the cell before.
  void end_list(std::uint32_t cell) {
    if (occluders.size() != first(cells.size())) cells.push_back({cell, occluders.size()});
  }
};

/// As many that all processors have work to the end.
constexpr std::size_t kShares = 64;

/// A cell as occluders look from there.
class RegionPlace {
 public:
  explicit RegionPlace(const kernel::Aabb& box)
      : middle_((to_glm(box.min) + to_glm(box.max)) / 2.0), half_((to_glm(box.max) - to_glm(box.min)) / 2.0) {}

  /// Whether the area-angle may exceed the threshold from somewhere in the cell. That is so of viewpoints within `reach`,
  /// sqrt(a / threshold), of the centre. Within the cell |N . V| is at most its value at the middle plus what half the
  /// diagonal adds along N, and |V| at least the distance to the cell.
  [[nodiscard]] bool may_see(const PotentialOccluder& occluder, double reach, double threshold) const {
    const glm::dvec3 to_middle = occluder.centre - middle_;
    const double nearest = glm::length(glm::max(glm::abs(to_middle) - half_, 0.0));
    if (nearest > reach) return false;
    if (occluder.round_area > 0) return true;
    return projected(occluder, to_middle) >= threshold * nearest * nearest * nearest;
  }

  /// How large the occluder looks from the cell at most, seen from no nearer than the middle is to a corner: a heuristic.
  [[nodiscard]] double looks(const PotentialOccluder& occluder) const {
    const glm::dvec3 to_middle = occluder.centre - middle_;
    const double distance = std::max(glm::length(to_middle), glm::length(half_));
    return (projected(occluder, to_middle) + occluder.round_area * distance) / (distance * distance * distance);
  }

 private:
  [[nodiscard]] double projected(const PotentialOccluder& occluder, const glm::dvec3& to_middle) const {
    return std::fabs(glm::dot(occluder.area_normal, to_middle)) + glm::dot(glm::abs(occluder.area_normal), half_);
  }

  glm::dvec3 middle_, half_;
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

class RegionDescent {
 public:
  RegionDescent(const Partition& partition, const PotentialOccluders& occluders, const ListConfig& config,
                const Checkpoint& checkpoint)
      : partition_(partition), occluders_(occluders), config_(config), checkpoint_(checkpoint), reach_(occluders.size()) {
    for (std::uint32_t i = 0; i < occluders.size(); ++i) {
      reach_[i] = std::sqrt(occluders[i].area() / config.threshold);
      if (reach_[i] > 0 && std::isfinite(reach_[i])) lists_.occluders.push_back(i);
    }
    listed_ = lists_.occluders.size();
    entries_ = std::min(config.entries, std::max(ListConfig::kEntriesOfFew, ListConfig::kEntriesOfEach * listed_));
    lists_.end_list(0);
  }

  /// The lists of all regions that have one.
  CellLists regions() && {
    bool is_done = false;
    while (!is_done) {
      cut_to_budget();
      is_done = std::ranges::all_of(lists_.cells, [&](const Listed& listed) { return cell(listed).is_region(); });
      if (!is_done) divide();
    }
    return std::move(lists_);
  }

 private:
  [[nodiscard]] const Partition::Cell& cell(const Listed& listed) const { return partition_.cells()[listed.cell]; }
  [[nodiscard]] RegionPlace place(std::uint32_t cell) const { return RegionPlace(partition_.cell_box(cell)); }

  /// Puts what work(c, result) appends to `result` for each list in the place of the lists.
  template <class Work>
  void replace_each(Work&& work) {
    std::vector<CellLists> shares(kShares);
    const std::size_t all = lists_.occluders.size();
    const auto first_of = [&](std::size_t share) {  // the lists that begin in that share of all
      return static_cast<std::size_t>(std::ranges::lower_bound(lists_.cells, all / kShares * share + 1, {}, &Listed::end) -
                                      lists_.cells.begin());
    };
    const auto work_on_share = [&](std::size_t s) {
      const std::size_t end = s + 1 < kShares ? first_of(s + 1) : lists_.cells.size();
      for (std::size_t c = first_of(s); c < end; ++c) {
        checkpoint_();
        work(c, shares[s]);
      }
    };
    parallel_for(kShares, work_on_share, checkpoint_);
    lists_ = {};
    std::size_t cells = 0, occluders = 0;
    for (const CellLists& share : shares) {
      cells += share.cells.size();
      occluders += share.occluders.size();
    }
    lists_.cells.reserve(cells);
    lists_.occluders.reserve(occluders);
    for (CellLists& share : shares) {
      for (Listed& listed : share.cells) {
        listed.end += lists_.occluders.size();
        lists_.cells.push_back(listed);
      }
      lists_.occluders.insert(lists_.occluders.end(), share.occluders.begin(), share.occluders.end());
      share = {};
    }
  }

  /// Divides every cell that is no region.
  void divide() {
    replace_each([&](std::size_t c, CellLists& result) {
      const Listed& whole = lists_.cells[c];
      if (cell(whole).is_region()) {
        keep(c, result);
      } else {
        list(whole.cell + 1, c, result);
        list(cell(whole).upper, c, result);
      }
    });
  }

  void keep(std::size_t c, CellLists& result) const {
    const auto list = lists_.list(c);
    result.occluders.insert(result.occluders.end(), list.begin(), list.end());
    result.end_list(lists_.cells[c].cell);
  }

  /// Lists for a part of cell c what may be seen from there.
  void list(std::uint32_t part, std::size_t c, CellLists& result) const {
    const RegionPlace from = place(part);
    for (const std::uint32_t i : lists_.list(c)) {
      if (from.may_see(occluders_[i], reach_[i], config_.threshold)) result.occluders.push_back(i);
    }
    result.end_list(part);
  }

  /// Of all lists together at this step. The lists of real models grow by 1.6 to 1.7 with a halving, once each cell has few
  /// of their occluders; here the budget grows by the root of 2, and all steps together take 3.4 times as much as the last.
  /// Where more looks large from cells that large, what is cut is the least of it.
  [[nodiscard]] std::size_t budget() const {
    constexpr double kFew = 4;
    const double share = static_cast<double>(lists_.cells.size()) / static_cast<double>(partition_.regions());
    const double budget = kFew * static_cast<double>(listed_) + std::sqrt(share) * static_cast<double>(entries_);
    return std::min(entries_, static_cast<std::size_t>(budget));
  }

  /// Leaves of lists that are too long what looks largest; of equals the first.
  void cut_to_budget() {
    const std::size_t entries = budget();
    if (lists_.occluders.size() <= entries) return;
    std::vector<std::size_t> lengths;
    for (std::size_t c = 0; c < lists_.cells.size(); ++c) lengths.push_back(lists_.list(c).size());
    const std::size_t most = length_within(std::move(lengths), entries);
    replace_each([&](std::size_t c, CellLists& result) {
      if (lists_.list(c).size() <= most) {
        keep(c, result);
      } else {
        append_largest(lists_.list(c), place(lists_.cells[c].cell), most, result.occluders);
        result.end_list(lists_.cells[c].cell);
      }
    });
  }

  void append_largest(std::span<const std::uint32_t> list, const RegionPlace& from, std::size_t count,
                      std::vector<std::uint32_t>& result) const {
    if (count == 0) return;
    std::vector<double> looks;
    looks.reserve(list.size());
    for (const std::uint32_t i : list) looks.push_back(from.looks(occluders_[i]));
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

  const Partition& partition_;
  const PotentialOccluders& occluders_;
  const ListConfig& config_;
  const Checkpoint& checkpoint_;
  std::vector<double> reach_;  ///< of each occluder, how far from its centre it is listed
  std::size_t listed_ = 0;     ///< occluders that are listed at all
  std::size_t entries_ = 0;    ///< of all lists together at most
  CellLists lists_;
};

}  // namespace

OccluderLists::Stored list_occluders(const Partition& partition, const PotentialOccluders& occluders,
                                     const ListConfig& config, const Checkpoint& checkpoint) {
  CellLists regions = RegionDescent(partition, occluders, config, checkpoint).regions();
  OccluderLists::Stored stored;
  std::vector<std::uint64_t> first{0};
  first.reserve(partition.regions() + 1);
  auto next = regions.cells.begin();
  for (std::uint32_t cell = 0; cell < partition.cells().size(); ++cell) {
    if (!partition.cells()[cell].is_region()) continue;
    const bool has_list = next != regions.cells.end() && next->cell == cell;
    first.push_back(has_list ? (next++)->end : first.back());
  }
  stored.first = std::move(first);
  stored.occluders = std::move(regions.occluders);
  return stored;
}

}  // namespace occlude::culler
