// SPDX-License-Identifier: MIT
#include "scene/scene_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "cover/placed.h"
#include "model/outer_box.h"
#include "occlude/culler/box.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

bool has_nan(const kernel::Vec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); }

constexpr std::string_view kNan = "box has a number that is NaN";

std::string_view fault_of(const kernel::Aabb& box) {
  if (has_nan(box.min) || has_nan(box.max)) return kNan;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) return kernel::to_string(kernel::Refusal::min_above_max);
  }
  return "";
}

std::string_view fault_of(const kernel::Obb& box) {
  return has_nan(box.center) || std::ranges::any_of(box.half_edges, has_nan) ? kNan : "";
}

bool is_beyond(const kernel::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(v[axis]) > kernel::kMaxMagnitude) return true;
  }
  return false;
}

SceneBox kept(const kernel::Aabb& box) {
  if (is_beyond(box.min) || is_beyond(box.max)) return {};
  return {outer_box(box), {}};
}

SceneBox kept(const kernel::Obb& box) {
  if (is_beyond(box.center) || std::ranges::any_of(box.half_edges, is_beyond)) return {};
  const kernel::Aabb outer = outer_box(box);
  if (is_beyond(outer.min) || is_beyond(outer.max)) return {};
  return {outer, {box, outer}};
}

double length(const kernel::Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// Whether the map takes each axis to an axis, so that images of boxes are axis-aligned.
bool keeps_axes(const Placement& at) {
  return std::ranges::all_of(std::array{at.x, at.y, at.z},
                             [](const kernel::Vec3& v) { return (v.x != 0) + (v.y != 0) + (v.z != 0) <= 1; });
}

/// The volume between three edges, as a share of that of a box with their lengths.
double squareness(const std::array<kernel::Vec3, 3>& e) {
  return std::fabs(determinant(e[0], e[1], e[2])) / (length(e[0]) * length(e[1]) * length(e[2]));
}

}  // namespace

Box placed_box(const kernel::Aabb& box, const Placement& at) {
  const kernel::Aabb outer = placed(at, box);
  if (keeps_axes(at)) return outer;
  const std::array<kernel::Vec3, 3> columns{at.x, at.y, at.z};
  kernel::Vec3 middle, size;
  std::array<kernel::Vec3, 3> edges;
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const kernel::Vec3& column = columns[static_cast<std::size_t>(k)];
    kernel::Vec3& edge = edges[static_cast<std::size_t>(k)];
    middle[k] = box.min[k] / 2 + box.max[k] / 2;
    const double half = box.max[k] / 2 - box.min[k] / 2;
    for (int axis = 0; axis < 3; ++axis) {
      edge[axis] = half * column[axis];
      size[axis] += std::max(std::fabs(box.min[k]), std::fabs(box.max[k])) * std::fabs(column[axis]);
    }
    shortest = std::min(shortest, length(edge));
  }
  // Placed points have six roundings, the centre has eight and the edges have three together, each of at most 2^-53 of the
  // sum of the magnitudes on its axis. The constant is 64 times 2^-53, more than twice as much.
  constexpr double kRounded = 0x1p-47;
  for (int axis = 0; axis < 3; ++axis) size[axis] = kRounded * (size[axis] + std::fabs(at.origin[axis]));
  // The centre is no nearer to a face than squareness times the shortest edge. Rounding moves squareness by less than 2^-46,
  // which is little beside kLeast.
  constexpr double kLeast = 0x1p-10;
  const double square = squareness(edges), near = square * shortest;
  const double growth = 2 * length(size) / near;
  // A box that grows by more than a thousandth is not tight. Not so if a number is NaN.
  if (!(square > kLeast && growth < kLeast)) return outer;
  for (kernel::Vec3& edge : edges) {
    for (int axis = 0; axis < 3; ++axis) edge[axis] += growth * edge[axis];
  }
  return kernel::Obb{placed(at, middle), edges};
}

std::string_view fault(const Box& box) {
  return std::visit([](const auto& b) { return fault_of(b); }, box);
}

SceneBox SceneBox::of(const Box& box) {
  if (const std::string_view reason = fault(box); !reason.empty()) throw std::invalid_argument(std::string(reason));
  return std::visit([](const auto& b) { return kept(b); }, box);
}

}  // namespace occlude::culler
