// SPDX-License-Identifier: MIT
// Turns bytes into geometry, so that a fuzzer that changes a byte changes a coordinate, a vertex or a kind. Every sequence
// of bytes is a scene. After its end it continues with zeros.
//
// Random doubles would never touch one another. So numbers come from small grids or from numbers used before. Points come
// from points used before, lie on the line through two of them or next to one, or combine their coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/fuzz/case.h"

namespace occlude::harness {

class Decoder {
 public:
  /// The first byte gives the unit of the scene, mostly 1, else a power of two.
  explicit Decoder(std::span<const std::uint8_t> bytes);

  [[nodiscard]] std::uint8_t byte();
  /// An index in [0, count). REQUIRES: count is at most 256.
  [[nodiscard]] std::size_t below(std::size_t count) { return byte() % count; }
  [[nodiscard]] bool flag() { return (byte() & 1U) != 0; }

  /// A number. One in some hundred is any double: not finite, or out of range.
  [[nodiscard]] double number();
  [[nodiscard]] kernel::Vec3 point();

  [[nodiscard]] kernel::Viewpoint viewpoint();
  /// A loop that is convex in a plane, convex from the viewpoint and folded, or no polygon at all.
  [[nodiscard]] fuzz::Polygon polygon(const kernel::Viewpoint& viewpoint);
  /// A box, prism, pyramid or hull with faces written in any way and sometimes broken, or random faces.
  [[nodiscard]] kernel::Polytope polytope(const kernel::Viewpoint& viewpoint);
  [[nodiscard]] fuzz::Box box();

  /// A case without its box.
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
