// SPDX-License-Identifier: MIT
// What was drawn into a coarse picture, so that what hides a box can be named.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cover/cover_buffer.h"
#include "cover/cover_painter.h"
#include "occlude/culler/cull_result.h"
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
    const CoverTriangles& triangles = painter.triangles();
    for (const std::uint32_t id : ids) {
      const std::uint32_t polygon = triangles.polygon(id), first = triangles.first(polygon);
      groups_.back().fans.push_back({{polygon, id - first + 1}, triangles.first(polygon + 1) - first});
    }
    for (std::size_t t = 0; t < ids.size(); ++t) {
      const auto places = memory.buffer.piece().places(t);
      if (places) groups_.back().triangles.push_back({painter.triangles().polygon(ids[t]), *places});
    }
  }

  /// Calls visit(source, polygon) for polygons that together hide the box, some of them more than once. REQUIRES: the buffer
  /// hides the box.
  template <class Visit>
  void visit_before(const CoverBuffer& buffer, const kernel::Aabb& box, const Visit& visit) const {
    if (buffer.is_of_region()) return visit_windows(buffer, buffer.hidden_at(box), visit);
    for (const auto& [id, places] : buffer.owners(box)) {
      for (const Triangle& triangle : groups_[id].triangles) {
        if (meet(triangle.places, places)) visit(groups_[id].source, triangle.polygon);
      }
    }
  }

  /// The same for a footprint in which several eyes see nothing but closed pixels.
  template <class Visit>
  void visit_windows(const CoverBuffer& buffer, const CoverBuffer::Footprint& at, const Visit& visit) const {
    for (const CoverBuffer::Window& window : buffer.windows(at).windows) {
      if (window.is_of_nearer_layer()) {
        visit_windows(buffer, buffer.through(at, window), visit);
        continue;
      }
      const std::uint32_t source = groups_[buffer.sheet(window.sheet).id].source;
      CoverWindow named;
      name(buffer, window, named);
      for (const std::uint32_t polygon : named.polygons) visit(source, polygon);
      for (const FanTriangle& triangle : named.triangles) visit(source, triangle.polygon);
    }
  }

  /// Sets the sheet of a window. REQUIRES: it is closed by one.
  void name(const CoverBuffer& buffer, const CoverBuffer::Window& of, CoverWindow& window) const {
    const CoverBuffer::DrawnSheet& sheet = buffer.sheet(of.sheet);
    std::vector<Fan> fans;
    for (const std::uint32_t t : sheet.triangles) fans.push_back(groups_[sheet.id].fans[t]);
    std::ranges::sort(fans, {}, &Fan::triangle);
    for (std::size_t i = 0, end = 0; i < fans.size(); i = end) {
      const std::uint32_t polygon = fans[i].triangle.polygon;
      while (end < fans.size() && fans[end].triangle.polygon == polygon) ++end;
      if (end - i == fans[i].size) {
        window.polygons.push_back(polygon);
      } else {
        for (std::size_t k = i; k < end; ++k) window.triangles.push_back(fans[k].triangle);
      }
    }
  }

 private:
  /// A triangle of a mesh, and how many the fan of its polygon has.
  struct Fan {
    FanTriangle triangle;
    std::uint32_t size;
  };
  struct Triangle {
    std::uint32_t polygon;
    PixelBounds places;
  };
  struct Group {
    std::uint32_t source = 0;
    std::vector<Fan> fans;            ///< of each triangle of the mesh
    std::vector<Triangle> triangles;  ///< those that are in a sheet
  };

  static bool meet(const PixelBounds& a, const PixelBounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }

  std::vector<Group> groups_;
};

}  // namespace occlude::culler
