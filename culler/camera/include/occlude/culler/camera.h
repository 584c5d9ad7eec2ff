// SPDX-License-Identifier: MIT
// The camera of one frame, of either kind: by its eye and angles, or by a matrix as engines have it. Reading order: 2.
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// What hides.
enum class Method {
  frusta,     ///< the shadows of a few chosen occluders, each on its own: the paper's method
  cover,      ///< everything that is found visible, front to back, joined in a coarse picture
  automatic,  ///< cover, as far as it pays: the default
};

/// Whether frames of this method are made by cover.
[[nodiscard]] constexpr bool is_by_cover(Method method) { return method != Method::frusta; }

enum class Projection { perspective, orthographic };

/// Where the eye may be, relative to the eye of a camera: a ball, or a box. By default there is no room.
struct EyeRegion {
  double radius = 0;  ///< of the ball, in model units
  /// Of the box: its corners are all sums of them and their negatives. Any may be 0.
  std::array<glm::dvec3, 3> half_edges{};

  /// All eyes no farther than `radius` from the camera's.
  [[nodiscard]] static EyeRegion ball(double radius) { return {radius, {}}; }
  /// A box with these half-edges around the camera's eye.
  [[nodiscard]] static EyeRegion box(const glm::dvec3& a, const glm::dvec3& b = {}, const glm::dvec3& c = {}) {
    return {0, {a, b, c}};
  }

  /// Whether there is one eye, the camera's own.
  [[nodiscard]] bool is_point() const { return radius == 0 && half_edges == std::array<glm::dvec3, 3>{}; }
  /// The greatest product of an eye of the region and the direction, up to rounding: how far the region reaches along a unit
  /// vector.
  [[nodiscard]] double reach(const glm::dvec3& direction) const;

  friend bool operator==(const EyeRegion&, const EyeRegion&) = default;
};

/// A right-handed camera that looks from `eye` to `target`, with `up` towards the top of the picture. Positions and lengths
/// are in model units. `up` need be neither a unit vector nor perpendicular to the line of sight.
struct Camera {
  glm::dvec3 eye{0, 0, 0};
  glm::dvec3 target{1, 0, 0};
  glm::dvec3 up{0, 0, 1};
  Projection projection = Projection::perspective;
  double fov_y_deg = 60;                                       ///< full vertical opening angle, perspective only
  double height = 100;                                         ///< full vertical extent in model units, orthographic only
  double aspect = 16.0 / 9.0;                                  ///< width over height of the picture
  double near_plane = 0.1;                                     ///< distance of the near plane from the eye, model units
  double far_plane = std::numeric_limits<double>::infinity();  ///< as `near_plane`; infinite: no far plane
  EyeRegion eyes{};                                            ///< where the eye may be, relative to `eye`

  /// The axes of the picture, orthonormal up to rounding. `forward` is the line of sight, with coordinates that are legal
  /// for the kernel.
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  /// REQUIRES: the camera has no fault().
  [[nodiscard]] Axes axes() const;
  /// The viewpoint of the shadows: the eye of a perspective camera, axes().forward of an orthographic one.
  /// REQUIRES: the camera has no fault().
  [[nodiscard]] kernel::Viewpoint viewpoint() const;

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// A half-space {x : normal . x + offset >= 0}. `normal` need not be a unit vector.
struct HalfSpace {
  glm::dvec3 normal{0, 0, 0};
  double offset = 0;
};

/// Appends the half-spaces of the view frustum: left, right, bottom, top, near and, if the camera has one, far.
/// 1. Their intersection holds everything that a renderer in single precision can draw of a model within `depth` of the eye.
///    `depth` is an L1 distance, |dx| + |dy| + |dz|, in model units.
/// 2. Each plane lies at least 2^-20 `depth` outside the camera's own plane.
/// 3. All their numbers are legal for the kernel. A normal has length 1 or less, up to rounding.
/// REQUIRES: the camera has no fault().
void append_view_frustum(const Camera& camera, double depth, std::vector<HalfSpace>& planes);

/// Why the camera cannot be used; empty if it can. All numbers are checked, whatever the projection. The faults are:
/// 1. a number that is not finite (`far_plane` may be infinite) or is out of the kernel's legal range;
/// 2. an eye at its target, or an `up` of zero or within 1e-9 radians of the line of sight;
/// 3. fov_y_deg outside [0.001, 179], or aspect outside [1/65536, 65536];
/// 4. height <= 0, near_plane <= 0 or far_plane <= near_plane;
/// 5. eyes with a negative radius, or with both a radius and half-edges.
[[nodiscard]] std::string fault(const Camera& camera);

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
/// 6. `eyes` makes one frame hold for all eyes of a region around the matrix's, with the same orientation and projection:
///    for all cameras matrix * translation(-e) with e in the region. Nothing that one of them shows is culled. For two eyes
///    of one person, take the middle and half of their distance; for a matrix that comes later than the cull, how far the
///    eye may move until then. Less is hidden, and nothing hides that is nearer than the near plane and the region.
/// 7. The near plane may have any direction. What hides must be drawn, that is, be beyond it. With a plane across the line
///    of sight, what it cuts hides as far as it is beyond. With an oblique one, a triangle hides only if all of it is
///    beyond.
struct MatrixCamera {
  glm::dmat4 matrix{1};
  ClipDepth depth = ClipDepth::minus_w_to_w;
  /// Must be said with parallel rays. With perspective the matrix tells, and a camera that says otherwise has a fault.
  Nearer nearer = Nearer::unsaid;
  EyeRegion eyes{};  ///< where the eye may be, relative to eye()

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

