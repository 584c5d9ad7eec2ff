// SPDX-License-Identifier: MIT
// A hash of cases over the bits of their numbers: FNV-1a over 64-bit words.
#pragma once

#include <bit>
#include <cstdint>
#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"

namespace occlude::fuzz {

class CaseHash {
 public:
  void add(const Case& made) {
    add(static_cast<std::uint64_t>(made.viewpoint.kind));
    add(made.viewpoint.value);
    add(static_cast<std::uint64_t>(made.near));
    std::visit([&](const auto& occluder) { add(occluder); }, made.occluder);
    std::visit([&](const auto& box) { add(box); }, made.box);
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3U; }
  void add(const kernel::Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<std::uint64_t>(v[axis]));
  }
  void add(const std::vector<kernel::Vec3>& points) {
    add(points.size());
    for (const kernel::Vec3& point : points) add(point);
  }
  void add(const kernel::Polytope& polytope) {
    add(polytope.vertices);
    add(polytope.faces.size());
    for (const auto& face : polytope.faces) {
      add(face.size());
      for (const std::uint32_t i : face) add(std::uint64_t{i});
    }
  }
  void add(const kernel::Aabb& box) {
    add(box.min);
    add(box.max);
  }
  void add(const kernel::Obb& box) {
    add(box.center);
    for (const kernel::Vec3& half_edge : box.half_edges) add(half_edge);
  }

  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace occlude::fuzz
