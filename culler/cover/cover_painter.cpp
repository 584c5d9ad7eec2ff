// SPDX-License-Identifier: MIT
#include "cover/cover_painter.h"

#include <algorithm>
#include <cmath>

#include "cover/worth_drawing.h"

namespace occlude::culler {
namespace {

/// A side of the coarse picture, rounded up to whole tiles.
int side(int pixels) { return (std::clamp(pixels, kLeastCoverSide, kMostCoverSide) + kTile - 1) / kTile * kTile; }

/// By how much the sides of the picture are smaller than asked for, because of the budget.
double scale(const CoverOptions& options) {
  const double asked = static_cast<double>(side(options.width)) * side(options.height);
  return std::sqrt(std::min(1.0, pixels_of_budget(static_cast<double>(triangles_of(options))) / asked));
}

/// Memory is reserved for groups of this many triangles. Nearly all groups of the models tried have fewer; a larger one
/// allocates more.
constexpr std::size_t kRoom = 1024;

/// Of several eyes: once so many triangles are drawn, layers take over what nearer ones have closed, and again whenever the
/// number has doubled. What is behind it is then not drawn. Sponza draws a fifth fewer triangles, and Utrecht, of the eyes
/// of eight metres ahead, half as many. Frames that draw less are faster without it.
constexpr std::size_t kFirstJoin = 1536;

}  // namespace

CoverPainter::CoverPainter(const FrameView& view, const CoverOptions& options, double margin, CoverMemory& memory,
                           CullStats& stats)
    : memory_(memory), stats_(stats), next_join_(kFirstJoin) {
  const CullBudget::Clock::time_point start = CullBudget::Clock::now();
  const double smaller = scale(options);
  const int width = side(static_cast<int>(smaller * side(options.width))),
            height = side(static_cast<int>(smaller * side(options.height)));
  memory.buffer.begin(view, width, height, margin);
  memory.buffer.reserve(kRoom);
  memory.group.reserve(kRoom);
  memory.taken.clear();
  memory.taken.reserve(kRoom);
  if (++memory.stamp == 0) {
    memory.stamps = {};
    memory.stamp = 1;
  }
  budget_ = CullBudget(options, width * height, start);
}

void CoverPainter::use(const CoverSource& source) {
  source_ = &source;
  memory_.stamps.grow(source.first + source.triangles.size());
}

void CoverPainter::enqueue(const ItemRange& leaf, float nearness) {
  memory_.taken.push_back({leaf, nearness});
  source_->triangles.prefetch_first(leaf.first);
}

/// Leaves what is not worth drawing. Returns how many triangles the rest has. Each pass asks memory for what the next one
/// reads.
std::size_t CoverPainter::drop_small() {
  const CoverTriangles& triangles = source_->triangles;
  for (const auto& [leaf, nearness] : memory_.taken) triangles.prefetch_corners(leaf.first, leaf.first + leaf.count);
  for (const auto& [leaf, nearness] : memory_.taken) triangles.prefetch_vertices(leaf.first, leaf.first + leaf.count);
  std::erase_if(memory_.taken, [&](const CoverMemory::Taken& taken) { return !is_worth_drawing(taken.polygons); });
  std::size_t left = 0;
  for (const auto& [leaf, nearness] : memory_.taken)
    left += triangles.first(leaf.first + leaf.count) - triangles.first(leaf.first);
  return left;
}

bool CoverPainter::is_worth_drawing(const ItemRange& leaf) const {
  const ConservativeViewport& picture = memory_.buffer.picture();
  const CoverTriangles& triangles = source_->triangles;
  double area = 0;
  for (std::uint32_t t = triangles.first(leaf.first); t < triangles.first(leaf.first + leaf.count); ++t) {
    const auto [a, b, c] = triangles.corners(t);
    const auto at = [&](std::uint32_t vertex) { return source_->instance.place(triangles.vertex(vertex)); };
    area += picture.area(at(a), at(b), at(c));
    if (area >= kWorthOfPolygons) return true;
  }
  return false;
}

bool CoverPainter::flush_group() {
  if (memory_.taken.empty()) return false;
  const std::size_t own = may_draw() ? drop_small() : 0;
  if (memory_.taken.empty()) return false;
  if (own == 0 || !budget_.spend(CoverOptions::kWorkOfTriangle * own)) {
    ++stats_.cover_groups_left;
    memory_.taken.clear();
    return false;
  }
  CoverGroup& group = memory_.group;
  group.clear();
  // Nearest first, so that a sheet behind another one of the group need not be drawn. Equal ones in the order of the tree.
  std::ranges::sort(memory_.taken, [](const auto& a, const auto& b) {
    return a.nearness != b.nearness ? a.nearness > b.nearness : a.polygons.first < b.polygons.first;
  });
  for (const auto& [leaf, nearness] : memory_.taken) {
    for (std::uint32_t p = leaf.first; p < leaf.first + leaf.count; ++p) group.add(source_->triangles, p, source_->instance);
  }
  memory_.taken.clear();
  group.add_neighbours(source_->triangles, source_->instance, [&](std::uint32_t triangle) { return take_drawn(triangle); });
  for (const std::uint32_t triangle : group.ids()) memory_.stamps[source_->first + triangle] = memory_.stamp;
  ++stats_.cover_groups;
  stats_.cover_triangles += group.ids().size();
  // Triangles without area were counted, and are not in it.
  budget_.add(CoverOptions::kWorkOfTriangle * (std::max(group.ids().size(), own) - own));
  memory_.buffer.add(group.mesh(source_->triangles, source_->instance), ++groups_);
  if (stats_.cover_triangles >= next_join_) {
    memory_.buffer.join_layers();
    next_join_ = 2 * stats_.cover_triangles;
  }
  return true;
}

/// Whether a triangle was drawn. The next call says that it was not, so that it is added only once.
bool CoverPainter::take_drawn(std::uint32_t triangle) {
  if (memory_.stamps.get(source_->first + triangle) != memory_.stamp) return false;
  memory_.stamps[source_->first + triangle] = 0;
  return true;
}

}  // namespace occlude::culler
