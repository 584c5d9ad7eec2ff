// SPDX-License-Identifier: MIT
// It culls the frame again and keeps which group closed which pixel.
#include "frame/cover_witness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "cover/cull_by_cover.h"
#include "cover/drawn_groups.h"
#include "frame/begin_frame.h"
#include "frame/culler_access.h"
#include "frame/view_memory.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {
namespace {

/// The vector whose product with `a` is 1, and with the others 0.
glm::dvec3 dual(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 across = glm::cross(b, c);
  return across / glm::dot(a, across);
}

/// Axes that are turned against each other by more than rounding does are those of a skewed picture.
constexpr double kSkew = 0x1p-40;

/// Watches a frame, and names the polygons that hide each cull by cover.
class CoverReplay {
 public:
  CoverReplay(const Hierarchy& hierarchy, CoverMemory& memory, std::size_t most, std::vector<CoverWitness>& witnesses)
      : hierarchy_(hierarchy), memory_(memory), most_(most), witnesses_(witnesses) {}

  void begin() { memory_.buffer.keep_owners(); }

  void joined(const CoverPainter& painter) { drawn_.keep(painter, memory_, 0); }

  void culled(const Culled& culled) {
    if (culled.by != Culled::By::cover) return;
    prove(culled.node, footprint_of(hierarchy_.nodes()[culled.node].box));
  }

  /// REQUIRES: the picture hides the box of the polygon.
  void prove_polygon(std::uint32_t p) {
    const kernel::Aabb box = hierarchy_.soup().box(p);
    witnesses_.push_back(witness_of({p, 1}, box, footprint_of(box)));
  }

 private:
  [[nodiscard]] CoverBuffer::Footprint footprint_of(const kernel::Aabb& box) const {
    return memory_.buffer.is_of_region() ? memory_.buffer.hidden_at(box) : CoverBuffer::Footprint{};
  }

  /// `at` is where the node is hidden from several eyes.
  void prove(std::uint32_t node, const CoverBuffer::Footprint& at) {
    const HierarchyNode& n = hierarchy_.nodes()[node];
    CoverWitness witness = witness_of({n.first, n.count}, n.box, at);
    if (corners_of(witness.polygons) <= most_) {
      witnesses_.push_back(std::move(witness));
    } else if (!n.is_leaf()) {
      for (const std::uint32_t child : {node + 1, n.right}) prove(child, part_of(at, hierarchy_.nodes()[child].box));
    } else {
      for (std::uint32_t p = n.first; p < n.first + n.count; ++p) {
        const kernel::Aabb box = hierarchy_.soup().box(p);
        witnesses_.push_back(witness_of({p, 1}, box, part_of(at, box)));
      }
    }
  }

  [[nodiscard]] CoverBuffer::Footprint part_of(const CoverBuffer::Footprint& at, const kernel::Aabb& box) const {
    return memory_.buffer.is_of_region() ? memory_.buffer.within(at, box) : at;
  }

  [[nodiscard]] CoverWitness witness_of(const PolygonRange& range, const kernel::Aabb& box,
                                        const CoverBuffer::Footprint& at) const {
    CoverWitness witness;
    witness.range = range;
    witness.box = box;
    const auto name = [&](std::uint32_t, std::uint32_t p) { witness.polygons.push_back(p); };
    if (!memory_.buffer.is_of_region()) {
      drawn_.visit_before(memory_.buffer, box, name);
    } else if (is_skewed()) {
      drawn_.visit_windows(memory_.buffer, at, name);
    } else {
      name_windows(at, witness);
      append_polygons(witness, witness.polygons);
    }
    std::ranges::sort(witness.polygons);
    witness.polygons.erase(std::unique(witness.polygons.begin(), witness.polygons.end()), witness.polygons.end());
    return witness;
  }

  /// A point is the sum of these, times its distance along the line of sight and, but for the last, its slopes.
  [[nodiscard]] Camera::Axes axes() const {
    const ConservativeViewport& picture = memory_.buffer.picture();
    return {dual(picture.right(), picture.up(), picture.forward()), dual(picture.up(), picture.forward(), picture.right()),
            dual(picture.forward(), picture.right(), picture.up())};
  }

  /// Of a skewed picture no windows are named, only what hides.
  [[nodiscard]] bool is_skewed() const {
    const auto [right, up, forward] = axes();
    return std::fabs(glm::dot(right, up)) > kSkew * glm::length(right) * glm::length(up);
  }

  /// Names the windows of a footprint.
  void name_windows(const CoverBuffer::Footprint& at, CoverLayer& layer) const {
    const CoverBuffer::Windows found = memory_.buffer.windows(at);
    const ConservativeViewport& picture = memory_.buffer.picture();
    const auto [right, up, forward] = axes();
    const double distance = 1 / found.focus, x = distance * glm::length(right), y = distance * glm::length(up);
    layer.focus = {picture.eye() + distance * forward, glm::normalize(glm::cross(up, right)), glm::normalize(right)};
    for (const CoverBuffer::Window& of : found.windows) {
      CoverWindow& window = layer.windows.emplace_back();
      const PixelPosition low = picture.slope(of.pixels.x0, of.pixels.y0), high = picture.slope(of.pixels.x1, of.pixels.y1);
      window.x0 = x * low.x;
      window.y0 = y * low.y;
      window.x1 = x * high.x;
      window.y1 = y * high.y;
      if (of.is_of_nearer_layer()) {
        name_windows(memory_.buffer.through(at, of), window);
      } else {
        drawn_.name(memory_.buffer, of, window);
      }
    }
  }

  static void append_polygons(const CoverLayer& layer, std::vector<std::uint32_t>& polygons) {
    for (const CoverWindow& window : layer.windows) {
      append_polygons(window, polygons);
      polygons.insert(polygons.end(), window.polygons.begin(), window.polygons.end());
      for (const FanTriangle& triangle : window.triangles) polygons.push_back(triangle.polygon);
    }
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

/// Appends what hides each cull of the frame, and each of the asked polygons.
template <class AnyCamera>
void replay(const Culler& culler, const CullResult& frame, const AnyCamera& camera, const CullOptions& options,
            std::size_t most, std::span<const std::uint32_t> asked, std::vector<CoverWitness>& witnesses) {
  if (frame.method != Method::cover) return;
  require_sound(camera);
  const Hierarchy& hierarchy = culler.hierarchy();
  const CullOptions same = repeated(frame, options);
  View::Memory memory;
  begin_frame(hierarchy, camera, same, memory);
  CoverReplay cover(hierarchy, memory.cover, most, witnesses);
  cull_by_cover(hierarchy, CullerAccess::tree(culler), CullerAccess::triangles(culler), same, memory.frame, memory.cover,
                memory.leaves, memory.idle, cover);
  for (const std::uint32_t p : asked) cover.prove_polygon(p);
}

}  // namespace

void append_covers(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options,
                   std::size_t most, std::span<const std::uint32_t> asked, std::vector<CoverWitness>& witnesses) {
  replay(culler, frame, camera, options, most, asked, witnesses);
}

void Culler::append_covers(const CullResult& frame, const Camera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  replay(*this, frame, camera, options, most, {}, witnesses);
}
void Culler::append_covers(const CullResult& frame, const MatrixCamera& camera, const CullOptions& options, std::size_t most,
                           std::vector<CoverWitness>& witnesses) const {
  replay(*this, frame, camera, options, most, {}, witnesses);
}

}  // namespace occlude::culler
