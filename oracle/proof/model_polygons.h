// SPDX-License-Identifier: MIT
// The polygons of a model, as witnesses name them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cases/json_input.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/oracle.h"
#include "occlude/oracle/visibility.h"

namespace occlude::proof {

using namespace cases;  // witnesses consist of the same values as cases

/// [first, count]. Throws LineError.
[[nodiscard]] std::array<std::size_t, 2> run_of(const nlohmann::json& run, const char* name);

/// Loops that hide together, or why there are none.
struct CoverOrFault {
  std::vector<oracle::Loop> cover;
  std::string fault;
};

class ModelPolygons {
 public:
  /// REQUIRES: `hierarchy` outlives the object.
  explicit ModelPolygons(const culler::Hierarchy& hierarchy);

  /// The polygon of the tree that is named by its number in the model file or, where it has several pieces, by [number,
  /// piece]. None if there is none. Throws LineError if it is neither.
  [[nodiscard]] std::optional<std::uint32_t> named(const nlohmann::json& name) const;
  /// The triangle of a fan, named by its polygon and the second of its corners. `corner` is that. None if there is none.
  [[nodiscard]] std::optional<culler::FanTriangle> named_triangle(const nlohmann::json& name) const;

  /// The polygons of a cover. Their vertices add to `vertices`, of which a line may have a limited number.
  [[nodiscard]] CoverOrFault cover(const nlohmann::json& names, std::size_t& vertices) const;
  /// Adds triangles of fans, or says why there are none. Otherwise as cover().
  [[nodiscard]] std::string append_triangles(const nlohmann::json& names, std::vector<oracle::Loop>& cover,
                                             std::size_t& vertices) const;

  /// The number of polygons in the model file, and the pieces of each, in the tree.
  [[nodiscard]] std::size_t faces() const { return first_piece_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> pieces(std::size_t face) const {
    return std::span(place_).subspan(first_piece_[face], first_piece_[face + 1] - first_piece_[face]);
  }
  [[nodiscard]] oracle::Loop loop(std::uint32_t p) const;
  [[nodiscard]] oracle::Triangle triangle(const culler::FanTriangle& t) const;
  [[nodiscard]] const culler::Hierarchy& hierarchy() const { return hierarchy_; }

 private:
  const culler::Hierarchy& hierarchy_;
  std::vector<std::uint32_t> place_;        ///< for each piece of a polygon of the model file, its index in the tree
  std::vector<std::uint32_t> first_piece_;  ///< for each polygon of the model file, and their number at the end
};

}  // namespace occlude::proof
