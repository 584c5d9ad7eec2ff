// SPDX-License-Identifier: MIT
// A camera as engines have it: a matrix to clip space. Reading order: 2.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

enum class Method;

/// The clip volume is -w <= x <= w, -w <= y <= w, and of the depth z:
enum class ClipDepth {
  minus_w_to_w,  ///< -w <= z <= w, as in OpenGL
  zero_to_w,     ///< 0 <= z <= w, as in Vulkan, Direct3D and Metal
};

/// Which of two depths z / w the renderer draws before the other.
enum class Nearer {
  unsaid,   ///< that which the matrix has nearer to its eye; with parallel rays the matrix does not tell
  less,     ///< the usual
  greater,  ///< reversed depth
};

/// A camera that is any projective matrix: perspective or parallel rays, either handedness, any axis up, finite or infinite,
/// depth reversed or not, off-centre (virtual reality, tiles), jittered, with an oblique near plane, a shadow map. All of it
/// follows from the matrix.
///
/// 1. `matrix` times the column (x, y, z, 1) of a point of the model is its place in clip space, (x, y, z, w). GLM stores
///    columns: matrix[column][row].
/// 2. The matrix is taken as sixteen exact numbers, and stands for the same camera if all are multiplied by one positive
///    number. What it shows is the clip volume, in real numbers. Nothing of that is culled.
/// 3. The eye is the point that has x = y = w = 0. Rays are parallel if the last row is (0, 0, 0, w), in which numbers below
///    2^-106 w count as 0. The direction then is that of x = y = 0. With perspective, w grows along the line of sight.
/// 4. The eye, or the direction, is found up to rounding, and its error is bounded. Both methods cull only what is hidden
///    from wherever in the bound the eye may be. Numbers below 2^-60 of the length of a normal or a direction, and
///    coordinates of the eye below the kernel's least, 2^-100, count as 0. The bounds of errors include that.
/// 5. Planes and covers leave room for a renderer in single precision that computes relative to the eye, or to something
///    near it, as those for Camera do. One that multiplies far-away coordinates by a matrix in floats is off by more. So is
///    the matrix, if it was made in floats from such coordinates: then it is not the camera that was meant.
/// 6. `eye_radius` makes one frame hold for several eyes: all within that distance of the matrix's, with the same
///    orientation and projection, that is all cameras matrix * translation(-e) with |e| <= eye_radius. Nothing that one of
///    them shows is culled. For two eyes of one person, take the middle and half of their distance; for a matrix that comes
///    later than the cull, how far the eye may move until then. By Method::cover alone. Less is hidden: what is hidden looks
///    smaller by the radius, and nothing hides that is nearer than the near plane and the radius.
/// 7. The near plane may have any direction. What hides must be drawn, that is, be beyond it. With a plane across the line
///    of sight, what it cuts hides as far as it is beyond. With an oblique one, a triangle hides only if all of it is
///    beyond.
struct MatrixCamera {
  glm::dmat4 matrix{1};
  ClipDepth depth = ClipDepth::minus_w_to_w;
  /// Must be said with parallel rays. With perspective the matrix tells, and a camera that says otherwise has a fault.
  Nearer nearer = Nearer::unsaid;
  double eye_radius = 0;  ///< model units

  /// From sixteen numbers, column after column: the memory of OpenGL and GLM, and that of Direct3D's row vectors times
  /// matrices stored row after row. REQUIRES: `numbers` points to 16 numbers.
  template <class Number>
  [[nodiscard]] static MatrixCamera from_columns(const Number* numbers, ClipDepth depth, Nearer nearer = Nearer::unsaid) {
    return from(numbers, 4, 1, depth, nearer);
  }
  /// From sixteen numbers, row after row, for column vectors: the transpose of the above. REQUIRES: as above.
  template <class Number>
  [[nodiscard]] static MatrixCamera from_rows(const Number* numbers, ClipDepth depth, Nearer nearer = Nearer::unsaid) {
    return from(numbers, 1, 4, depth, nearer);
  }

  /// The eye, up to rounding. With parallel rays, a point of the near plane in the middle of the picture. REQUIRES: the
  /// camera has no fault().
  [[nodiscard]] glm::dvec3 eye() const;
  /// The viewpoint of the shadows: eye(), or the direction of parallel rays. REQUIRES: the camera has no fault().
  [[nodiscard]] kernel::Viewpoint viewpoint() const;

 private:
  template <class Number>
  [[nodiscard]] static MatrixCamera from(const Number* numbers, std::size_t column, std::size_t row, ClipDepth depth,
                                         Nearer nearer) {
    MatrixCamera camera;
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) {
        const std::size_t place = static_cast<std::size_t>(c) * column + static_cast<std::size_t>(r) * row;
        camera.matrix[c][r] = static_cast<double>(numbers[place]);
      }
    }
    camera.depth = depth;
    camera.nearer = nearer;
    return camera;
  }
};

/// Appends the half-spaces of the clip volume: left, right, bottom, top, near and far.
/// 1. Their intersection holds everything that the matrix shows from any eye within eye_radius, and that a renderer in
///    single precision can draw of a model within `depth` of the eye. `depth` is an L1 distance, in model units.
/// 2. Each plane lies outside the matrix's own by eye_radius and at least 2^-20 `depth`, and by more where the rows of the
///    matrix nearly cancel in it, as in a far plane that is thousands of times as far as the near plane.
/// 3. All their numbers are legal for the kernel. A normal has length 1 or less, up to rounding.
/// 4. A plane that cuts off nothing is left out: the far plane of an infinite projection.
/// REQUIRES: the camera has no fault().
void append_view_frustum(const MatrixCamera& camera, double depth, std::vector<HalfSpace>& planes);

/// Why the camera cannot be used; empty if it can. The faults are:
/// 1. a number that is not finite, or above the kernel's legal range; an eye_radius that is negative or not legal;
/// 2. a matrix that is singular or nearly so: no eye, no direction, no depth;
/// 3. a picture without extent or without bound;
/// 4. parallel rays whose w is not positive, so that nothing shows, or without word of what is nearer;
/// 5. word of what is nearer that the matrix contradicts;
/// 6. an eye out of the kernel's legal range.
[[nodiscard]] std::string fault(const MatrixCamera& camera);
/// The same for a frame by this method. By Method::frusta, an eye_radius above 0 is a fault: shadows are from one point.
[[nodiscard]] std::string fault(const MatrixCamera& camera, Method method);

}  // namespace occlude::culler
