// SPDX-License-Identifier: MIT
// Names what hides each cull by cover. It culls the frame again and keeps which group closed which pixel.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/lazy.h"
#include "cover/cull_by_cover.h"
#include "cover/drawn_groups.h"
#include "frame/begin_frame.h"
#include "frame/view_memory.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {
namespace {

/// Watches a frame, and names the polygons that hide each cull by cover.
class CoverReplay {
 public:
  CoverReplay(const Hierarchy& hierarchy, CoverMemory& memory, std::size_t most, std::vector<CoverWitness>& witnesses)
      : hierarchy_(hierarchy), memory_(memory), most_(most), witnesses_(witnesses) {}

  void begin() { memory_.buffer.keep_owners(); }

  void joined(const CoverPainter& painter) { drawn_.keep(painter, memory_, 0); }

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
    drawn_.visit_before(memory_.buffer, box, [&](std::uint32_t, std::uint32_t p) { polygons.push_back(p); });
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
  CoverMemory& memory_;
  std::size_t most_;
  std::vector<CoverWitness>& witnesses_;
  DrawnGroups drawn_;
};

}  // namespace

template <class AnyCamera>
void Culler::append_covers_of(const CullResult& frame, const AnyCamera& camera, const CullOptions& options, std::size_t most,
                              std::vector<CoverWitness>& witnesses) const {
  if (frame.method != Method::cover) return;
  require_sound(camera);
  const CullOptions same = repeated(frame, options);
  View::Memory memory;
  begin_frame(hierarchy_, camera, same, memory);
  cull_by_cover(hierarchy_, tree(), triangles(), same, memory.frame, memory.cover, memory.leaves,
                CoverReplay(hierarchy_, memory.cover, most, witnesses));
}

void Culler::append_covers(const CullResult& frame, const Camera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  append_covers_of(frame, camera, options, most, witnesses);
}
void Culler::append_covers(const CullResult& frame, const MatrixCamera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  append_covers_of(frame, camera, options, most, witnesses);
}

}  // namespace occlude::culler
