// SPDX-License-Identifier: MIT
// Culls that hold for a region of eyes, proved as exactly as the questions of oracle.h are answered.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"

namespace occlude::oracle {

struct Ball {
  Point center{};
  double radius = 0;

  friend bool operator==(const Ball&, const Ball&) = default;
};

/// Where the eye may be: in a ball, or in a box whose half edges may be any vectors.
using EyeRegion = std::variant<Ball, Obb>;

/// Whether the point is in the ball, exactly. A ball that judge() refuses contains nothing. REQUIRES: the point is finite.
[[nodiscard]] bool contains(const Ball& ball, const Point& point);

/// The plane on which lines of sight are named by where they cross it: the points point + x right + y up, with up = right x
/// normal. `normal` points away from the eyes. `right` need not be a unit vector, nor perpendicular to `normal`.
struct Focus {
  Point point{}, normal{}, right{};
};

/// A set of triangles modulo 2: the fans of polygons, of which those that occur twice cancel each other. Its border are the
/// edges that an odd number of triangles have; corners with equal coordinates are the same. With `drawn`, only the part in
/// that half-space counts, and where its plane cuts the triangles is border, too. What a sheet derives from its polygons it
/// derives once. Copies share it, and any number of threads may use them.
class Sheet {
 public:
  explicit Sheet(const std::vector<Loop>& polygons, const std::optional<HalfSpaceCoefficients>& drawn = {});

  [[nodiscard]] const std::vector<Loop>& polygons() const;
  [[nodiscard]] const std::optional<HalfSpaceCoefficients>& drawn() const;

  struct Prepared;
  [[nodiscard]] const Prepared& prepared() const { return *prepared_; }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

struct Window;

/// A focus plane and windows on it.
struct Layer {
  Focus focus;
  std::vector<Window> windows;
};

/// The lines of sight that cross the focus plane at x0 <= x <= x1 and y0 <= y <= y1, and the sheet that all of them meet, or
/// another layer through whose windows all of them go.
struct Window {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::variant<Sheet, Layer> to;
};

/// Why a box is said to be hidden from every eye of the region.
struct RegionWitness {
  EyeRegion eyes;
  Box box;
  Layer layer;
};

/// What a witness fails to show. They are asked in this order, those of a window for one window after another.
enum class RegionFault {
  none,
  refused,        ///< its numbers are bad, or it takes more than about half a minute
  eyes_at_focus,  ///< not all eyes are strictly before the focus plane
  eyes_at_box,    ///< the same of the box, or of the window to which the layer belongs, along the normal of that plane
  uncovered,      ///< some line of sight may cross the focus plane outside of all windows
  eyes_at_sheet,  ///< the sheet meets the eyes
  border_before,  ///< the border of the sheet meets a line through the window, not beyond the focus plane
  border_beyond,  ///< the same, not before the focus plane
  not_nearer,     ///< a line through the window meets the sheet at the depth of the nearest corner of the box
  even,           ///< a line through the window meets the sheet an even number of times before that depth
};

struct RegionVerdict {
  RegionFault fault = RegionFault::none;
  std::size_t window = 0;  ///< of the first layer, of which the fault is, if it is of one
  std::string reason;      ///< the fault in words. Empty when the box is proved to be hidden

  [[nodiscard]] bool is_proved() const { return fault == RegionFault::none; }
};

/// Proves that every segment from an eye of the region to a point of the box meets a triangle of a sheet at a point strictly
/// between its ends. All of this must hold:
/// - The eyes are strictly before the focus plane and, along its normal, strictly before the box. The focus plane may lie
///   before, across or behind the box: a line of sight is extended beyond the box as far as that plane.
/// - The windows cover where the lines of sight to the box cross the focus plane: the bounding rectangle in its axes. The
///   windows of another layer do so for the lines of sight to the window that it belongs to.
/// - For each window with a sheet, on all lines from an eye through it, as far as the depth of the nearest corner of the
///   box: no point of the sheet's border; the sheet meets neither an eye nor that depth; and one line meets it an odd number
///   of times. Then all do, because that number changes by one only where a line passes the border, an eye or that depth.
/// Touching is meeting. Exact for boxes of eyes. A ball that is apart from the sheet by no more than rounding may be taken
/// to touch it.
[[nodiscard]] RegionVerdict judge(const RegionWitness& witness);

/// Whether `box` is in the shadow of the occluder from every eye of the region: inside when every segment from an eye to a
/// point of the box meets the occluder at a point strictly between its ends, else partial. Exact for balls, too. A polygon
/// that is not coplanar is refused, like what Shadow refuses from the middle of the region.
[[nodiscard]] Answer relation_to_umbra(const EyeRegion& eyes, const Occluder& occluder, const Box& box);

}  // namespace occlude::oracle
