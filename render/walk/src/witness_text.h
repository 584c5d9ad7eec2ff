// SPDX-License-Identifier: MIT
// Values of witnesses, in JSON.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>

#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/types.h"

namespace occlude::render::text {

// fmt prints the shortest decimal that reads back to the same double.
template <class Vector>
std::string triple(const Vector& v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

/// [a,b,...] of the texts of the items.
template <class Items, class Text>
std::string list(const Items& items, Text&& text) {
  std::string result;
  for (const auto& item : items) result += (result.empty() ? "" : ",") + text(item);
  return "[" + result + "]";
}

[[nodiscard]] std::string box(const kernel::Aabb& box);
[[nodiscard]] std::string box(const kernel::Obb& box);

/// The number of a polygon in the model file, or [number, piece] if it is one of several pieces.
[[nodiscard]] std::string name(const culler::Hierarchy& hierarchy, std::uint32_t p);
[[nodiscard]] std::string names(const culler::Hierarchy& hierarchy, std::span<const std::uint32_t> polygons);
/// Triangles of fans, each by the name of its polygon and the second of its corners.
[[nodiscard]] std::string triangles(const culler::Hierarchy& hierarchy, std::span<const culler::FanTriangle> triangles);

/// The member that says from where it is seen: an eye, eyes or a direction.
[[nodiscard]] std::string sight_member(const kernel::Viewpoint& viewpoint, const culler::EyeRegion& eyes);

/// The members that say what hides a box, without braces: "polygons" of one eye, "focus" and "windows" of several.
[[nodiscard]] std::string cover_members(const culler::Hierarchy& hierarchy, const culler::CoverWitness& cover);

}  // namespace occlude::render::text
