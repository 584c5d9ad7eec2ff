// SPDX-License-Identifier: MIT
// The expressions of the culler in numbers that trace their roundings. As in recompute.cpp, errors are convex functions of
// what is given, so a few numbers at the corners of their ranges have the largest. Constants that a file keeps to itself,
// and those that stand in an expression, are written here again.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "camera/single_precision.h"
#include "cover/conservative_viewport.h"
#include "recompute.h"
#include "traced_number.h"
#include "vector3.h"

namespace occlude::bound_check {
namespace {

template <int kBits>
using Number = BasicTracedNumber<kBits>;
using TracedVector = kernel::Vector3<TracedNumber>;

template <int kBits>
Exact off(const Number<kBits>& computed, const Number<kBits>& truth) {
  return Number<kBits>::sum(computed, -truth).most();
}

/// An exact number with an error of at most so many units of roundoff.
template <int kBits>
Number<kBits> with_error(double x, double units) {
  return Number<kBits>::sum(x, Number<kBits>(units).tail());
}

/// What the computation of a bound of 1 loses.
template <int kBits>
Exact lost(const Number<kBits>& bound) {
  return 1 - bound.least();
}

/// a + share (b - a) without rounding.
TracedNumber between(const TracedNumber& a, const TracedNumber& b, const TracedNumber& share) {
  return TracedNumber::sum(a, TracedNumber::product(share, TracedNumber::sum(b, -a)));
}

constexpr std::array kSigns{1.0, -1.0};
constexpr std::array kShares{0.0, 0.5, 1.0};

/// A coordinate of a point along an axis: the first product of three, after which come the most roundings.
template <int kBits>
Number<kBits> coordinate(const Number<kBits>& difference, const Number<kBits>& axis) {
  return difference * axis + Number<kBits>(0) + Number<kBits>(0);
}

/// ConservativeViewport::see().
Exact needed_by_points() { return off(coordinate<53>(TracedNumber(1) - TracedNumber(0), 1), TracedNumber(1)); }

/// ConservativeViewport::cut(), of an edge whose ends have the error of points. The cut is on the edge, at the share that
/// was computed.
Exact needed_by_cuts() {
  constexpr double kOfPoints = 4;
  Exact most = 0;
  for (const double near : kShares) {
    const TracedNumber before = with_error<53>(-1, kOfPoints), beyond = with_error<53>(1, kOfPoints);
    const TracedNumber share = (TracedNumber(near) - before) / (beyond - before);
    most = std::max(most, off(between(-1, 1, share), TracedNumber(near)));
    for (const double a : kSigns) {
      for (const double b : kSigns) {
        const TracedNumber from = with_error<53>(a, kOfPoints), to = with_error<53>(b, kOfPoints);
        most = std::max(most, off(from + share * (to - from), between(a, b, share)));
      }
    }
  }
  return most;
}

/// ConservativeViewport::place(): a position to the side, and the middle of a picture that is 1 wide and 1 high.
Exact needed_by_places() {
  Exact most = 0;
  for (const auto& [middle, aside] : {std::pair{0.0, 1.0}, {0.5, 0.0}, {0.5, 1.0}}) {
    const TracedNumber shrink = TracedNumber(1) / TracedNumber(1);
    const TracedNumber place = TracedNumber(middle) + TracedNumber(1) * (TracedNumber(aside) * shrink);
    most = std::max(most, Exact(off(place, TracedNumber(middle + aside)) / Exact(aside + 2 * middle)));
  }
  return most;
}

/// CoverBorder::turn(): heights of an edge from a to b at some columns.
Exact needed_by_turns() {
  Exact most = 0;
  for (const double a : kSigns) {
    for (const auto& [first, group, lane] : {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
      const TracedNumber slope = (TracedNumber(1) - TracedNumber(a)) / (TracedNumber(1) - TracedNumber(0));
      const TracedNumber y = TracedNumber(a) + (TracedNumber(first) - TracedNumber(0)) * slope;
      const TracedNumber height = y + TracedNumber(group) * slope + TracedNumber(lane) * slope + TracedNumber(0);
      most = std::max(most, off(height, TracedNumber(a + (first + group + lane) * (1 - a))));
    }
  }
  return most;
}

/// ProjectedEdge::between(), and positions in CoverBorder's floats: a column of an edge from `a` to `b`, of the sum of both.
template <int kBits>
Exact needed_by_columns() {
  using N = Number<kBits>;
  Exact most = 0;
  for (const auto& [a, b] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {-1.0, 1.0}, {1.0, 1.0}}) {
    for (const double share : kShares) {
      const N slope = (N(b) - N(a)) / (N(1) - N(0)), low = kBits == 24 ? N(a).rounded() : N(a);
      const N column = low + N(share) * slope - N(0);
      most = std::max(most, Exact(off(column, N(a + share * (b - a))) / Exact(std::fabs(a) + std::fabs(b))));
    }
  }
  return most;
}

/// The distance of a row from the low end of an edge, in CoverBorder's floats.
Exact needed_by_rows() {
  const TracedFloat row = TracedFloat(1).rounded() + TracedFloat(0);
  return off(row + TracedFloat(0) + TracedFloat(0), TracedFloat(1));
}

/// ProjectedPlane: the height of a plane at a vertex, of a normal and a vertex that are known. Its size is 1.
Exact needed_by_heights_of_planes() {
  const TracedVector normal{1, 0, 0}, vertex{1, 0, 0};
  const TracedNumber height = kernel::dot(normal, vertex), size = TracedNumber(1) + TracedNumber(0) + TracedNumber(0);
  // What is added for the moves is as large as 1 at most; here it is the size by 1.
  const TracedNumber moved = height + size * (TracedNumber(1) + TracedNumber(0));
  return off(moved, TracedNumber(2));
}

/// lower(): the function of a plane along a ray, by each of its three terms. The slopes of the ray and the constant are
/// computed. What multiplies all of it is left to needed_by_rounding_down().
Exact needed_by_functions_of_planes() {
  const TracedNumber slope = (TracedNumber(1) - TracedNumber(0)) / TracedNumber(1),
                     constant = TracedNumber(1) - TracedNumber(0);
  Exact most = 0;
  for (const auto& [of_constant, of_y, of_x] : {std::array{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
    const TracedNumber value =
        TracedNumber(of_constant) * constant + TracedNumber(of_y) * slope + TracedNumber(of_x) * slope;
    most = std::max(most, off(value, TracedNumber(1)));
  }
  return most;
}

/// projected_boxes.cpp: a position, with the roundings of what is then subtracted and added.
Exact needed_by_places_of_boxes() {
  const TracedFloat shrink = TracedFloat(1) / TracedFloat(1), scale = TracedFloat(1).rounded();
  const TracedFloat x = TracedFloat(1) * shrink * scale, middle = TracedFloat(0).rounded();
  return off(middle + x - TracedFloat(0) - TracedFloat(0) + TracedFloat(0), TracedFloat(1));
}
Exact needed_by_middles_of_boxes() {
  const TracedFloat middle = TracedFloat(0.5).rounded();
  return off(middle + TracedFloat(0) - TracedFloat(0) - TracedFloat(0) + TracedFloat(0), TracedFloat(0.5));
}

/// The coordinate of a corner. Relative to the eye it rounds to a float, and so does the axis.
Exact needed_by_corners_of_boxes() {
  return off(coordinate(TracedFloat(1).rounded(), TracedFloat(1).rounded()), TracedFloat(1));
}

/// The bound of coordinates, and that of positions that follows from it.
Exact lost_by_moves_of_boxes() {
  const TracedFloat sum = TracedFloat(1) + TracedFloat(0) + TracedFloat(0) + TracedFloat(0);
  return lost((sum * TracedFloat(1) + TracedFloat(0)) * TracedFloat(1));
}
Exact lost_by_shifts_of_boxes() {
  const TracedFloat scale = TracedFloat(1).rounded(), aside = TracedFloat(0) * scale;
  const TracedFloat least = TracedFloat(1) - TracedFloat(0);
  const TracedFloat shifted = (scale + aside) * (TracedFloat(1) / least);
  return lost(shifted * TracedFloat(1) + TracedFloat(0));
}

/// The nearness of a box, once it is made larger.
Exact lost_by_nearness_of_boxes() {
  const TracedFloat nearness = TracedFloat(1) / (TracedFloat(1) - TracedFloat(0));
  return lost(nearness + TracedFloat(0));
}

/// MatrixRow::at(), and a dot product with the constant that ShadowMargin's rounding_of() bounds.
Exact needed_by_rows_of_matrices() { return off(coordinate<53>(1, 1) + TracedNumber(0), TracedNumber(1)); }
Exact needed_by_heights() { return off(coordinate<53>(TracedNumber(1) - TracedNumber(0), 1), TracedNumber(1)); }

/// A component of a normal that is a sum of two rows, divided by its length; that is 1, in one component or in another.
Exact needed_by_normals() {
  Exact most = 0;
  const TracedNumber x = TracedNumber(1) + TracedNumber(0), other = TracedNumber(1) + TracedNumber(0);
  for (const TracedNumber& longest : {x, other}) {
    const TracedNumber squared = longest * longest + TracedNumber(0) + TracedNumber(0);
    most = std::max(most, off(x / squared.root().rounded(), TracedNumber(1)));
  }
  return most;
}

/// The offset of a half-space of a camera, through a point at a distance from the eye. It is enlarged by two numbers.
Exact needed_by_offsets() {
  const TracedNumber point = TracedNumber(0) + TracedNumber(1) * TracedNumber(1);
  return off(coordinate<53>(1, point) + TracedNumber(0) + TracedNumber(0), TracedNumber(1));
}

/// A renderer in floats (single_precision.h): a coordinate relative to the middle of the model, two parts of the eye, an
/// axis, the sum of a row, and what it is compared with.
Exact needed_by_renderers() {
  const TracedFloat y = TracedFloat(1).rounded() - TracedFloat(0) - TracedFloat(0);
  const TracedFloat row = coordinate(y, TracedFloat(1).rounded()) + TracedFloat(0);
  return TracedFloat::sum(row, -TracedFloat(1).rounded()).most();
}

/// rounded_down(), which rounds to a float what has been rounded to doubles four times: as a reciprocal, as its product,
/// when the rounding is computed, and when that is subtracted.
Exact needed_by_rounding_down() {
  const TracedFloat one = 1, in_double = TracedFloat::sum(one, TracedFloat::product(4 * 0x1p-29, one.tail()));
  return off(in_double.rounded(), one);
}

}  // namespace

std::vector<Constant> recomputed_culler_constants() {
  const auto units = [](int count, int bits = 53) -> Exact { return Exact(count) * Exact(std::ldexp(1.0, -bits)); };
  const Exact of_places = needed_by_places(), place_error(culler::kPlaceError), bound_rounded(culler::kBoundRounded);
  return {
      {"error() / depth", "points in a picture", needed_by_points(), units(16)},
      {"error() / depth", "cuts at the near plane", needed_by_cuts(), units(16)},
      {"kPlaceError", "positions of corners", of_places, place_error},
      {"kPlaceError", "the same, and heights of edges over columns", of_places + needed_by_turns(), place_error},
      {"2^-49 in ProjectedEdge", "columns of edges", needed_by_columns<53>(), units(16)},
      {"error() / depth", "vertices, and heights of planes at them", needed_by_points() + needed_by_heights_of_planes(),
       units(16)},
      {"kRounded of ProjectedPlane", "functions of planes along rays", needed_by_functions_of_planes(), units(16)},
      {"2^-23 in rounded_down()", "doubles rounded to floats", needed_by_rounding_down(), units(2, 24), 1, 24},
      {"2^-20 in CoverBorder", "columns of edges in floats", needed_by_columns<24>(), units(16, 24), 1, 24},
      {"2^-21 in CoverBorder", "rows from the ends of edges in floats", needed_by_rows(), units(8, 24), 1, 24},
      {"kSeenError of ProjectedBoxes", "corners of boxes in floats", needed_by_corners_of_boxes(), units(6, 24), 1, 24},
      {"kPlaceError of ProjectedBoxes", "positions of boxes aside", needed_by_places_of_boxes(), units(16, 24), 1, 24},
      {"kPlaceError of ProjectedBoxes", "the middle of the picture", needed_by_middles_of_boxes(), units(16, 24), 1, 24},
      {"kBoundRounded - 1 of ProjectedBoxes", "bounds of coordinates", lost_by_moves_of_boxes(), units(16, 24), 1, 24},
      {"kBoundRounded - 1 of ProjectedBoxes", "bounds of positions", lost_by_shifts_of_boxes(), units(16, 24), 1, 24},
      {"2^-21 of ProjectedBoxes", "nearness of boxes", lost_by_nearness_of_boxes(), units(8, 24), 1, 24},
      {"2^-50 in error_at()", "rows of a matrix at points", needed_by_rows_of_matrices(), units(8)},
      {"2^-48 in MatrixEye::plane()", "normals of unit length", needed_by_normals(), units(32)},
      {"2^-48 in half_space()", "offsets of planes of a camera", needed_by_offsets(), units(32)},
      {"2^-50 in rounding_of()", "heights along the line of sight", needed_by_heights(), units(8)},
      {"kSinglePrecision", "a renderer in floats", needed_by_renderers(), Exact(culler::kSinglePrecision), 1, 24},
  };
}

}  // namespace occlude::bound_check
