// SPDX-License-Identifier: MIT
#include "held/held_region.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <variant>

#include "base/each_bit.h"
#include "camera/extent.h"
#include "camera/holds_for.h"
#include "frame/view_memory.h"
#include "model/append_range.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// More than rounding turns a plane by.
constexpr double kWiderThanSquare = 0.001;

/// The same planes for some boxes of a block: those of `straddled`.
kernel::BoxBytes asked_of(std::uint32_t straddled, std::uint32_t boxes) {
  kernel::BoxBytes asked = 0;
  for_each_bit(straddled, [&](std::uint32_t plane) { asked |= kernel::BoxBytes{boxes} << 8 * plane; });
  return asked;
}

/// The boxes of any of the questions.
std::uint32_t of_any(kernel::BoxBytes bytes) {
  bytes |= bytes >> 32;
  bytes |= bytes >> 16;
  bytes |= bytes >> 8;
  return static_cast<std::uint32_t>(bytes & 0xFF);
}

}  // namespace

void DrawnLeaves::add(const HierarchyNode& leaf) {
  if (blocks_.empty() || blocks_.back().count == kBoxes) {
    if (above_.empty() || above_.back().count == kBoxes) above_.emplace_back();
    blocks_.emplace_back();
    ++above_.back().count;
  }
  Block& block = blocks_.back();
  block.boxes.set(block.count, leaf.box);
  block.ranges[block.count++] = {leaf.first, leaf.count};
  Above& above = above_.back();
  kernel::Aabb all = block.count == 1 ? empty_box() : above.boxes.box(above.count - 1);
  grow(all, leaf.box);
  above.boxes.set(above.count - 1, all);
}

void DrawnLeaves::keep(const Hierarchy& hierarchy, std::span<const std::vector<PolygonRange>> drawn) {
  blocks_.clear();
  above_.clear();
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::size_t> next(drawn.size(), 0);
  std::uint32_t p = 0;  // all leaves before it are decided
  for (;;) {
    std::uint32_t first = kNone;
    for (std::size_t frame = 0; frame < drawn.size(); ++frame) {
      const std::vector<PolygonRange>& ranges = drawn[frame];
      std::size_t& at = next[frame];
      while (at < ranges.size() && ranges[at].first + ranges[at].count <= p) ++at;
      if (at < ranges.size()) first = std::min(first, std::max(p, ranges[at].first));
    }
    if (first == kNone) return;
    const HierarchyNode& leaf = hierarchy.nodes()[hierarchy.leaf_of(first)];
    add(leaf);
    p = leaf.first + leaf.count;
  }
}

void DrawnLeaves::list(std::span<const kernel::HalfSpace> planes, HeldResult& result) const {
  result.drawn.clear();
  result.drawn_polygons = 0;
  const std::uint32_t all = (std::uint32_t{1} << planes.size()) - 1;
  const Block* block = blocks_.data();
  for (const Above& above : above_) {
    const std::uint32_t used = (1U << above.count) - 1;
    const kernel::BlockRelations relations = kernel::relations(planes, above.boxes, asked_of(all, used));
    const std::uint32_t beyond = of_any(relations.outside);
    for (std::uint32_t i = 0; i < above.count; ++i, ++block) {
      if ((beyond >> i & 1U) != 0) continue;
      std::uint32_t straddled = 0;
      for (std::uint32_t plane = 0; plane < planes.size(); ++plane) {
        if ((kernel::boxes_of(relations.inside, plane) >> i & 1U) == 0) straddled |= 1U << plane;
      }
      list(*block, planes, straddled, result);
    }
  }
}

void DrawnLeaves::list(const Block& block, std::span<const kernel::HalfSpace> planes, std::uint32_t straddled,
                       HeldResult& result) const {
  std::uint32_t left = (1U << block.count) - 1;
  if (straddled != 0) left &= ~of_any(kernel::relations(planes, block.boxes, asked_of(straddled, left)).outside);
  for_each_bit(left, [&](std::uint32_t i) {
    append_range(result.drawn, block.ranges[i]);
    result.drawn_polygons += block.ranges[i].count;
  });
}

void HeldRegion::cull(const Culler& culler, std::span<const Camera> cameras, const CullOptions& options, View& view) {
  frames_.clear();
  drawn_.resize(cameras.size());
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    drawn_[i] = culler.cull(cameras[i], options, view).drawn;
    frames_.push_back(memory_of(view).frame.view);
  }
  leaves_.keep(culler.hierarchy(), drawn_);
}

/// What the camera shows in the picture of each of the frames is shown there by a camera with that picture, the same eye and
/// a near plane as far as the camera's reaches in any direction. So nothing of it is culled in that frame, and the camera
/// draws what hides there.
template <class AnyCamera>
bool HeldRegion::holds_around(const AnyCamera& camera) const {
  const auto near = near_around(camera, frames_[0].depth);
  if (!near) return false;
  const FrameView view(camera, 0);
  return std::ranges::all_of(frames_, [&](const FrameView& frame) {
    Camera there = *std::get_if<Camera>(&frame.any_camera);
    const glm::dvec3 sight = there.target - there.eye;
    there.eye = view.eye;
    there.target = view.eye + sight;
    there.near_plane = *near;
    there.eyes = camera.eyes;
    return culler::holds_for(frame, there, view.eye_uncertainty);
  });
}

template <class AnyCamera>
bool HeldRegion::holds_for_any(const AnyCamera& camera) const {
  if (frames_.empty()) return false;
  return frames_.size() == 1 ? culler::holds_for(frames_[0], camera) : holds_around(camera);
}

bool HeldRegion::holds_for(const Camera& camera) const { return holds_for_any(camera); }
bool HeldRegion::holds_for(const MatrixCamera& camera) const { return holds_for_any(camera); }

namespace {

template <class AnyCamera>
std::optional<double> near_around_any(AnyCamera camera, double depth) {
  camera.eyes = {};
  const FrameView view(camera, depth);
  if (!view.is_perspective || view.is_oblique) return std::nullopt;
  const double near = (1 + kProductRounded) * view.near * Extent(camera, view).length;
  return near <= kernel::kMaxMagnitude / 2 ? std::optional(near) : std::nullopt;
}

}  // namespace

std::optional<double> near_around(const Camera& camera, double depth) { return near_around_any(camera, depth); }
std::optional<double> near_around(const MatrixCamera& camera, double depth) { return near_around_any(camera, depth); }

std::array<Camera, 6> all_around(const Camera& camera, double near) {
  std::array<Camera, 6> cameras;
  cameras.fill(camera);
  for (int i = 0; i < 6; ++i) {
    Camera& of = cameras[static_cast<std::size_t>(i)];
    glm::dvec3 sight{0, 0, 0};
    sight[i / 2] = i % 2 == 0 ? 1 : -1;
    // Of eyes far away, no less than the distance of neighbouring numbers.
    of.target = of.eye + std::max(1.0, std::fabs(of.eye[i / 2])) * sight;
    of.up = i / 2 == 2 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    of.projection = Projection::perspective;
    of.fov_y_deg = 90 + kWiderThanSquare;
    of.aspect = 1;
    of.near_plane = near;
    of.far_plane = std::numeric_limits<double>::infinity();
  }
  return cameras;
}

}  // namespace occlude::culler
