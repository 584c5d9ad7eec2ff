// SPDX-License-Identifier: MIT
// What hides a cull by cover, found by culling the frame again and keeping who closed which pixel.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bounds.h"
#include "cover_frame.h"
#include "cull_frame.h"
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

class CoverReplay {
 public:
  CoverReplay(const Hierarchy& hierarchy, const CoverPieces& meshes, CoverBuffer& buffer, std::size_t most,
              std::vector<CoverWitness>& witnesses)
      : hierarchy_(hierarchy), meshes_(meshes), buffer_(buffer), most_(most), witnesses_(witnesses) {}

  /// After its mesh has closed something.
  void keep(const HierarchyNode& leaf) {
    const std::uint32_t mesh = meshes_.mesh_of(leaf.first);
    std::vector<DrawnTriangle>& drawn = drawn_[mesh];
    const CoverMesh triangles = meshes_[mesh];
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
      if (!buffer_.piece().is_taken(t)) continue;
      const auto places = buffer_.piece().places(triangles.triangles[t]);
      if (places) drawn.push_back({meshes_.polygon(mesh, t), *places});
    }
  }

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

 private:
  [[nodiscard]] std::vector<std::uint32_t> polygons_before(const kernel::Aabb& box) const {
    std::vector<std::uint32_t> polygons;
    for (const auto& [mesh, places] : buffer_.owners(box)) {
      for (const DrawnTriangle& triangle : drawn_.at(mesh)) {
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
  const CoverPieces& meshes_;
  CoverBuffer& buffer_;
  std::size_t most_;
  std::vector<CoverWitness>& witnesses_;
  std::unordered_map<std::uint32_t, std::vector<DrawnTriangle>> drawn_;  ///< of the meshes
};

}  // namespace

void Culler::append_covers(const Camera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  const auto nodes = hierarchy_.nodes();
  const auto ask = [&](std::uint32_t node, auto&& question) { return hierarchy_.ask(node, question); };
  View::Memory memory;
  const double reach = begin_frame(nodes, camera, options, memory);
  CoverFrame frame(meshes(), camera, reach, options, memory);
  memory.cover.keep_owners();
  CoverReplay replay(hierarchy_, meshes(), memory.cover, most, witnesses);
  std::vector<std::uint32_t> seen;
  const auto see = [&](std::uint32_t leaf) {
    seen.push_back(leaf);
    if (frame.close(nodes[leaf])) replay.keep(nodes[leaf]);
  };
  const auto cull = [&](const Culled& culled) {
    if (culled.by == Culled::By::cover) replay.prove(culled.node);
  };
  frame.descend(nodes, ask, see, cull);
  for (const std::uint32_t leaf : seen) {
    if (memory.cover.hides(nodes[leaf].box)) replay.prove(leaf);
  }
}

std::shared_ptr<const CoverBuffer> Culler::cover(const Camera& camera, const CullOptions& options) const {
  View view;
  cull(camera, options, view);
  return std::make_shared<const CoverBuffer>(std::move(view.memory().cover));
}

}  // namespace occlude::culler
