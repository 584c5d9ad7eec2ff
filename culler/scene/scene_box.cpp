// SPDX-License-Identifier: MIT
#include "scene/scene_box.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "base/outer_box.h"
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

std::optional<Box> legal(const kernel::Aabb& box) {
  if (is_beyond(box.min) || is_beyond(box.max)) return std::nullopt;
  return outer_box(box);
}

std::optional<Box> legal(const kernel::Obb& box) {
  if (is_beyond(box.center) || std::ranges::any_of(box.half_edges, is_beyond)) return std::nullopt;
  const kernel::Aabb outer = outer_box(box);
  if (is_beyond(outer.min) || is_beyond(outer.max)) return std::nullopt;
  if (kernel::check(box) != kernel::Refusal::none) return outer;  // a number too near to zero
  return box;
}

}  // namespace

std::string_view fault(const Box& box) {
  return std::visit([](const auto& b) { return fault_of(b); }, box);
}

std::optional<Box> legal_box(const Box& box) {
  if (const std::string_view reason = fault(box); !reason.empty()) throw std::invalid_argument(std::string(reason));
  return std::visit([](const auto& b) { return legal(b); }, box);
}

}  // namespace occlude::culler
