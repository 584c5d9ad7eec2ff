// SPDX-License-Identifier: MIT
// A convex polytope as an occluder: checked once, seen from many viewpoints.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

struct ConvexPolytopeResult;

class ConvexPolytope {
 public:
  /// A face, by three of its vertices not in line, turning counter-clockwise seen from outside.
  struct Face {
    std::array<std::uint32_t, 3> corners;
  };
  /// An edge between two faces that are not coplanar, from -> to counter-clockwise round `left` seen from outside.
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t left, right;  ///< faces
  };

  /// Checks and prepares the polytope. Everything is decided exactly: faces are plane and convex, all vertices lie on the
  /// inner side of every face, every piece of an edge belongs to two faces, and no two faces overlap. Faces may be split
  /// into coplanar parts, turn either way round, meet other faces' corners along their edges, and carry repeated or
  /// collinear vertices. Refuses with not_finite, out_of_range, bad_face_index, too_few_vertices, polytope_not_convex,
  /// polytope_not_closed, rounding_mode.
  [[nodiscard]] static ConvexPolytopeResult make(const Polytope& polytope);

  [[nodiscard]] std::span<const Vec3> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const Face> faces() const { return faces_; }
  [[nodiscard]] std::span<const Edge> edges() const { return edges_; }

 private:
  std::vector<Vec3> vertices_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
};

/// A polytope, or why there is none.
struct ConvexPolytopeResult {
  std::optional<ConvexPolytope> polytope;
  Refusal refusal = Refusal::none;
};

}  // namespace occlude::kernel
