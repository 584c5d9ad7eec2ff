// SPDX-License-Identifier: MIT
// Several boxes at once in the coarse picture: where they may reach, and how near.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "cover/conservative_viewport.h"
#include "cover/focus_layers.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A coarse picture in floats, rounded outwards where it matters.
class BoxPicture {
 public:
  BoxPicture() = default;
  /// `margin` is the number of pixels across and up around each box that belong to it; infinity if nothing may be hidden.
  BoxPicture(const ConservativeViewport& picture, const PixelPosition& margin, const FocusLayers& in_focus = {});

  glm::dvec3 eye{};
  bool is_perspective = true;
  std::array<float, 3> right{}, up{}, forward{};
  float middle_x = 0, middle_y = 0, scale_x = 0, scale_y = 0;  ///< as in ConservativeViewport
  float width = 0, height = 0;
  float near = 0;                  ///< not less than the picture's
  float moved = 0;                 ///< the picture's error() and rounding() together, and what floats may lose
  float wider_x = 0, wider_y = 0;  ///< the margin
  /// Of a picture of several eyes: how far they reach along the axes of the picture, and its layers.
  bool is_of_region = false;
  std::array<std::array<float, 3>, 3> half_edges{};
  float radius = 0;  ///< of the ball
  /// a, b, c of the square a + b x + c x^2 of how far a ball of radius 1 reaches: that of a small radius is no float.
  std::array<float, 3> right_of_ball{}, up_of_ball{};
  float eyes_forward = 0;  ///< along the line of sight
  float eyes_reach = 0;    ///< bounds the terms that are added up for the others
  FocusLayers layers;
  std::int32_t tiles_of_layer = 0;
};

/// Where at most eight boxes are in a picture. Each array has a value for each box.
struct BoxPixels {
  static constexpr std::size_t kMost = kernel::BoxBlock::kBoxes;
  using Floats = std::array<float, kMost>;
  using Integers = std::array<std::int32_t, kMost>;

  std::size_t size = 0;
  Integers x0, y0, x1, y1;  ///< the pixels that it touches, with the margin, as ConservativeViewport::pixels()
  /// No point of the box is nearer. Infinity if that or the position of the box is unknown, for example of one that
  /// reaches before the near plane.
  Floats most;
  Integers first_tile{};  ///< of the layer that it asks

  void add(const PixelRectangle& pixels, float nearest, std::int32_t tile = 0) {
    first_tile[size] = tile;
    x0[size] = pixels.x0;
    y0[size] = pixels.y0;
    x1[size] = pixels.x1;
    y1[size] = pixels.y1;
    most[size++] = nearest;
  }
  /// A bit for each box.
  [[nodiscard]] kernel::BoxBits all() const { return static_cast<kernel::BoxBits>((1U << size) - 1); }
};

/// At most eight boxes, and what is known of them in a picture.
struct ProjectedBoxes : BoxPixels {
  void add(const BoxPicture& picture, const kernel::Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      low[static_cast<std::size_t>(axis)][size] = static_cast<float>(box.min[axis] - picture.eye[axis]);
      high[static_cast<std::size_t>(axis)][size] = static_cast<float>(box.max[axis] - picture.eye[axis]);
    }
    ++size;
  }
  /// Computes all members but `size`, `low` and `high`.
  void project(const BoxPicture& picture);
  /// Takes all boxes of a block, and computes the other members.
  void project(const BoxPicture& picture, const kernel::BoxBlock& block);

  alignas(32) std::array<Floats, 3> low, high;  ///< relative to the eye, rounded to nearest

  Floats low_x, low_y, high_x, high_y;  ///< the positions between which the whole box lies, with its error
  Floats distance;                      ///< orders boxes from front to back; a heuristic
  /// In a picture of several eyes, where they are in the layer on the other side. The members above are those in the layer
  /// that is focused farther away than the box.
  BoxPixels nearer_layer;
};

}  // namespace occlude::culler
