// SPDX-License-Identifier: MIT
// What was drawn into a coarse picture, so that what hides a box can be named.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "cover/cover_buffer.h"
#include "cover/cover_painter.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The triangles of each group that a frame drew. REQUIRES: the buffer keeps owners.
class DrawnGroups {
 public:
  /// Keeps what the painter has just drawn. `source` says of which source it is.
  void keep(const CoverPainter& painter, const CoverMemory& memory, std::uint32_t source) {
    groups_.resize(painter.groups() + std::size_t{1});
    groups_.back().source = source;
    const auto ids = memory.group.ids();
    for (std::size_t t = 0; t < ids.size(); ++t) {
      const std::optional<PixelBounds> places =
          memory.buffer.is_of_region() ? PixelBounds{{0, 0}, {kEverywhere, kEverywhere}} : memory.buffer.piece().places(t);
      if (places) groups_.back().triangles.push_back({painter.triangles().polygon(ids[t]), *places});
    }
  }

  /// Calls visit(source, polygon) for polygons that together hide the box, some of them more than once. REQUIRES: the buffer
  /// hides the box.
  template <class Visit>
  void visit_before(const CoverBuffer& buffer, const kernel::Aabb& box, const Visit& visit) const {
    for (const auto& [id, places] : buffer.owners(box)) {
      for (const Triangle& triangle : groups_[id].triangles) {
        if (meet(triangle.places, places)) visit(groups_[id].source, triangle.polygon);
      }
    }
  }

 private:
  struct Triangle {
    std::uint32_t polygon;
    PixelBounds places;
  };
  struct Group {
    std::uint32_t source = 0;
    std::vector<Triangle> triangles;
  };

  /// What the eyes of a region may move anywhere.
  static constexpr double kEverywhere = std::numeric_limits<double>::infinity();

  static bool meet(const PixelBounds& a, const PixelBounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }

  std::vector<Group> groups_;
};

}  // namespace occlude::culler
