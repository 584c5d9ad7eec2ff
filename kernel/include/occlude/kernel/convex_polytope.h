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

/// A checked convex polytope with volume. make() is the only way to get one; a default-constructed or moved-from object is
/// empty, and no frustum or cone is made of it (Refusal::eye_in_polytope).
class ConvexPolytope {
 public:
  /// A face, as three of its vertices that are not collinear, counter-clockwise seen from outside.
  struct Face {
    std::array<std::uint32_t, 3> corners;
  };
  /// An edge between two faces; from -> to runs counter-clockwise around `left`, seen from outside.
  struct Edge {
    std::uint32_t from, to;     ///< indices in vertices()
    std::uint32_t left, right;  ///< indices in faces()
  };

  /// Checks and prepares the polytope. All decisions are exact.
  /// 1. Refuses numbers that are not legal (not_finite, out_of_range) and rounding_mode.
  /// 2. Refuses a face index out of range (bad_face_index), and faces with fewer than three distinct vertices in all
  ///    (too_few_vertices).
  /// 3. Every face is planar and convex, and all vertices, used or not, lie on its inner side, not all of them in its plane;
  ///    else polytope_not_convex.
  /// 4. Every piece of an edge belongs to exactly two faces, and no two faces overlap; else polytope_not_closed, as also if
  ///    no face has area.
  /// 5. Faces may turn either way, be split into coplanar parts, have corners of other faces on their edges, and have
  ///    repeated or collinear vertices. Faces without area are ignored.
  [[nodiscard]] static ConvexPolytopeResult make(const Polytope& polytope);

  /// The vertices as given, all of them. Faces and edges use the first of equal ones.
  [[nodiscard]] std::span<const Vec3> vertices() const { return vertices_; }
  /// One for each plane of the surface: coplanar faces of the input are joined, so the numbering is not that of the input.
  [[nodiscard]] std::span<const Face> faces() const { return faces_; }
  /// The edges between two of these, in pieces where a vertex of another face lies on one.
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
