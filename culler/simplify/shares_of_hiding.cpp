// SPDX-License-Identifier: MIT
#include "simplify/shares_of_hiding.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "cover/cover_triangles.h"
#include "cover/cull_by_cover.h"
#include "cover/drawn_groups.h"
#include "frame/begin_frame.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {
namespace {

/// What stands together is drawn together, and is best chosen together. With leaves of 4, as frames have, the same number
/// hides a few tenths of a percent more, and frames draw a seventh more of it: 30,000 triangles of the castle take 0.47 of
/// the time of what is drawn, not 0.39, and those of Sponza 0.56, not 0.49.
constexpr std::uint32_t kLeafSize = 16;

/// Watches a frame by cover, and shares out what it hides.
class SharesOfFrame {
 public:
  SharesOfFrame(const Hierarchy& hierarchy, CoverMemory& memory, std::vector<double>& shares)
      : hierarchy_(hierarchy), memory_(memory), shares_(shares) {}

  void begin() { memory_.buffer.keep_owners(); }
  void joined(const CoverPainter& painter) { drawn_.keep(painter, memory_, 0); }
  void culled(const Culled& culled) {
    if (culled.by != Culled::By::cover) return;
    const HierarchyNode& node = hierarchy_.nodes()[culled.node];
    hiding_.clear();
    drawn_.visit_before(memory_.buffer, node.box, [&](std::uint32_t, std::uint32_t p) { hiding_.push_back(p); });
    std::ranges::sort(hiding_);
    const auto end = std::unique(hiding_.begin(), hiding_.end());
    const double share = static_cast<double>(node.count) / static_cast<double>(end - hiding_.begin());
    for (auto p = hiding_.begin(); p != end; ++p) shares_[hierarchy_.original(*p)] += share;
  }

 private:
  const Hierarchy& hierarchy_;
  CoverMemory& memory_;
  std::vector<double>& shares_;
  DrawnGroups drawn_;
  std::vector<std::uint32_t> hiding_;
};

}  // namespace

std::vector<double> shares_of_hiding(PolygonSoup soup, std::span<const Camera> views, const Checkpoint& checkpoint) {
  std::vector<double> shares(soup.size());
  if (soup.empty() || views.empty()) return shares;
  const Hierarchy tree = Hierarchy::build(std::move(soup), {.leaf_size = kLeafSize}, checkpoint);
  const HierarchyBlocks blocks(tree, checkpoint);
  const CoverTriangles triangles = CoverTriangles::find(tree.soup(), checkpoint);
  const CullOptions options{.method = Method::cover};
  View::Memory memory;
  for (const Camera& camera : views) {
    checkpoint();
    begin_frame(tree, camera, options, memory);
    cull_by_cover(tree, blocks.tree(), triangles, options, memory.frame, memory.cover, memory.leaves, memory.idle,
                  SharesOfFrame(tree, memory.cover, shares));
  }
  return shares;
}

}  // namespace occlude::culler
