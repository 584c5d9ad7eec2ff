// SPDX-License-Identifier: MIT
// A coarse picture whose pixels are cones of rays, and bounds of the errors of positions in it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "camera/frame_view.h"
#include "cover/eye_moves.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A point relative to the eye: to the right, up, and along the line of sight.
struct EyePoint {
  double right, up, forward;
};

/// A position in the picture: pixels to the right and up from its lower left corner.
struct PixelPosition {
  double x, y;
};

/// A position, and a bound of its error in each of the two directions.
struct BoundedPosition {
  PixelPosition place;
  double error;
  double forward = 0;  ///< how far along the line of sight the point is, as it was found; 0 if nobody knows
};

/// A position that the eyes of a region move, up to an error: to all that is between low and high.
struct MovedPosition : BoundedPosition {
  PixelPosition low, high;
};

/// A position whose moves are known for all planes in focus.
struct MovingPosition {
  BoundedPosition still;  ///< with an error that holds for all
  double nearness;
  EyeMoves::Range x, y;  ///< in pixels, for a focus of nearness + 1

  [[nodiscard]] MovedPosition at(double focus) const {
    const EyeMoves::Range across = x.times(focus - nearness), up = y.times(focus - nearness);
    const PixelPosition& place = still.place;
    return {still, {place.x + across.low, place.y + up.low}, {place.x + across.high, place.y + up.high}};
  }
};

/// An edge between two such positions: its direction and length in pixels, and the moves of its ends along and across it,
/// for a focus of the nearness of the end + 1.
struct MovingEdge {
  struct End {
    EyeMoves::Range along, across;
  };
  PixelPosition direction;
  double length;
  End from, to;
};

/// A convex quadrangle, and a bound of the error of its corners in each of the two directions.
struct SweptEdge {
  std::array<PixelPosition, 4> corners;  ///< in order
  double error;
};

/// All positions between two.
struct PixelBounds {
  PixelPosition low, high;
};

/// Whole pixels: columns from x0 to before x1, rows from y0 to before y1.
struct PixelRectangle {
  int x0, y0, x1, y1;
};

/// Computing a bound takes a few roundings. This factor is more than their error.
inline constexpr double kBoundRounded = 1 + 0x1p-40;

/// The doubles that are kept here, taken as exact numbers, define which ray meets which pixel. The rays of a pixel form a
/// convex cone, or a convex beam when they are parallel.
class ConservativeViewport {
 public:
  struct Size {
    int width, height;
    double border;  ///< pixels added on each side of the camera's picture
  };

