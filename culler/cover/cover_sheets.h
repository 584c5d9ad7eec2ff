// SPDX-License-Identifier: MIT
// The sheets of a mesh as seen from a viewpoint: triangles that are connected without a fold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"
#include "cover/cover_mesh.h"

namespace occlude::culler {

/// Divides a mesh into sheets. Two triangles that share an edge are connected if, as seen, they are on either side of it. If
/// several are on one side, each is connected with one of the other side. A triangle of sign 0 is in no sheet.
class CoverSheets {
 public:
  /// Reserves memory for this many triangles.
  void reserve(std::size_t triangles);
  void part(const CoverMesh& mesh, std::span<const std::int8_t> signs);

  /// Whether exactly two triangles share the edge of a side, and are connected there: it is no border of their sheet.
  [[nodiscard]] bool is_inner(std::uint32_t side) const { return is_inner_[side] != 0; }
  [[nodiscard]] std::size_t size() const { return begins_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t sheet) const {
    return std::span(triangles_).subspan(begins_[sheet], begins_[sheet + 1] - begins_[sheet]);
  }

 private:
  void join(std::uint32_t triangle, std::uint32_t other);
  void join_ring(const CoverMesh& mesh, std::span<const std::int8_t> signs, std::uint32_t first);

  DisjointSets sets_;
  std::vector<std::uint8_t> is_inner_;   ///< of each side
  std::vector<std::uint32_t> sheet_of_;  ///< for the triangle that stands for its set
  std::vector<std::uint32_t> triangles_, begins_ = {0}, next_;
};

}  // namespace occlude::culler
