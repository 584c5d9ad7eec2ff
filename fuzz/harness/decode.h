// SPDX-License-Identifier: MIT
// Bytes turned into geometry, so that what a fuzzer changes in them is a coordinate, a vertex or a kind. Every sequence of
// bytes is some scene; behind its end it goes on as zeros.
//
// Random doubles would never touch one another. So numbers come from small grids, or from numbers already used, and points
// from points already used: on the line through two of them, next to one, in its plane parallel to an axis.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/fuzz/case.h"

namespace occlude::harness {

class Decoder {
 public:
  /// The first byte is the unit of the scene, mostly 1, else a power of two.
  explicit Decoder(std::span<const std::uint8_t> bytes);

  [[nodiscard]] std::uint8_t byte();
  /// In [0, count), for counts up to 256.
  [[nodiscard]] std::size_t below(std::size_t count) { return byte() % count; }
  [[nodiscard]] bool flag() { return (byte() & 1U) != 0; }

  /// One double in some hundred is any at all: not finite, out of range.
  [[nodiscard]] double number();
  [[nodiscard]] kernel::Vec3 point();

  [[nodiscard]] kernel::Viewpoint viewpoint();
  /// Convex in a plane, convex from the viewpoint and folded, or no polygon at all.
  [[nodiscard]] fuzz::Polygon polygon(const kernel::Viewpoint& viewpoint);
  /// A box, prism, pyramid or hull, its faces written in any way, now and then broken; or faces at random.
  [[nodiscard]] kernel::Polytope polytope(const kernel::Viewpoint& viewpoint);
  [[nodiscard]] fuzz::Box box();

  /// A case but for its box.
  [[nodiscard]] fuzz::Case question();

 private:
  [[nodiscard]] double fresh_number();
  [[nodiscard]] double used_number();
  [[nodiscard]] double any_double();
  [[nodiscard]] const kernel::Vec3& used_point();
  [[nodiscard]] kernel::Vec3 step();
  [[nodiscard]] kernel::Vec3 made_point();
  void use(const std::vector<kernel::Vec3>& points);
  [[nodiscard]] fuzz::Polygon plane_polygon();
  [[nodiscard]] fuzz::Polygon free_polygon();
  [[nodiscard]] kernel::Polytope solid(const kernel::Viewpoint& viewpoint);
  [[nodiscard]] kernel::Polytope free_faces();
  void rewrite(fuzz::Polygon& polygon);
  void rewrite(kernel::Polytope& polytope);
  [[nodiscard]] kernel::Aabb aabb();
  [[nodiscard]] kernel::Obb obb();

  std::span<const std::uint8_t> bytes_;
  double unit_ = 1;
  std::vector<double> numbers_;
  std::vector<kernel::Vec3> points_;
};

}  // namespace occlude::harness
