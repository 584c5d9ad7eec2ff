// SPDX-License-Identifier: MIT
// Joined shadows in a coarse picture: of each pixel, how near something is that all its rays meet.
//
// A pixel is a convex cone of rays. Where all of them meet a piece, all that is farther than the piece is there is hidden. A
// box is hidden when that is so in every pixel that it touches. What is found is never wrong: numbers are rounded in
// doubles, and by how much is accounted for (beam_picture.h, cover_piece.h).
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "beam_picture.h"
#include "cover_piece.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

class CoverBuffer {
 public:
  using Triangle = CoverPiece::Triangle;

  /// REQUIRES: a multiple of 64 pixels, and of CoverPiece::kTile.
  CoverBuffer(int width, int height);

  /// Opens all pixels. `depth` as append_view_frustum() takes it. The picture is the camera's, and half a tile more on each
  /// side. REQUIRES: the camera has no fault().
  void begin(const Camera& camera, double depth);

  /// Closes what these triangles close together, as far as they are beyond the near plane.
  void add(std::span<const glm::dvec3> vertices, std::span<const Triangle> piece);

  /// True only when every point of the box has one of the triangles, beyond the near plane, strictly between it and the
  /// viewpoint. False of a box that reaches beyond the picture, or before the near plane.
  [[nodiscard]] bool hides(const kernel::Aabb& box) const;

 private:
  BeamPicture picture_;
  CoverPiece piece_;
  int width_, height_;
  std::vector<float> nearness_;  ///< of each pixel, -infinity while it is open
};

}  // namespace occlude::culler
