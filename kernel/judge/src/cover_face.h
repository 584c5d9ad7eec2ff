// SPDX-License-Identifier: MIT
// Whether a cover hides one face of a box. One triangle after another is subtracted from the face in the plane of rays,
// where all pieces are convex.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cover_hidden.h"
#include "cover_parts.h"

namespace occlude::kernel {

/// The corners of a parallelogram that is not seen edge-on, counter-clockwise in the plane of rays.
template <class Number>
using Face = std::array<RayPoint<Number>, 4>;

class CoverFace {
 public:
  /// REQUIRES: `face` is in the units of `parts`. All four arguments outlive this object.
  CoverFace(const CoverParts& parts, ExactCover& cover, const Face<RunningError>& face, const Face<BigInteger>& exact_face);

  /// Whether every point of the face has a point of the cover before it.
  [[nodiscard]] bool is_hidden();

  /// Whether exact numbers were needed.
  [[nodiscard]] bool was_exact() const { return was_exact_; }

 private:
  enum class Kind : std::uint8_t { face_side, side, drawn, nearer };
  struct Line {
    Kind kind;
    std::uint32_t triangle, corner;  ///< the triangle, and the corner where the line starts
    Vector3<RunningError> rounded;
    std::optional<ExactRay> exact;
  };
  /// One side of a line.
  struct Side {
    std::uint32_t line;
    bool is_opposite;
  };
  /// A convex piece that is not empty: the rays that are positive on all its sides. The sides are in order, and corner i is
  /// between sides i and i + 1.
  struct Piece {
    std::vector<Side> sides;
    std::vector<Vector3<RunningError>> corners;
  };
  void add_triangle(std::uint32_t i);
  [[nodiscard]] bool is_apart(const CoverTriangle& triangle) const;
  [[nodiscard]] Vector3<RunningError> rounded(const Side& side) const;
  [[nodiscard]] ExactRay exact(const Side& side);
  [[nodiscard]] ExactRay exact(const Line& line);
  /// The sign of `side` at each corner of the piece.
  [[nodiscard]] std::vector<int> signs(const Piece& piece, const Side& side);
  /// The part of the piece that is on that side. REQUIRES: it is not empty; `signs` are those of the corners of the piece.
  [[nodiscard]] Piece part(const Piece& piece, const Side& side, const std::vector<int>& signs) const;
  /// The rest of the piece after subtracting the triangle, or nothing where the triangle hides nothing of its inside.
  [[nodiscard]] std::optional<std::vector<Piece>> less(const Piece& piece, std::span<const Side> triangle);
  /// Whether all of the rays are certainly on the inner side of these sides of a triangle.
  [[nodiscard]] bool holds(const std::vector<Side>& sides, std::span<const Vector3<RunningError>> rays) const;
  /// The rest of the piece after subtracting one of the triangles, or nothing where no triangle hides any of its inside.
  [[nodiscard]] std::optional<std::vector<Piece>> less_one(const Piece& piece);
  [[nodiscard]] bool is_inside_hidden();
  [[nodiscard]] bool is_border_hidden();
  [[nodiscard]] bool may_touch(std::uint32_t triangle, const Vector3<RunningError>& nearer) const;

  const CoverParts& parts_;
  ExactCover& cover_;
  const Face<RunningError>& face_;
  const Face<BigInteger>& exact_face_;
  PlaneForm<RunningError> plane_;
  std::optional<PlaneForm<BigInteger>> exact_plane_;
  std::vector<Line> lines_;
  std::vector<std::uint32_t> triangles_;        ///< the triangles that may be before the face
  std::vector<std::vector<Side>> of_triangle_;  ///< the sides of each of these; the last one: nearer than the face
  bool was_exact_ = false;
};

}  // namespace occlude::kernel
