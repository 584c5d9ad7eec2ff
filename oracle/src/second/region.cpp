// SPDX-License-Identifier: MIT
// Whether a polygon meets the lines from the eyes e through a window with corners p is asked in weights: of the corners q of
// the polygon, of the eyes, and of the window. A point of both is
//   sum m_i q_i = sum l_i e_i + sum k_j p_j, with sum m_i = 1 and sum l_i + sum k_j = 1, up to the focus plane,
//   sum m_i q_i = sum k_j p_j + sum n_ij (p_j - e_i), with sum m_i = 1 and sum k_j = 1, beyond it,
// all weights >= 0. Half-spaces that cut the polygon are inequalities of the weights m_i. The crossings of one line are
// asked in the same way. No normal and no hull is computed.
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Quotient.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "occlude/oracle/second.h"

namespace occlude::oracle::second {
namespace {

using Number = CGAL::Gmpzf;
using Ratio = CGAL::Quotient<Number>;
using Vector = std::array<Number, 3>;
using Heights = std::vector<Number>;
using Corners = std::vector<Vector>;

Vector vector(const Point& p) { return {Number(p[0]), Number(p[1]), Number(p[2])}; }

/// a + factor b
Vector plus(const Vector& a, const Number& factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Vector operator-(const Vector& a, const Vector& b) { return plus(a, -1, b); }
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Corners corners(const Box& box) {
  const Aabb* aabb = std::get_if<Aabb>(&box);
  Corners result;
  for (unsigned c = 0; c < 8; ++c) {
    Vector corner = aabb ? Vector{} : vector(std::get<Obb>(box).center);
    for (unsigned k = 0; k < 3; ++k) {
      const bool is_high = (c >> k & 1U) != 0;
      if (aabb) corner[k] = (is_high ? aabb->max : aabb->min)[k];
      if (!aabb) corner = plus(corner, is_high ? 1 : -1, vector(std::get<Obb>(box).half_edges[k]));
    }
    result.push_back(corner);
  }
  return result;
}

/// The hull of points, and what is in these directions from it.
struct Part {
  Corners points, directions;
};

/// Whether the polygon, where all heights of each of `cuts` are >= 0, meets the part.
bool meet(const Corners& polygon, const Part& part, const std::vector<Heights>& cuts) {
  constexpr int kOfPolygon = 3, kOfPart = 4, kCuts = 5;  // rows: the coordinates are 0 to 2, then come sums of weights
  CGAL::Quadratic_program<Number> programme(CGAL::EQUAL, true, 0, false, 0);
  programme.set_b(kOfPolygon, 1);
  programme.set_b(kOfPart, 1);
  int column = 0;
  const auto add = [&](const Vector& at, int sign) {
    for (int k = 0; k < 3; ++k) programme.set_a(column, k, Number(sign) * at[static_cast<std::size_t>(k)]);
    return column++;
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const int weight = add(polygon[i], 1);
    programme.set_a(weight, kOfPolygon, 1);
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      programme.set_a(weight, kCuts + static_cast<int>(k), cuts[k][i]);
      programme.set_r(kCuts + static_cast<int>(k), CGAL::LARGER);
    }
  }
  for (const Vector& point : part.points) programme.set_a(add(point, -1), kOfPart, 1);
  for (const Vector& direction : part.directions) add(direction, -1);
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);  // Bland's rule cannot cycle, even in degenerate cases
  return !CGAL::solve_linear_program(programme, Number(), options).is_infeasible();
}

struct Rectangle {
  std::array<Ratio, 2> low, high;
};

/// What a window leaves of the rectangle is up to four rectangles. Each must be covered by the windows after it.
bool is_covered(Rectangle r, std::span<const Window> windows) {
  if (windows.empty()) return false;
  const Window& first = windows.front();
  const std::array<Ratio, 2> low{Ratio(first.x0), Ratio(first.y0)}, high{Ratio(first.x1), Ratio(first.y1)};
  for (std::size_t k = 0; k < 2; ++k) {
    if (r.high[k] < low[k] || high[k] < r.low[k]) return is_covered(r, windows.subspan(1));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    Rectangle below = r, above = r;
    below.high[k] = low[k];
    above.low[k] = high[k];
    if (r.low[k] < low[k] && !is_covered(below, windows.subspan(1))) return false;
    if (r.high[k] > high[k] && !is_covered(above, windows.subspan(1))) return false;
    r.low[k] = std::max(r.low[k], low[k]);
    r.high[k] = std::min(r.high[k], high[k]);
  }
  return true;
}

/// Judges a layer. The lines of sight are those from `eyes` to `seen`.
class RegionJudge {
 public:
  RegionJudge(const Layer& layer, Corners eyes, Corners box, Corners seen)
      : layer_(layer),
        eyes_(std::move(eyes)),
        box_(std::move(box)),
        seen_(std::move(seen)),
        origin_(vector(layer.focus.point)),
        right_(vector(layer.focus.right)),
        up_(cross(right_, vector(layer.focus.normal))),
        forward_(cross(up_, right_)),
        end_(depth(box_[0])) {
    for (const Vector& b : box_) end_ = std::min(end_, depth(b));
  }

