// SPDX-License-Identifier: MIT
// Names what hides each cull by cover. It culls the frame again and keeps which group closed which pixel.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "cull_frame.h"
#include "lazy.h"
#include "occlude/culler/culler.h"
#include "view_memory.h"

namespace occlude::culler {
namespace {

/// A triangle that was drawn into the coarse picture.
struct DrawnTriangle {
  std::uint32_t polygon;
  PlaceRectangle places;
};

bool meet(const PlaceRectangle& a, const PlaceRectangle& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Watches a frame, and names the polygons that hide each cull by cover.
class CoverReplay {
 public:
  CoverReplay(const Hierarchy& hierarchy, View::Memory& memory, std::size_t most, std::vector<CoverWitness>& witnesses)
      : hierarchy_(hierarchy), memory_(memory), most_(most), witnesses_(witnesses) {}

  void begin() { memory_.cover.buffer.keep_owners(); }

  void joined(const CoverPainter& painter) {
    drawn_.resize(painter.groups() + std::size_t{1});
    const auto polygons = memory_.cover.group.polygons();
    for (std::size_t t = 0; t < polygons.size(); ++t) {
      const auto places = memory_.cover.buffer.piece().places(t);
      if (places) drawn_.back().push_back({polygons[t], *places});
    }
  }

  void culled(const Culled& culled) {
    if (culled.by == Culled::By::cover) prove(culled.node);
  }

 private:
  void prove(std::uint32_t node) {
    const HierarchyNode& n = hierarchy_.nodes()[node];
    std::vector<std::uint32_t> polygons = polygons_before(n.box);
    if (corners_of(polygons) <= most_) {
      witnesses_.push_back({{n.first, n.count}, n.box, std::move(polygons)});
    } else if (!n.is_leaf()) {
      prove(node + 1);
      prove(n.right);
    } else {
      for (std::uint32_t p = n.first; p < n.first + n.count; ++p) {
        const kernel::Aabb box = hierarchy_.soup().box(p);
        witnesses_.push_back({{p, 1}, box, polygons_before(box)});
      }
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> polygons_before(const kernel::Aabb& box) const {
    std::vector<std::uint32_t> polygons;
    for (const auto& [group, places] : memory_.cover.buffer.owners(box)) {
      for (const DrawnTriangle& triangle : drawn_[group]) {
        if (meet(triangle.places, places)) polygons.push_back(triangle.polygon);
      }
    }
    std::ranges::sort(polygons);
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    return polygons;
  }

  [[nodiscard]] std::size_t corners_of(const std::vector<std::uint32_t>& polygons) const {
    std::size_t corners = 0;
    for (const std::uint32_t p : polygons) corners += hierarchy_.soup().loop(p).size();
    return corners;
  }

  const Hierarchy& hierarchy_;
  View::Memory& memory_;
  std::size_t most_;
  std::vector<CoverWitness>& witnesses_;
  std::vector<std::vector<DrawnTriangle>> drawn_;  ///< of each group
};

}  // namespace

void Culler::append_covers(const CullResult& frame, const Camera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  require_sound(camera);
  const auto ask = [&](std::uint32_t node, auto&& question) { return hierarchy_.ask(node, question); };
  View::Memory memory;
  const CoverSource source{hierarchy_.nodes(), triangles()};
  cull_by_cover(source, ask, camera, repeated(frame, options), memory, CoverReplay(hierarchy_, memory, most, witnesses));
}

std::shared_ptr<const CoverBuffer> Culler::cover(const Camera& camera, const CullOptions& options) const {
  View view;
  cull(camera, options, view);
  return std::make_shared<const CoverBuffer>(std::move(view.memory().cover.buffer));
}

}  // namespace occlude::culler
