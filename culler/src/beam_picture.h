// SPDX-License-Identifier: MIT
// A coarse picture whose pixels are cones of rays, and by how much places in it are out.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "frame_view.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A point relative to the eye: to the right, up, and along the line of sight.
struct Seen {
  double right, up, forward;
};

/// Of a point of the picture: pixels to the right, and up, from a corner.
struct Place {
  double x, y;
};

/// A place, and by how much it is out, at most, in both directions.
struct Corner {
  Place place;
  double error;
};

/// Of places, all that is between.
struct PlaceRectangle {
  Place low, high;
};

/// Whole pixels, from .x0 to before .x1, and rows likewise.
struct PixelRectangle {
  int x0, y0, x1, y1;
};

/// Which ray meets which pixel is given by the doubles that are kept here, taken as exact numbers: rays in a pixel of the
/// picture are those of a convex cone, or a convex beam along a direction of view.
class BeamPicture {
 public:
  struct Size {
    int width, height;
    double border;  ///< pixels on each side that the camera's picture has not
  };

  /// A renderer has points out by `rounding`, units of the scene. REQUIRES: 2 border < width, height; rounding <=
  /// kSinglePrecision depth.
  BeamPicture(const FrameView& view, const Size& size, double rounding);
  BeamPicture() = default;

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }
  /// Pieces of a cover are cut there: beyond the renderer's near plane, whatever it rounds.
  [[nodiscard]] double near() const { return near_; }

  /// As given: what is out by error() and no more lies within it.
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  /// What see() measures along: nearly of length 1.
  [[nodiscard]] const glm::dvec3& right() const { return right_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  /// A place is middle() and a slope times scale(); of parallel rays, what lies right and up times it.
  [[nodiscard]] const Place& middle() const { return middle_; }
  [[nodiscard]] const Place& scale() const { return scale_; }

  [[nodiscard]] Seen see(const glm::dvec3& point) const;
  /// Where the edge from a to b passes near(): the same point whichever triangle asks, as long as a and b are not exchanged.
  [[nodiscard]] Seen cut(const Seen& a, const Seen& b) const;
  /// REQUIRES: in perspective a point at near() or beyond; and so below.
  [[nodiscard]] Place place(const Seen& seen) const;
  /// In neither direction is a place out by more, by error() and rounding(), of a point so far along the line of sight.
  [[nodiscard]] double place_error(const Place& place, double forward) const;
  [[nodiscard]] Corner corner(const Seen& seen) const {
    const Place place = this->place(seen);
    return {place, place_error(place, seen.forward)};
  }
  /// Of the ray through a place: to the right and up, where it has gone 1 along the line of sight.
  [[nodiscard]] Place slope(double x, double y) const;
  /// The larger, the nearer, and linear along what is straight in the picture: 1 / forward, or -forward of parallel rays.
  [[nodiscard]] double nearness(double forward) const { return is_perspective_ ? 1 / forward : -forward; }

  /// No coordinate of what is seen, or cut, is out by more.
  [[nodiscard]] double error() const { return error_; }
  /// Nor, beside that, has a renderer it out by more.
  [[nodiscard]] double rounding() const { return rounding_; }
  /// The nearness of a point so far along the line of sight is out by no more.
  [[nodiscard]] double nearness_error(double forward) const;

  /// The pixels that the rectangle of places touches, which may end a pixel outside of the picture.
  [[nodiscard]] PixelRectangle pixels(const Place& low, const Place& high, double wider) const;
  /// As far as it is in the picture.
  [[nodiscard]] PixelRectangle clipped(const PixelRectangle& r) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  glm::dvec3 eye_{}, right_{}, up_{}, forward_{};
  bool is_perspective_ = true;
  int width_ = 0, height_ = 0;
  Place middle_{}, scale_{};  ///< pixels; pixels for a slope of 1, or a length of 1 across parallel rays
  double depth_ = 0, near_ = 0, error_ = 0, rounding_ = 0;
  double moved_ = 0;  ///< the sum of the two
};

/// Four roundings of a place, and as much again for what rounds where the place is used.
inline constexpr double kPlaceError = 0x1p-50;

/// A bound of a few roundings is out by less than this share of it.
inline constexpr double kBoundRounded = 1 + 0x1p-40;

/// The pixel that has a place, from -1 to `count`: beside the picture all are alike.
[[nodiscard]] inline int pixel_at(double x, int count) {
  return static_cast<int>(std::min(std::max(x, -1.0), static_cast<double>(count)) + 1) - 1;
}

/// The first pixel from 0 to `count` whose middle is beyond the place.
[[nodiscard]] inline int first_middle(double x, int count) {
  return static_cast<int>(std::min(std::max(x + 0.5, 0.0), static_cast<double>(count)));
}

inline Seen BeamPicture::see(const glm::dvec3& point) const {
  const glm::dvec3 y = point - eye_;
  return {glm::dot(right_, y), glm::dot(up_, y), glm::dot(forward_, y)};
}

inline Place BeamPicture::place(const Seen& seen) const {
  const double shrink = is_perspective_ ? 1 / seen.forward : 1;
  return {middle_.x + scale_.x * (seen.right * shrink), middle_.y + scale_.y * (seen.up * shrink)};
}

/// With r and f the coordinates as computed, s and g as they are, both out by e: r / f - s / g is
/// ((r - s) f - r (f - g)) / (f g), at most e (1 + |r / f|) / (f - e).
inline double BeamPicture::place_error(const Place& place, double forward) const {
  const double aside = std::max(std::fabs(place.x - middle_.x), std::fabs(place.y - middle_.y));
  const double scale = std::max(scale_.x, scale_.y);
  const double moved = is_perspective_ ? (scale + aside) * (moved_ / (forward - moved_)) : scale * moved_;
  return kBoundRounded * moved + kPlaceError * (aside + width_ + height_);
}

inline Place BeamPicture::slope(double x, double y) const {
  return {(x - middle_.x) / scale_.x, (y - middle_.y) / scale_.y};
}

/// 1 / f - 1 / g is (g - f) / (f g).
inline double BeamPicture::nearness_error(double forward) const {
  if (!is_perspective_) return kBoundRounded * moved_;
  return (kBoundRounded * (moved_ / (forward - moved_)) + 0x1p-52) / forward;
}

inline PixelRectangle BeamPicture::pixels(const Place& low, const Place& high, double wider) const {
  return {pixel_at(low.x - wider, width_), pixel_at(low.y - wider, height_), pixel_at(high.x + wider, width_) + 1,
          pixel_at(high.y + wider, height_) + 1};
}

inline PixelRectangle BeamPicture::clipped(const PixelRectangle& r) const {
  return {std::max(r.x0, 0), std::max(r.y0, 0), std::min(r.x1, width_), std::min(r.y1, height_)};
}

}  // namespace occlude::culler