  [[nodiscard]] RegionVerdict verdict() const {
    const auto reach = [&](const Number& least) {
      return std::ranges::any_of(eyes_, [&](const Vector& e) { return depth(e) >= least; });
    };
    if (reach(0)) return {RegionFault::eyes_at_focus, 0, {}};
    if (reach(end_) || std::ranges::any_of(seen_, [&](const Vector& x) { return reach(depth(x)); })) {
      return {RegionFault::eyes_at_box, 0, {}};
    }
    if (!is_covered(shadow(), layer_.windows)) return {RegionFault::uncovered, 0, {}};
    for (std::size_t i = 0; i < layer_.windows.size(); ++i) {
      if (const RegionFault fault = fault_of(layer_.windows[i]); fault != RegionFault::none) return {fault, i, {}};
    }
    return {};
  }

 private:
  using Triangle = std::array<Point, 3>;

  [[nodiscard]] Number depth(const Vector& x) const { return dot(x - origin_, forward_); }

  /// Around where the lines of sight cross the focus plane, at e d(b) - b d(e) over d(b) - d(e).
  [[nodiscard]] Rectangle shadow() const {
    std::optional<Rectangle> result;
    for (const Vector& e : eyes_) {
      for (const Vector& b : seen_) {
        std::array<Ratio, 2> at;
        for (std::size_t k = 0; k < 2; ++k) {
          const Vector& axis = k == 0 ? right_ : up_;
          at[k] = Ratio(dot(e - origin_, axis) * depth(b) - dot(b - origin_, axis) * depth(e),
                        (depth(b) - depth(e)) * dot(axis, axis));
        }
        if (!result) result = {at, at};
        for (std::size_t k = 0; k < 2; ++k) {
          result->low[k] = std::min(result->low[k], at[k]);
          result->high[k] = std::max(result->high[k], at[k]);
        }
      }
    }
    return *result;
  }

  [[nodiscard]] RegionFault fault_of(const Window& window) const {
    if (const Layer* layer = std::get_if<Layer>(&window.to)) {
      return RegionJudge(*layer, eyes_, box_, corners_of(window)).verdict().fault;
    }
    const Sheet& sheet = std::get<Sheet>(window.to);
    const std::vector<Triangle> triangles = triangles_of(sheet);
    const auto of_sheet = [&](std::span<const Point> points) { return drawn(sheet, points); };
    const auto begins_before = [&](const Triangle& t) { return least(of_sheet(t)) < 0; };
    for (const Triangle& t : triangles) {
      if (meet(polygon(t), {eyes_, {}}, {of_sheet(t)})) return RegionFault::eyes_at_sheet;
    }
    for (const bool is_beyond : {false, true}) {
      const auto shows = [&](std::span<const Point> points, std::vector<Heights> cuts) {
        cuts.push_back(negative(beyond(end_, points)));
        cuts.push_back(is_beyond ? beyond(0, points) : negative(beyond(0, points)));
        return meet(polygon(points), lines(window, is_beyond), cuts);
      };
      const RegionFault fault = is_beyond ? RegionFault::border_beyond : RegionFault::border_before;
      for (const auto& edge : border_of(triangles)) {
        if (shows(edge, {of_sheet(edge)})) return fault;
      }
      for (const Triangle& t : triangles) {
        if (begins_before(t) && shows(t, {of_sheet(t), negative(of_sheet(t))})) return fault;
      }
    }
    for (const Triangle& t : triangles) {
      // Of a triangle that ends at the plane of `drawn` all that is drawn has been found to be border.
      if (begins_before(t) && least(negative(of_sheet(t))) >= 0) continue;
      for (const bool is_beyond : {false, true}) {
        const Heights at_end = beyond(end_, t), at_focus = beyond(0, t);
        if (meet(polygon(t), lines(window, is_beyond),
                 {of_sheet(t), at_end, negative(at_end), is_beyond ? at_focus : negative(at_focus)})) {
          return RegionFault::not_nearer;
        }
      }
    }
    return is_odd(window, triangles) ? RegionFault::none : RegionFault::even;
  }

  [[nodiscard]] Corners corners_of(const Window& window) const {
    Corners result;
    for (const double x : {window.x0, window.x1}) {
      for (const double y : {window.y0, window.y1}) result.push_back(plus(plus(origin_, x, right_), y, up_));
    }
    return result;
  }

