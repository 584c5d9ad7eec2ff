// SPDX-License-Identifier: MIT
// What a reader makes of a store, held against what culling promises.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/fuzz/random.h"

namespace occlude::harness {

struct JudgedStore {
  bool is_refused = false;  ///< by InputError, the only way to refuse a file
  std::string fault;        ///< what is wrong; empty when nothing is
};

/// Reads the store for frames by either method, and culls some. With `believes_oriented_boxes` those need not hold their
/// polygons, the only thing that a reader believes (Culler(const Parts&)).
[[nodiscard]] JudgedStore judged(const std::filesystem::path& store, bool believes_oriented_boxes, fuzz::Random& random);

}  // namespace occlude::harness
