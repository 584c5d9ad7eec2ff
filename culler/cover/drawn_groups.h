// SPDX-License-Identifier: MIT
// What was drawn into a coarse picture, so that what hides a box can be named.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
    for (const std::uint32_t id : ids) groups_.back().polygons.push_back(painter.triangles().polygon(id));
    for (std::size_t t = 0; t < ids.size(); ++t) {
      const auto places = memory.buffer.piece().places(t);
      if (places) groups_.back().triangles.push_back({painter.triangles().polygon(ids[t]), *places});
    }
  }

  /// Calls visit(source, polygon) for polygons that together hide the box, some of them more than once. REQUIRES: the buffer
  /// hides the box.
  template <class Visit>
  void visit_before(const CoverBuffer& buffer, const kernel::Aabb& box, const Visit& visit) const {
    if (buffer.is_of_region()) {
      for (const CoverBuffer::Window& window : buffer.windows(buffer.hidden_at(box)).windows) {
        const std::uint32_t source = groups_[buffer.sheet(window.sheet).id].source;
        for (const std::uint32_t polygon : polygons(buffer, window)) visit(source, polygon);
      }
      return;
    }
    for (const auto& [id, places] : buffer.owners(box)) {
      for (const Triangle& triangle : groups_[id].triangles) {
        if (meet(triangle.places, places)) visit(groups_[id].source, triangle.polygon);
      }
    }
  }

  /// Those whose triangles the sheet of a window has, ascending.
  [[nodiscard]] std::vector<std::uint32_t> polygons(const CoverBuffer& buffer, const CoverBuffer::Window& window) const {
    const CoverBuffer::DrawnSheet& sheet = buffer.sheet(window.sheet);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : sheet.triangles) found.push_back(groups_[sheet.id].polygons[t]);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  struct Triangle {
    std::uint32_t polygon;
    PixelBounds places;
  };
  struct Group {
    std::uint32_t source = 0;
    std::vector<std::uint32_t> polygons;  ///< of each triangle of the mesh
    std::vector<Triangle> triangles;      ///< those that are in a sheet
  };

  static bool meet(const PixelBounds& a, const PixelBounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }

  std::vector<Group> groups_;
};

}  // namespace occlude::culler