  /// `rounding` bounds how far a renderer moves a point, in units of the scene; what the view itself says of moves is added.
  /// REQUIRES: 2 border < width, height; rounding <= kSinglePrecision times the depth of the view.
  ConservativeViewport(const FrameView& view, const Size& size, double rounding);
  ConservativeViewport() = default;

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }
  /// How far along the line of sight meshes are cut: beyond the renderer's near plane, however it rounds.
  [[nodiscard]] double near() const { return near_; }
  /// If the near plane is_oblique(), the cut alone does not take away what the renderer clips. A triangle with a corner that
  /// it may clip must not hide.
  [[nodiscard]] bool may_clip(const glm::dvec3& corner) const {
    return glm::dot(corner - eye_, near_normal_) < near_distance_;
  }
  [[nodiscard]] bool is_oblique() const { return is_oblique_; }

  /// The depth of the view. error() holds for points no farther from the eye than this, in the sum of the axes.
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  /// The axes along which eye_point() measures. Their length is nearly 1.
  [[nodiscard]] const glm::dvec3& right() const { return right_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  /// A position is middle() plus scale() times the slope of its ray, or times the distances to the right and up of a
  /// parallel ray.
  [[nodiscard]] const PixelPosition& middle() const { return middle_; }
  [[nodiscard]] const PixelPosition& scale() const { return scale_; }

  [[nodiscard]] EyePoint eye_point(const glm::dvec3& point) const;
  /// Where the edge from a to b passes near(). The result is the same for every triangle that asks, as long as a and b are
  /// not exchanged.
  [[nodiscard]] EyePoint cut(const EyePoint& a, const EyePoint& b) const;
  /// REQUIRES: in perspective, a point at near() or beyond. The functions below require the same of `forward`.
  [[nodiscard]] PixelPosition place(const EyePoint& seen) const;
  /// Bounds the error of a position in each direction, for a point that far along the line of sight. It includes error(),
  /// rounding() and the roundings of the position itself.
  [[nodiscard]] double place_error(const PixelPosition& place, double forward) const;
  [[nodiscard]] BoundedPosition corner(const EyePoint& seen) const {
    const PixelPosition place = this->place(seen);
    return {place, place_error(place, seen.forward), seen.forward};
  }

  /// Whether the picture is of several eyes. If it is, it has a plane in focus, at a distance of 1 / focus along the line
  /// of sight, and a ray from any of the eyes has the position of the ray from eye() that passes the plane at the same
  /// point. With a focus of 0 it has that of the parallel ray.
  [[nodiscard]] bool is_of_region() const { return is_of_region_; }
  /// A focus may be from 0 to this: half of the nearness of what is cut at near(), or less.
  [[nodiscard]] double most_focus() const { return kMostFocus / near_; }
  [[nodiscard]] const EyeRegion& eyes() const { return eyes_; }
  /// How far the eyes reach along the line of sight.
  [[nodiscard]] double eyes_forward() const { return eyes_forward_; }
  /// How far the eyes reach along a direction in the axes of the picture.
  [[nodiscard]] double reach(const glm::dvec3& direction) const {
    return kBoundRounded * eyes_.reach(direction.x * right_ + direction.y * up_ + direction.z * forward_);
  }
  [[nodiscard]] MovingPosition moving(const EyePoint& seen) const;
  [[nodiscard]] MovingEdge moving(const BoundedPosition& from, const BoundedPosition& to) const;
  /// Where the edge may be, from any of the eyes.
  [[nodiscard]] SweptEdge swept(const MovingEdge& edge, const BoundedPosition& from, const BoundedPosition& to,
                                double focus) const;

  /// By how many pixels a ray from any of the eyes is farther right, or up, in the picture with the focus `to` than in that
  /// with the focus `from`, where it has the position x, or y.
  [[nodiscard]] EyeMoves::Range ray_moves_across(double x, double from, double to) const {
    return ray_moves({1, 0}, {x, middle_.y}, from, to);
  }
  [[nodiscard]] EyeMoves::Range ray_moves_up(double y, double from, double to) const {
    return ray_moves({0, 1}, {middle_.x, y}, from, to);
  }

  /// Bounds the error of every position of an edge that may be in the picture, wherever the edge exactly is. At most the
  /// larger error of its ends. It is less where the edge leaves the picture towards an end that is near the eye.
  [[nodiscard]] double edge_error(const BoundedPosition& a, const BoundedPosition& b) const {
    const double most = std::max(a.error, b.error);
    return most <= kSmallError ? most : error_in_picture(a, b);
  }
  /// How many pixels a triangle of points covers, up to rounding; infinity if it reaches before near().
  [[nodiscard]] double area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;
  /// The slope of the ray through a position: how far right and up it is after a distance of 1 along the line of sight. Of a
  /// parallel ray, how far right and up of the eye it runs.
  [[nodiscard]] PixelPosition slope(double x, double y) const;
  /// Larger for nearer points, and linear along straight lines in the picture: 1 / forward, or -forward with parallel rays.
  [[nodiscard]] double nearness(double forward) const { return is_perspective_ ? 1 / forward : -forward; }

  /// Bounds the error of each coordinate that eye_point() and cut() return.
  [[nodiscard]] double error() const { return error_; }
  /// Bounds how far a point is moved by a renderer, by eyes beside eye() and by what is not known of the eye, in addition to
  /// error().
  [[nodiscard]] double rounding() const { return rounding_; }
  /// What was found to be that far along the line of sight is nowhere less near than this: nearness falls with distance, and
  /// `forward` is off by error() and rounding() at most. The two roundings of the result are left to rounded_down(): it
  /// takes off 2^-24 more than a float rounds by.
  [[nodiscard]] double least_nearness(double forward) const { return nearness(forward + moved_); }

  /// The pixels that a rectangle of positions touches when it is widened by `wider` pixels. They may end a pixel outside of
  /// the picture.
  [[nodiscard]] PixelRectangle pixels(const PixelPosition& low, const PixelPosition& high, double wider) const;
  /// The rectangle clipped to the picture.
  [[nodiscard]] PixelRectangle clipped(const PixelRectangle& r) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  /// In pixels. An edge that is off by no more is left as it is: a smaller bound would close hardly more pixels.
  static constexpr double kSmallError = 1;
  /// What is nearer than four times the distance of the cut hides as much with this focus as with its own. With eight times,
  /// Sponza would hide a third less from a ball of 0.25 m.
  static constexpr double kMostFocus = 1.0 / 4;

  [[nodiscard]] double error_in_picture(const BoundedPosition& a, const BoundedPosition& b) const;
  [[nodiscard]] EyeMoves::Range moves(const PixelPosition& direction, const BoundedPosition& position) const;
  [[nodiscard]] EyeMoves::Range ray_moves(const PixelPosition& direction, const PixelPosition& place, double from,
                                          double to) const;
  [[nodiscard]] double moved_error(const MovingPosition& position) const;

  glm::dvec3 eye_{}, right_{}, up_{}, forward_{};
  bool is_perspective_ = true;
  int width_ = 0, height_ = 0;
  PixelPosition middle_{}, scale_{};  ///< in pixels; in pixels per unit of slope, or of length with parallel rays
  double depth_ = 0, near_ = 0, error_ = 0, rounding_ = 0;
  double moved_ = 0;  ///< error_ + rounding_
  bool is_oblique_ = false;
  glm::dvec3 near_normal_{};
  double near_distance_ = 0;  ///< as in FrameView
  EyeRegion eyes_;
  bool is_of_region_ = false;
  double eyes_forward_ = 0, eyes_aside_ = 0;
  EyeMoves eye_moves_;
};

