// SPDX-License-Identifier: MIT
// Boxes in the coarse picture, several at once: where they may reach, and how near.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "beam_picture.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A coarse picture in floats, rounded outwards where it matters.
class BoxPicture {
 public:
  BoxPicture() = default;
  /// `margin`: so many pixels around each box belong to it; infinity where nothing may be hidden.
  BoxPicture(const BeamPicture& picture, double margin);

  glm::dvec3 eye{};
  bool is_perspective = true;
  std::array<float, 3> right{}, up{}, forward{};
  float middle_x = 0, middle_y = 0, scale_x = 0, scale_y = 0;  ///< of places, as in BeamPicture
  float width = 0, height = 0;
  float near = 0;   ///< no less than the picture's
  float moved = 0;  ///< no coordinate that is exact as seen is out by more, by a renderer
  float wider = 0;  ///< the margin
};

/// Eight boxes at most, and what is known of them in a picture. A value for each.
struct SeenBoxes {
  static constexpr std::size_t kMost = 8;
  using Floats = std::array<float, kMost>;
  using Integers = std::array<std::int32_t, kMost>;

  void add(const BoxPicture& picture, const kernel::Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      low[static_cast<std::size_t>(axis)][size] = static_cast<float>(box.min[axis] - picture.eye[axis]);
      high[static_cast<std::size_t>(axis)][size] = static_cast<float>(box.max[axis] - picture.eye[axis]);
    }
    ++size;
  }
  /// Finds what follows.
  void see(const BoxPicture& picture);

  std::size_t size = 0;
  alignas(32) std::array<Floats, 3> low{}, high{};  ///< relative to the eye, rounded to nearest

  Floats low_x, low_y, high_x, high_y;  ///< places between which all of it lies, as what it is out by
  Integers x0, y0, x1, y1;              ///< pixels that it touches, with what is around it: as BeamPicture::pixels()
  /// Nothing of it is nearer. Infinity where that is not known, nor where it is: before the near plane, for one.
  Floats most;
  Floats distance;  ///< front to back: a heuristic
};

}  // namespace occlude::culler