  /// Where the lines through the window are before the focus plane or beyond it.
  [[nodiscard]] Part lines(const Window& window, bool is_beyond) const {
    Part part{corners_of(window), {}};
    if (!is_beyond) {
      part.points.insert(part.points.end(), eyes_.begin(), eyes_.end());
      return part;
    }
    for (const Vector& p : part.points) {
      for (const Vector& e : eyes_) part.directions.push_back(p - e);
    }
    return part;
  }

  /// Counts the triangles that a line meets, of those that meet no edge.
  [[nodiscard]] bool is_odd(const Window& window, const std::vector<Triangle>& triangles) const {
    std::minstd_rand random(2);
    const auto share = [&] { return static_cast<double>(random() % 1023 + 1) * 0x1p-10; };
    for (;;) {
      const Vector &a = eyes_[random() % eyes_.size()], &b = eyes_[random() % eyes_.size()];
      const Vector e = plus(a, share(), b - a);
      const auto at = [&](double low, double high) { return Number(low) + Number(share()) * (Number(high) - Number(low)); };
      const Vector p = plus(plus(origin_, at(window.x0, window.x1), right_), at(window.y0, window.y1), up_);
      const auto meets_line = [&](std::span<const Point> points) {
        return meet(polygon(points), {{e}, {p - e}},
                    {drawn(std::get<Sheet>(window.to), points), negative(beyond(end_, points))});
      };
      std::size_t count = 0;
      bool is_general = true;
      for (const Triangle& t : triangles) {
        if (!meets_line(t)) continue;
        ++count;
        for (const auto& edge : edges(t)) is_general = is_general && !meets_line(edge);
      }
      if (is_general) return count % 2 == 1;
    }
  }

  static std::vector<Triangle> triangles_of(const Sheet& sheet) {
    std::map<Triangle, int> count;
    for (const Loop& loop : sheet.polygons()) {
      for (std::size_t i = 2; i < loop.size(); ++i) {
        Triangle triangle{loop[0], loop[i - 1], loop[i]};
        std::ranges::sort(triangle);
        ++count[triangle];
      }
    }
    std::vector<Triangle> result;
    for (const auto& [triangle, times] : count) {
      if (times % 2 == 1) result.push_back(triangle);
    }
    return result;
  }

  static std::array<std::array<Point, 2>, 3> edges(const Triangle& t) {
    return {{{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}}};
  }

  static std::vector<std::array<Point, 2>> border_of(const std::vector<Triangle>& triangles) {
    std::map<std::array<Point, 2>, int> count;
    for (const Triangle& t : triangles) {
      for (const auto& edge : edges(t)) ++count[edge];
    }
    std::vector<std::array<Point, 2>> result;
    for (const auto& [edge, times] : count) {
      if (times % 2 == 1 && edge[0] != edge[1]) result.push_back(edge);
    }
    return result;
  }

  static Corners polygon(std::span<const Point> points) {
    Corners result;
    for (const Point& p : points) result.push_back(vector(p));
    return result;
  }

  /// How far the points are beyond a depth.
  [[nodiscard]] Heights beyond(const Number& from, std::span<const Point> points) const {
    Heights heights;
    for (const Point& p : points) heights.push_back(depth(vector(p)) - from);
    return heights;
  }
  static Heights drawn(const Sheet& sheet, std::span<const Point> points) {
    const auto [a, b, c, d] = sheet.drawn().value_or(HalfSpaceCoefficients{0, 0, 0, 1});
    Heights heights;
    for (const Point& p : points) heights.push_back(dot(vector({a, b, c}), vector(p)) + Number(d));
    return heights;
  }
  static Heights negative(Heights heights) {
    for (Number& height : heights) height = -height;
    return heights;
  }
  static Number least(const Heights& heights) { return *std::ranges::min_element(heights); }

  const Layer& layer_;
  Corners eyes_, box_, seen_;
  Vector origin_, right_, up_, forward_;
  Number end_;  ///< the depth of the nearest corner of the box
};

}  // namespace

RegionVerdict judge(const RegionWitness& witness) {
  const Corners box = corners(witness.box);
  return RegionJudge(witness.layer, corners(std::get<Obb>(witness.eyes)), box, box).verdict();
}

RegionVerdict judge(const RegionWitness& witness, std::span<const Point> eyes) {
  Corners of_eyes;
  for (const Point& e : eyes) of_eyes.push_back(vector(e));
  const Corners box = corners(witness.box);
  return RegionJudge(witness.layer, of_eyes, box, box).verdict();
}

}  // namespace occlude::oracle::second
