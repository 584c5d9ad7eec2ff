// SPDX-License-Identifier: MIT
#include "cover_frame.h"

#include <algorithm>
#include <cstddef>

namespace occlude::culler {
namespace {

/// A side of the coarse picture: whole tiles.
int side(int pixels) {
  constexpr int kTile = CoverPiece::kTile;
  return (std::clamp(pixels, kLeastCoverSide, kMostCoverSide) + kTile - 1) / kTile * kTile;
}

/// A mesh of which a leaf is seen through fewer pixels is not drawn: slits that nothing closes. In cities that is a third of
/// them, and what is culled less for it a thousandth.
constexpr int kWorthClosing = 4;

/// CoverBuffer::work() of a frame, a tenth of a second or so: beyond, what is seen closes no more. The models tried take a
/// tenth of it.
constexpr std::size_t kMostWork = std::size_t{1} << 24U;

}  // namespace

CoverFrame::CoverFrame(const CoverPieces& meshes, const Camera& camera, double reach, const CullOptions& options,
                       View::Memory& memory)
    : meshes_(meshes), camera_(camera), options_(options), memory_(memory) {
  memory.cover.begin(camera, reach, side(options.cover_width), side(options.cover_height), options.margin);
  memory.result.method = Method::cover;  // the picture is this frame's
  memory.seen.clear();
  memory.take_planes();
  if (++memory.frame == 0 || memory.mesh_frames.size() != meshes.size()) {
    memory.mesh_frames.assign(meshes.size(), 0);
    memory.frame = 1;
  }
}

bool CoverFrame::close(const HierarchyNode& leaf) {
  if (memory_.cover.work() > kMostWork) return false;
  const std::uint32_t mesh = meshes_.mesh_of(leaf.first);
  if (memory_.mesh_frames[mesh] == memory_.frame || !memory_.cover.has_open(leaf.box, kWorthClosing)) return false;
  memory_.mesh_frames[mesh] = memory_.frame;
  const CoverMesh triangles = meshes_[mesh];
  ++memory_.result.stats.cover_meshes;
  memory_.result.stats.cover_triangles += triangles.triangles.size();
  return memory_.cover.add(triangles, mesh);
}

void CoverFrame::cull(std::span<const HierarchyNode> nodes, const Culled& culled) {
  CullStats& stats = memory_.result.stats;
  (culled.by == Culled::By::view ? stats.view_culled_polygons : stats.shadow_culled_polygons) += nodes[culled.node].count;
  memory_.result.culled.push_back(culled);
}

void CoverFrame::finish(std::span<const HierarchyNode> nodes) {
  CullResult& result = memory_.result;
  std::ranges::sort(memory_.seen);
  for (const std::uint32_t index : memory_.seen) {
    const HierarchyNode& leaf = nodes[index];
    ++result.stats.cover_tests;
    if (memory_.cover.hides(leaf.box)) {
      cull(nodes, {index, Culled::By::cover});
      continue;
    }
    result.stats.drawn_polygons += leaf.count;
    if (!result.drawn.empty() && result.drawn.back().first + result.drawn.back().count == leaf.first) {
      result.drawn.back().count += leaf.count;
    } else {
      result.drawn.push_back({leaf.first, leaf.count});
    }
  }
  std::ranges::sort(result.culled, {}, &Culled::node);  // depth-first, so in the order of their items
}

}  // namespace occlude::culler
