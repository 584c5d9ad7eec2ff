// SPDX-License-Identifier: MIT
#include "held_along_path.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "model/append_range.h"
#include "occlude/render/stopwatch.h"

namespace occlude::render {
namespace {

/// A region is so much longer than it reaches to each side of the way, and up and down: for two metres a tenth and a
/// twentieth of a metre, as AheadOptions has them for somebody who walks. A path in another unit has the same regions.
constexpr double kLongerThanAside = 20, kLongerThanUp = 40;
/// By how much a camera may turn while a region holds for it. Tangents are 1.5 times as long then, and a cull takes 1.3
/// to 1.9 times as long.
constexpr double kTurnDegrees = 10;

}  // namespace

culler::CullResult joined(const culler::Hierarchy& hierarchy, const culler::CullResult& own,
                          const culler::CullResult& region) {
  culler::CullResult result;
  result.method = region.method;
  result.view = own.view;
  result.view.insert(result.view.end(), region.view.begin(), region.view.end());
  result.occluders = region.occluders;
  result.pairs = region.pairs;
  for (culler::Occluder& occluder : result.occluders) occluder.hidden = 0;

  const auto node_of = [&](const culler::Culled& culled) -> const culler::HierarchyNode& {
    return hierarchy.nodes()[culled.node];
  };
  std::uint32_t decided = 0;  // all polygons before it are
  const auto draw_to = [&](std::uint32_t first) {
    if (first == decided) return;
    culler::append_range(result.drawn, {decided, first - decided});
    result.stats.drawn_polygons += first - decided;
  };
  const auto cull = [&](const culler::Culled& culled) {
    const culler::HierarchyNode& node = node_of(culled);
    draw_to(node.first);
    decided = node.first + node.count;
    result.culled.push_back(culled);
    if (culled.by == culler::Culled::By::view) {
      result.stats.view_culled_polygons += node.count;
      return;
    }
    result.stats.shadow_culled_polygons += node.count;
    if (culled.by != culler::Culled::By::shadow) return;
    result.occluders[culled.index].hidden += node.count;
    if (culled.second != culler::Culled::kNone) result.occluders[culled.second].hidden += node.count;
  };
  // Two subtrees of a tree are one in the other, or have nothing in common.
  auto a = own.culled.begin(), b = region.culled.begin();
  for (;;) {
    while (a != own.culled.end() && node_of(*a).first < decided) ++a;
    while (b != region.culled.end() && node_of(*b).first < decided) ++b;
    if (a == own.culled.end() && b == region.culled.end()) break;
    const auto is_outer = [&] {
      const culler::HierarchyNode &of_own = node_of(*a), &of_region = node_of(*b);
      return of_own.first != of_region.first ? of_own.first < of_region.first : of_own.count >= of_region.count;
    };
    if (b == region.culled.end() || (a != own.culled.end() && is_outer())) {
      cull(*a);
      continue;
    }
    culler::Culled culled = *b;
    if (culled.by == culler::Culled::By::view) culled.index += static_cast<std::uint32_t>(own.view.size());
    cull(culled);
  }
  draw_to(static_cast<std::uint32_t>(hierarchy.soup().size()));
  return result;
}

HeldAlongPath::HeldAlongPath(const culler::Culler& culler, const CameraPath& path, const WalkOptions& walk)
    : culler_(culler), path_(path), walk_(walk), model_(culler, walk.cull) {}

void HeldAlongPath::cull(std::size_t frame) {
  camera_ = path_.camera(frame, aspect(walk_));
  is_told_ = false;
  is_new_ = !model_.holds(region_, camera_);
  if (is_new_) start_region(frame);
  is_of_point_ = is_new_ && !model_.holds(region_, camera_);
  if (is_of_point_) {
    model_.cull_by_point(camera_);
  } else {
    model_.list(region_, camera_);
  }
}

void HeldAlongPath::start_region(std::size_t frame) {
  const culler::AheadOptions options{
      .aside = walk_.hold / kLongerThanAside, .up = walk_.hold / kLongerThanUp, .turn_degrees = kTurnDegrees};
  const Stopwatch stopwatch;
  try {
    camera_of_region_ = culler::ahead(camera_, way_from(frame), 1, options);
  } catch (const std::invalid_argument&) {
    return;  // the way leads beyond all numbers
  }
  const double factor = culler::stretch(camera_, camera_of_region_);
  model_.cull(region_, std::span(&camera_of_region_, 1), factor);
  options_of_region_ = walk_.cull;
  options_of_region_.margin *= factor;
  regions_.push_back({frame, stopwatch.milliseconds(), camera_of_region_.eye, camera_of_region_.eyes});
}

/// In the direction in which the eye leaves the frame; of the last frame, in which it came.
glm::dvec3 HeldAlongPath::way_from(std::size_t frame) const {
  const std::size_t from = std::min(frame, path_.frames - 2);
  const glm::dvec3 step = path_.camera(from + 1, aspect(walk_)).eye - path_.camera(from, aspect(walk_)).eye;
  const double length = glm::length(step);
  return length > 0 ? walk_.hold / length * step : glm::dvec3(0);
}

const culler::CullResult& HeldAlongPath::result() {
  if (is_of_point_) return model_.frame_by_point();
  if (is_told_) return result_;
  const culler::CullOptions view_only{.method = culler::Method::frusta, .occluders = 0, .arithmetic = walk_.cull.arithmetic};
  const culler::CullResult& region = model_.frame_of_region();
  result_ = joined(culler_.hierarchy(), culler_.cull(camera_, view_only, view_alone_), region);
  if (is_new_) {  // what was done is what the region took
    const culler::CullStats of_polygons = result_.stats;
    result_.stats = region.stats;
    result_.stats.drawn_polygons = of_polygons.drawn_polygons;
    result_.stats.view_culled_polygons = of_polygons.view_culled_polygons;
    result_.stats.shadow_culled_polygons = of_polygons.shadow_culled_polygons;
  }
  is_told_ = true;
  return result_;
}

CulledFor HeldAlongPath::source() const {
  if (is_of_point_) return {camera_, walk_.cull, model_.frame_by_point()};
  return {camera_of_region_, options_of_region_, model_.frame_of_region()};
}

}  // namespace occlude::render