/// The four roundings of a position, 2^-53 each, and those where it is used. The most are in CoverBorder::turn(), 40.
inline constexpr double kPlaceError = 0x1p-47;

/// The pixel that holds a position. -1 and `count` stand for everything beside the picture.
[[nodiscard]] inline int pixel_at(double x, int count) {
  return static_cast<int>(std::min(std::max(x, -1.0), static_cast<double>(count)) + 1) - 1;
}

/// The first pixel, from 0 to `count`, whose middle is beyond the position.
[[nodiscard]] inline int first_middle(double x, int count) {
  return static_cast<int>(std::min(std::max(x + 0.5, 0.0), static_cast<double>(count)));
}

inline EyePoint ConservativeViewport::eye_point(const glm::dvec3& point) const {
  const glm::dvec3 y = point - eye_;
  return {glm::dot(right_, y), glm::dot(up_, y), glm::dot(forward_, y)};
}

inline PixelPosition ConservativeViewport::place(const EyePoint& seen) const {
  const double shrink = is_perspective_ ? 1 / seen.forward : 1;
  return {middle_.x + scale_.x * (seen.right * shrink), middle_.y + scale_.y * (seen.up * shrink)};
}

/// Let r and f be the coordinates as computed and s and g the exact ones, each with an error of at most e. Then
/// r / f - s / g = ((r - s) f - r (f - g)) / (f g), which is at most e (1 + |r / f|) / (f - e).
inline double ConservativeViewport::place_error(const PixelPosition& place, double forward) const {
  const double aside = std::max(std::fabs(place.x - middle_.x), std::fabs(place.y - middle_.y));
  const double scale = std::max(scale_.x, scale_.y);
  const double moved = is_perspective_ ? (scale + aside) * (moved_ / (forward - moved_)) : scale * moved_;
  return kBoundRounded * moved + kPlaceError * (aside + width_ + height_);
}

inline PixelPosition ConservativeViewport::slope(double x, double y) const {
  return {(x - middle_.x) / scale_.x, (y - middle_.y) / scale_.y};
}

inline PixelRectangle ConservativeViewport::pixels(const PixelPosition& low, const PixelPosition& high, double wider) const {
  return {pixel_at(low.x - wider, width_), pixel_at(low.y - wider, height_), pixel_at(high.x + wider, width_) + 1,
          pixel_at(high.y + wider, height_) + 1};
}

inline PixelRectangle ConservativeViewport::clipped(const PixelRectangle& r) const {
  return {std::max(r.x0, 0), std::max(r.y0, 0), std::min(r.x1, width_), std::min(r.y1, height_)};
}

}  // namespace occlude::culler
