// SPDX-License-Identifier: MIT
// The file of `occlude bake`: what is seen from each cell (docs/bake.md has its layout).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "occlude/kernel/types.h"
#include "occlude/render/output_file.h"

namespace occlude::cli {

/// A set of numbers as those at which it changes from "not in it" to "in it" and back, ascending. The symmetric difference
/// of two sets is that of their changes.
using Changes = std::vector<std::uint32_t>;

[[nodiscard]] Changes changes_of(const std::vector<bool>& set);
[[nodiscard]] std::size_t size_of(const Changes& set);
/// Which of the numbers below `count` are in it.
[[nodiscard]] std::vector<bool> members_of(const Changes& set, std::size_t count);

struct BakedCell {
  kernel::Aabb box;
  Changes items;  ///< that are seen from it
  Changes cells;  ///< of which something may be seen from it
};

/// The order of cells in the file.
[[nodiscard]] bool is_before(const kernel::Aabb& a, const kernel::Aabb& b);

struct VisibleSets {
  std::uint64_t model = 0;  ///< hash of its file
  std::uint32_t items = 0;
  std::vector<BakedCell> cells;
};

/// Takes from the sets of cells what is not in both: if one cell is hidden from another, so is that from it.
void make_mutual(std::vector<BakedCell>& cells);

/// Returns the number of bytes. The caller commits the file. REQUIRES: the cells are in order; no set has a number that
/// there is not.
std::size_t write_visible_sets(render::OutputFile& file, const VisibleSets& sets);

}  // namespace occlude::cli
