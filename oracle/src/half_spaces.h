// SPDX-License-Identifier: MIT
// The planes that bound a shadow frustum, as the definition states each.
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "corners.h"
#include "occlude/oracle/region_shadow.h"
#include "plane.h"

namespace occlude::oracle {

/// The direction in which `x` is seen.
template <class N>
Vector<N> sight(const Viewpoint& view, const Point& x) {
  return view.at_infinity ? vector_of<N>(view.value) : difference<N>(view.value, x);
}

/// The plane through the viewpoint and two points: height(x) is det(a - V, b - V, x - V), or det(d, b - a, x - a) for a
/// direction d. Its normal is zero when a and b are on one line of sight.
struct SidePlane {
  Viewpoint view;
  Point a, b;

  [[nodiscard]] bool passes_through(const Point& x) const { return x == a || x == b; }

  template <class N>
  HalfSpace<N> operator()() const {
    const Point& eye = view.value;
    if (view.at_infinity) return {CGAL::cross_product(vector_of<N>(eye), difference<N>(a, b)), vector_of<N>(a)};
    return {CGAL::cross_product(difference<N>(eye, a), difference<N>(eye, b)), vector_of<N>(eye)};
  }
};

/// The plane of a coplanar convex loop. Its normal is twice the vector area of the loop.
struct LoopPlane {
  Loop loop;

  [[nodiscard]] bool passes_through(const Point& x) const { return std::ranges::find(loop, x) != loop.end(); }

  template <class N>
  HalfSpace<N> operator()() const {
    Vector<N> sum(N(0), N(0), N(0));
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      sum = sum + CGAL::cross_product(difference<N>(loop[0], loop[i]), difference<N>(loop[0], loop[i + 1]));
    }
    return {sum, vector_of<N>(loop[0])};
  }
};

/// The plane through `point` with the normal that LoopPlane computes. For a loop that is not coplanar it is parallel to the
/// mean plane of the loop.
struct MeanPlane {
  Loop loop;
  Point point;

  template <class N>
  HalfSpace<N> operator()() const {
    return {LoopPlane{loop}.operator()<N>().normal, vector_of<N>(point)};
  }
};

/// The near plane `farthest`: perpendicular to the line of sight to the vertex `p`, positive beyond it.
struct FarthestPlane {
  Viewpoint view;
  Point p;

  template <class N>
  HalfSpace<N> operator()() const {
    return {sight<N>(view, p), vector_of<N>(p)};
  }
};

/// A plane given by its normal and a point.
struct GivenPlane {
  Point normal, point;

  template <class N>
  HalfSpace<N> operator()() const {
    return {vector_of<N>(normal), vector_of<N>(point)};
  }
};

/// The plane through viewpoints of a region and points: one corner of the region and two points, or two corners and one
/// point. Its normal is zero where these do not span a plane.
struct RegionPlane {
  ViewRegion region;
  std::vector<unsigned> corners;  ///< indices in corners_of(region.box)
  std::vector<Point> points;

  [[nodiscard]] bool passes_through(const Point& x) const { return std::ranges::find(points, x) != points.end(); }

  template <class N>
  HalfSpace<N> operator()() const {
    const std::vector<Vector<N>> all = corners_of<N>(region.box);
    const Vector<N> origin = vector_of<N>(points[0]);
    const auto along = [&](unsigned corner) -> Vector<N> { return region.at_infinity ? all[corner] : all[corner] - origin; };
    const Vector<N> first = along(corners[0]),
                    second = corners.size() > 1 ? along(corners[1]) : vector_of<N>(points[1]) - origin;
    return {CGAL::cross_product(first, second), origin};
  }
};

/// The plane a x + b y + c z + d = 0 of a half-space given by its coefficients.
struct CoefficientPlane {
  std::array<double, 4> coefficients;

  template <class N>
  HalfSpace<N> operator()() const {
    const auto& [a, b, c, d] = coefficients;
    return {vector_of<N>({a, b, c}), vector_of<N>({0, 0, 0}), N(d)};
  }
};

/// One of these planes, and the sign of its heights on the side that counts as positive.
struct OrientedPlane {
  std::variant<SidePlane, LoopPlane, MeanPlane, FarthestPlane, GivenPlane, CoefficientPlane, RegionPlane> plane;
  CGAL::Sign positive = CGAL::POSITIVE;

  template <class N>
  HalfSpace<N> operator()() const {
    const auto build = [](const auto& definition) { return definition.template operator()<N>(); };
    const HalfSpace<N> half_space = std::visit(build, plane);
    if (positive != CGAL::NEGATIVE) return half_space;
    return {-half_space.normal, half_space.point, -half_space.offset};
  }
};

}  // namespace occlude::oracle
