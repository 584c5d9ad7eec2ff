// SPDX-License-Identifier: MIT
// Puts polygons, rectangles and boxes into the soup.
#pragma once

#include <cstddef>
#include <span>

#include "occlude/culler/polygon_soup.h"
#include "units.h"

namespace occlude::render::city {

/// A local coordinate frame: `along` runs in one of the four axis directions, `out` to the right of it, `up` is Z. The front
/// of a house faces `out`; walking round a block counter-clockwise keeps `out` to the street.
struct Frame {
  Point origin;
  Length ux = 1, uy = 0;  ///< direction of `along`: one of (1,0), (0,1), (-1,0), (0,-1)

  [[nodiscard]] constexpr Point at(Length along, Length out, Length up) const {
    return {origin.x + along * ux + out * uy, origin.y + along * uy - out * ux, origin.z + up};
  }
  /// The frame at (along, out, up) of this one, turned by `quarters` quarter turns counter-clockwise seen from above.
  [[nodiscard]] constexpr Frame moved(Length along, Length out, Length up, int quarters = 0) const {
    Frame f{at(along, out, up), ux, uy};
    for (int i = 0; i < (quarters & 3); ++i) {
      const Length x = f.ux;
      f.ux = -f.uy;
      f.uy = x;
    }
    return f;
  }
};

/// Extent of a box in a frame.
struct Extent {
  Length along0, along1, out0, out1, up0, up1;
};

/// Faces of a box, to be or-ed.
enum Faces : unsigned { kFront = 1, kBack = 2, kLeft = 4, kRight = 8, kTop = 16, kBottom = 32 };
inline constexpr unsigned kSides = kFront | kBack | kLeft | kRight;
inline constexpr unsigned kOnGround = kSides | kTop;  ///< a box without its lower face
inline constexpr unsigned kOnWall = kFront | kLeft | kRight | kTop | kBottom;
inline constexpr unsigned kAllFaces = kSides | kTop | kBottom;

class Builder {
 public:
  explicit Builder(culler::PolygonSoup& soup) : soup_(soup) {}

  [[nodiscard]] std::size_t size() const { return soup_.size(); }

  /// A convex, exactly plane loop. REQUIRES: no vertex twice, at least three.
  void polygon(std::span<const Point> loop);
  void quad(const Point& a, const Point& b, const Point& c, const Point& d);
  void triangle(const Point& a, const Point& b, const Point& c);

  /// A vertical rectangle facing `out`.
  void facing(const Frame& f, Length along0, Length along1, Length up0, Length up1, Length out);
  /// A vertical rectangle that faces `along`.
  void across(const Frame& f, Length along, Length out0, Length out1, Length up0, Length up1);
  /// A level rectangle.
  void level(const Frame& f, Length along0, Length along1, Length out0, Length out1, Length up);
  /// The chosen faces of a box, on eight vertices.
  void box(const Frame& f, const Extent& e, unsigned faces);

  /// Level ground cut into rectangles no longer than `cell` either way.
  void ground(const Rect& rect, Length z, Length cell);
  /// A vertical band along a side from `a` to `b` (same z), cut into pieces no longer than `cell`.
  void band(const Point& a, const Point& b, Length height, Length cell);

 private:
  culler::PolygonSoup& soup_;
};

}  // namespace occlude::render::city