  /// What `camera` shows, up to rounding. With Nearer::greater and no far plane, depth is reversed and infinite. For a
  /// projection alone, place the camera at the origin, looking along -z with y up; its matrix times your view matrix is the
  /// camera's. Throws std::invalid_argument for a camera with a fault(), for parallel rays without a far plane, and for
  /// Nearer::unsaid.
  [[nodiscard]] static MatrixCamera from_camera(const Camera& camera, ClipDepth depth, Nearer nearer);

  /// The eye, up to rounding. With parallel rays, a point of the near plane in the middle of the picture. REQUIRES: the
  /// camera has no fault().
  [[nodiscard]] glm::dvec3 eye() const;
  /// The viewpoint of the shadows: eye(), or the direction of parallel rays. REQUIRES: the camera has no fault().
  [[nodiscard]] kernel::Viewpoint viewpoint() const;

  friend bool operator==(const MatrixCamera&, const MatrixCamera&) = default;

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
/// 1. Their intersection holds everything that the matrix shows from any of `eyes`, and that a renderer in
///    single precision can draw of a model within `depth` of the eye. `depth` is an L1 distance, in model units.
/// 2. Each plane lies outside the matrix's own by as far as `eyes` reach and at least 2^-20 `depth`, and by more where the
/// rows of the
///    matrix nearly cancel in it, as in a far plane that is thousands of times as far as the near plane.
/// 3. All their numbers are legal for the kernel. A normal has length 1 or less, up to rounding.
/// 4. A plane that cuts off nothing is left out: the far plane of an infinite projection.
/// REQUIRES: the camera has no fault().
void append_view_frustum(const MatrixCamera& camera, double depth, std::vector<HalfSpace>& planes);

/// Why the camera cannot be used; empty if it can. The faults are:
/// 1. a number that is not finite, or above the kernel's legal range; eyes with a fault as those of a Camera;
/// 2. a matrix that is singular or nearly so: no eye, no direction, no depth;
/// 3. a picture without extent or without bound;
/// 4. parallel rays whose w is not positive, so that nothing shows, or without word of what is nearer;
/// 5. word of what is nearer that the matrix contradicts;
/// 6. an eye out of the kernel's legal range.
[[nodiscard]] std::string fault(const MatrixCamera& camera);

/// The pixels by which shadows must be taken smaller, so that a picture is the same with and without what they hide. A
/// rasteriser with a grid of 1/256 pixel moves a border by up to 1/512 pixel on each axis, sqrt(2)/512 in all. The borders
/// of what hides and of what is hidden can move towards each other: 0.0055. Where depths are moved away over up to 1/256
/// pixel, those of what hides are off by sqrt(2)/512 + 1/256 = 0.0067 pixel at the near side of the shadow.
inline constexpr double kPixelMargin = 1.0 / 128;

/// CullOptions::margin and SceneOptions::margin for a picture of so many rows of pixels: a share of its height.
[[nodiscard]] constexpr double margin_for(double rows, double pixels = kPixelMargin) { return pixels / rows; }

/// How far an eye may leave its way, and a head may turn. The lengths are for somebody who walks, in metres.
struct AheadOptions {
  double aside = 0.1;       ///< model units, to both sides of the way, and before and after a way that is shorter
  double up = 0.05;         ///< model units, to both sides across that
  double turn_degrees = 0;  ///< by how much the camera may turn, about any axis; perspective only
};

/// A camera from the middle of the way that the eye takes in so many seconds, with all eyes near the way as its `eyes`. A
/// frame of it holds (View::holds_for()) for a camera with the same picture that is anywhere there, turned by up to
/// turn_degrees.
/// 1. The region is a box. One half-edge is half of the way, but no shorter than `aside`; the others have the lengths of the
///    options. Each is longer by as far as `camera.eyes` reach along it.
/// 2. The picture is wider, as far as a picture may be (fault()): 60 degrees and 16:9 that turn by 10 take tangents 1.48 and
///    1.64 times as large. The near plane is farther, because what hides must be drawn by a camera that is turned, and the
///    far plane, if there is one, is as much farther.
/// 3. A matrix becomes a camera with a picture around the matrix's. If a ray of that picture does not meet its near plane,
///    as with oblique ones, a frame of the camera hides nothing.
/// 4. With parallel rays, the frame holds only if adding the way to eye and target leaves the line of sight the same to the
///    last bit, as where it runs along an axis.
/// Throws std::invalid_argument for a camera with a fault(), for parallel rays that are a matrix's, and for numbers of which
/// no camera can be made.
[[nodiscard]] Camera ahead(const Camera& camera, const glm::dvec3& velocity, double seconds,
                           const AheadOptions& options = {});
[[nodiscard]] Camera ahead(const MatrixCamera& camera, const glm::dvec3& velocity, double seconds,
                           const AheadOptions& options = {});

}  // namespace occlude::culler
