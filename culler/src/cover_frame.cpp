// SPDX-License-Identifier: MIT
#include "cover_frame.h"

#include "occlude/culler/append_range.h"

namespace occlude::culler {
namespace {

/// A side of the coarse picture, rounded up to whole tiles.
int side(int pixels) { return (std::clamp(pixels, kLeastCoverSide, kMostCoverSide) + kTile - 1) / kTile * kTile; }

/// Memory is reserved for groups of this many triangles. Nearly all groups of the models tried have fewer; a larger one
/// allocates more.
constexpr std::size_t kRoom = 1024;

}  // namespace

CoverFrame::CoverFrame(const CoverSource& source, const FrameView& view, const CullOptions& options, View::Memory& memory)
    : source_(source), options_(options), memory_(memory) {
  memory.cover.begin(view, side(options.cover_width), side(options.cover_height), options.margin);
  memory.result.method = Method::cover;  // the picture is this frame's from here on
  memory.cover.reserve(kRoom);
  memory.group.reserve(kRoom);
  memory.seen.clear();
  memory.seen.reserve(memory.result.culled.capacity());  // one for each leaf at most, as `culled`
  memory.taken.clear();
  memory.taken.reserve(kRoom);
  memory.take_planes();
  if (++memory.frame == 0 || memory.polygon_frames.size() != source.triangles.size()) {
    memory.polygon_frames.assign(source.triangles.size(), 0);
    memory.frame = 1;
  }
}

bool CoverFrame::may_draw_more() const {
  if (memory_.cover.is_spent() || memory_.result.stats.cover_triangles >= options_.cover_triangles) return false;
  if (options_.cover_ms == std::numeric_limits<double>::infinity()) return true;
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start_;
  return taken.count() < options_.cover_ms;
}

bool CoverFrame::join() {
  if (memory_.taken.empty()) return false;
  if (!may_draw_more()) {
    ++memory_.result.stats.cover_groups_left;
    memory_.taken.clear();
    return false;
  }
  CoverGroup& group = memory_.group;
  group.clear();
  for (const std::uint32_t leaf : memory_.taken) {
    const HierarchyNode& node = source_.nodes[leaf];
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) group.add(source_.triangles, p);
  }
  for (const std::uint32_t leaf : memory_.taken) add_around(leaf);
  memory_.taken.clear();
  for (const std::uint32_t p : group.polygons()) memory_.polygon_frames[p] = memory_.frame;
  CullStats& stats = memory_.result.stats;
  ++stats.cover_groups;
  stats.cover_triangles += group.polygons().size();
  memory_.cover.add(group.mesh(source_.triangles), ++groups_);
  return true;
}

/// Adds the polygons around a leaf that this frame has drawn before.
void CoverFrame::add_around(std::uint32_t leaf) {
  for (const std::uint32_t p : source_.triangles.around(leaf)) {
    if (memory_.polygon_frames[p] != memory_.frame) continue;
    memory_.group.add(source_.triangles, p);
    memory_.polygon_frames[p] = 0;  // so that it is added only once
  }
}

void CoverFrame::cull(std::span<const HierarchyNode> nodes, const Culled& culled) {
  CullStats& stats = memory_.result.stats;
  (culled.by == Culled::By::view ? stats.view_culled_polygons : stats.shadow_culled_polygons) += nodes[culled.node].count;
  memory_.result.culled.push_back(culled);
}

void CoverFrame::draw(const HierarchyNode& leaf) {
  memory_.result.stats.drawn_polygons += leaf.count;
  append_range(memory_.result.drawn, {leaf.first, leaf.count});
}

}  // namespace occlude::culler
