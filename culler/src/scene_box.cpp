// SPDX-License-Identifier: MIT
#include "scene_box.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include "occlude/kernel/validity.h"
#include "outer_box.h"

namespace occlude::culler {
namespace {

void require_numbers(const kernel::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isnan(v[axis])) throw std::invalid_argument("box has a number that is NaN");
  }
}

bool is_beyond(const kernel::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(v[axis]) > kernel::kMaxMagnitude) return true;
  }
  return false;
}

std::optional<Box> legal(const kernel::Aabb& box) {
  require_numbers(box.min);
  require_numbers(box.max);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) throw std::invalid_argument("box has min > max");
  }
  if (is_beyond(box.min) || is_beyond(box.max)) return std::nullopt;
  return outer_box(box);
}

std::optional<Box> legal(const kernel::Obb& box) {
  require_numbers(box.center);
  bool has_place = !is_beyond(box.center);
  for (const kernel::Vec3& edge : box.half_edges) {
    require_numbers(edge);
    has_place = has_place && !is_beyond(edge);
  }
  if (!has_place) return std::nullopt;
  const kernel::Aabb outer = outer_box(box);
  if (is_beyond(outer.min) || is_beyond(outer.max)) return std::nullopt;
  if (kernel::check(box) != kernel::Refusal::none) return outer;  // a number too near to zero
  return box;
}

}  // namespace

std::optional<Box> legal_box(const Box& box) {
  return std::visit([](const auto& b) { return legal(b); }, box);
}

}  // namespace occlude::culler
