// SPDX-License-Identifier: MIT
// Which polygons of a model belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace occlude::cli {

struct ObjectList {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_polygon;  ///< the object of each polygon; `count` if it is in none
};

/// Reads {"objects":[[polygon, [first, count], …], …]} for a model of so many polygons. Throws InputError, naming the file
/// and the object.
[[nodiscard]] ObjectList read_objects(const std::string& file, std::size_t polygons);

}  // namespace occlude::cli
