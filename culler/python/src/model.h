// SPDX-License-Identifier: MIT
// Frames of models, and how they are asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "numbers.h"
#include "occlude/culler/culler.h"

namespace occlude::python {

struct RangeRow {
  std::uint32_t first, count;
};

/// What Python keeps of a frame that is held.
struct HeldFrame {
  py::array_t<RangeRow> drawn;
  py::array_t<std::uint32_t> polygons;
  bool is_of_point;
};

/// Appends what a frame draws: ranges, and the polygons in them as they were numbered when given.
void append_drawn(const culler::Culler& culler, const std::vector<culler::PolygonRange>& ranges,
                  std::vector<RangeRow>& drawn, std::vector<std::uint32_t>& polygons);

[[nodiscard]] culler::Method to_method(const std::string& name);
/// How frames are asked for. Throws std::invalid_argument for words and numbers that are not legal.
[[nodiscard]] culler::CullOptions to_cull_options(const std::string& method, std::size_t occluders, std::size_t probes,
                                                  const std::string& near, const std::string& arithmetic,
                                                  const std::string& test, double margin, bool unions,
                                                  const std::pair<int, int>& cover_size, const py::object& cover_work,
                                                  const py::object& cover_ms);

}  // namespace occlude::python
