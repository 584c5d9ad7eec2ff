// SPDX-License-Identifier: MIT
// The oracle on polytopes, against a second way of deciding. This way uses no planes and no silhouettes, but only the
// meaning of a shadow: x is in the shadow when x = V + m (o - V) for some point o of the polytope and some m >= 1. With
// weights of the vertices this is x - V = sum w_i (v_i - V), w_i >= 0, sum w_i >= 1. Together with the box's own coordinates
// it is a linear programme, which is solved in integers. The polytopes are hulls of lattice points, with faces written in
// all legal ways.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/oracle.h"
#include "oracle/vocabulary.h"
#include "oracle/whole_numbers.h"

namespace occlude::oracle {
namespace weights_test {

// ------------------------------------------------------------------------------------------------------ linear programmes

/// A system of equations: the sum of each column times its variable is the right-hand side. The variables are not negative.
struct Equations {
  std::vector<std::vector<Whole>> columns;
  std::vector<Whole> right;
};

/// Decides whether there is a solution, by the simplex method in integers, with one artificial variable for each row and
/// Bland's rule. Every entry is a determinant of the given numbers over the common denominator `scale_`.
class Simplex {
 public:
  explicit Simplex(const Equations& equations) : rows_(equations.right.size()), columns_(equations.columns.size()) {
    table_.assign(rows_ + 1, std::vector<Whole>(columns_ + 1));
    for (std::size_t r = 0; r < rows_; ++r) {
      const Whole sign = equations.right[r] < 0 ? -1 : 1;
      for (std::size_t c = 0; c < columns_; ++c) table_[r][c] = sign * equations.columns[c][r];
      table_[r][columns_] = sign * equations.right[r];
      for (std::size_t c = 0; c <= columns_; ++c) table_[rows_][c] += table_[r][c];
      basis_.push_back(columns_ + r);
    }
  }

  bool is_solvable() {
    for (std::size_t c = entering(); c < columns_; c = entering()) pivot(leaving(c), c);
    return table_[rows_][columns_] == 0;
  }

 private:
  /// The first column whose variable reduces the sum of the artificial variables, which is the last row.
  [[nodiscard]] std::size_t entering() const {
    const auto& objective = table_[rows_];
    return static_cast<std::size_t>(std::find_if(objective.begin(), objective.end() - 1, [](Whole x) { return x > 0; }) -
                                    objective.begin());
  }

  /// The row that limits the variable of the column. There is one, because the sum cannot fall below zero.
  [[nodiscard]] std::size_t leaving(std::size_t c) const {
    std::size_t best = rows_;
    for (std::size_t r = 0; r < rows_; ++r) {
      if (table_[r][c] <= 0) continue;
      const Whole lead = best == rows_ ? -1 : table_[r][columns_] * table_[best][c] - table_[best][columns_] * table_[r][c];
      if (lead < 0 || (lead == 0 && basis_[r] < basis_[best])) best = r;
    }
    return best;
  }

  void pivot(std::size_t r, std::size_t c) {
    const Whole p = table_[r][c];
    for (std::size_t i = 0; i <= rows_; ++i) {
      if (i == r) continue;
      const Whole factor = table_[i][c];
      for (std::size_t j = 0; j <= columns_; ++j) table_[i][j] = (table_[i][j] * p - factor * table_[r][j]) / scale_;
    }
    scale_ = p;
    basis_[r] = c;
  }

  std::size_t rows_, columns_;
  std::vector<std::vector<Whole>> table_;
  std::vector<std::size_t> basis_;
  Whole scale_ = 1;
};

// --------------------------------------------------------------------------------------------------------- lattice hulls

using WholeLoop = std::vector<std::uint32_t>;

/// Points, and the faces of their hull. A face has its corners in order, counter-clockwise seen from outside.
struct Hull {
  std::vector<WholePoint> points;
  std::vector<WholeLoop> faces;
  std::vector<WholePoint> normals;  ///< outward
};

/// The corners of the points `on` a plane, counter-clockwise about the normal. From each corner it goes on to the point that
/// has all others to its left, and to the farthest one if several are collinear.
WholeLoop wrap(const std::vector<WholePoint>& points, const WholeLoop& on, const WholePoint& normal) {
  const auto lowest = [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; };
  WholeLoop loop{*std::ranges::min_element(on, lowest)};
  do {
    const WholePoint& corner = points[loop.back()];
    std::uint32_t next = loop.back();
    for (const std::uint32_t i : on) {
      const WholePoint to_i = minus(points[i], corner), to_next = minus(points[next], corner);
      const Whole turn = dot(normal, cross(to_next, to_i));
      if (turn < 0 || (turn == 0 && dot(to_i, to_i) > dot(to_next, to_next))) next = i;
    }
    loop.push_back(next);
  } while (points[loop.back()] != points[loop.front()]);
  loop.pop_back();
  return loop;
}

Hull hull_of(std::vector<WholePoint> points) {
  Hull hull{std::move(points), {}, {}};
  std::set<WholeLoop> seen;
  const auto count = static_cast<std::uint32_t>(hull.points.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = 0; j < count; ++j) {
      for (std::uint32_t k = 0; k < j; ++k) {
        const WholePoint& origin = hull.points[i];
        const WholePoint normal = cross(minus(hull.points[j], origin), minus(hull.points[k], origin));
        WholeLoop on;
        Whole highest = 0, lowest = 0;
        for (std::uint32_t p = 0; p < count; ++p) {
          const Whole height = dot(normal, minus(hull.points[p], origin));
          highest = std::max(highest, height);
          lowest = std::min(lowest, height);
          if (height == 0) on.push_back(p);
        }
        if (highest > 0 || lowest == 0 || !seen.insert(on).second) continue;
        hull.faces.push_back(wrap(hull.points, on, normal));
        hull.normals.push_back(normal);
      }
    }
  }
  return hull;
}

// ------------------------------------------------------------------------------------------------------- the second way

struct WholeBox {
  WholePoint center;
  std::array<WholePoint, 3> half_edges;
};

struct WholeCase {
  WholePoint view;
  bool at_infinity;
  Hull hull;
  bool is_surface;
  WholeBox box;
};

WholePoint sight(const WholeCase& c, const WholePoint& x) { return c.at_infinity ? c.view : minus(x, c.view); }

bool is_turned(const WholeCase& c, std::size_t f) {
  return dot(c.hull.normals[f], sight(c, c.hull.points[c.hull.faces[f][0]])) < 0;
}

/// The first of the farthest silhouette vertices. The silhouette consists of the edges between a face that is turned to the
/// viewpoint and one that is not.
WholePoint farthest(const WholeCase& c) {
  std::set<std::array<std::uint32_t, 2>> turned_edges, other_edges;
  for (std::size_t f = 0; f < c.hull.faces.size(); ++f) {
    const WholeLoop& loop = c.hull.faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      (is_turned(c, f) ? turned_edges : other_edges).insert({loop[i], loop[(i + 1) % loop.size()]});
    }
  }
  std::set<std::uint32_t> silhouette;  // ascending
  for (const auto& [from, to] : turned_edges) {
    if (other_edges.contains({to, from})) silhouette.insert({from, to});
  }
  const auto remoteness = [&](std::uint32_t i) {
    const WholePoint& v = c.hull.points[i];
    return dot(sight(c, v), c.at_infinity ? v : sight(c, v));
  };
  return c.hull.points[*std::ranges::max_element(silhouette, {}, remoteness)];
}

/// The rows are: the three coordinates of x - V, or of x for a direction; the sum of the weights; for each coordinate u of
/// the box, (u + 1) + slack = 2; and for near `farthest` the height over its plane.
bool share_a_point(const WholeCase& c, const WholeBox& box) {
  const WholePoint zero{}, origin = c.at_infinity ? zero : c.view;
  WholePoint low = minus(box.center, origin);
  for (const WholePoint& h : box.half_edges) low = minus(low, h);

  Equations equations;
  const auto add = [&](const WholePoint& coordinates, Whole sum) -> std::vector<Whole>& {
    equations.columns.push_back({coordinates[0], coordinates[1], coordinates[2], sum, 0, 0, 0, 0});
    return equations.columns.back();
  };
  equations.right = {low[0], low[1], low[2], 1, 2, 2, 2, 0};
  for (const WholePoint& v : c.hull.points) add(minus(v, origin), 1);
  if (c.at_infinity) {
    add(c.view, 0);
    if (!c.is_surface) add(minus(zero, c.view), 0);
  } else {
    add(zero, -1);
    if (!c.is_surface) add(zero, 1);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    add(minus(zero, box.half_edges[k]), 0)[4 + k] = 1;
    add(zero, 0)[4 + k] = 1;
  }
  if (!c.is_surface) {
    const WholePoint p = farthest(c), across = sight(c, p);
    for (std::size_t k = 0; k < 3; ++k)
      equations.columns[equations.columns.size() - 6 + 2 * k][7] = dot(across, box.half_edges[k]);
    add(zero, 0)[7] = -1;
    equations.right[7] = dot(across, minus(minus(p, origin), low));
  }
  return Simplex(equations).is_solvable();
}

Relation second_way(const WholeCase& c) {
  bool all = true;
  for (unsigned i = 0; i < 8 && all; ++i) {
    WholeBox corner{c.box.center, {}};
    for (unsigned k = 0; k < 3; ++k)
      corner.center = plus(corner.center, times((i >> k & 1U) != 0 ? 1 : -1, c.box.half_edges[k]));
    all = share_a_point(c, corner);
  }
  if (all) return kInside;
  return share_a_point(c, c.box) ? kPartial : kOutside;
}

/// Whether the eye is in the hull of the points, that is, a weighted mean of them.
bool is_eye_within(const WholeCase& c) {
  Equations equations{{}, {c.view[0], c.view[1], c.view[2], 1}};
  for (const WholePoint& v : c.hull.points) equations.columns.push_back({v[0], v[1], v[2], 1});
  return Simplex(equations).is_solvable();
}

// -------------------------------------------------------------------------------------------------------------- the cases

std::vector<WholePoint> lattice_points(fuzz::Random& random) {
  std::vector<WholePoint> points;
  const int count = random.integer(4, 9), reach = random.integer(1, 3);
  for (int i = 0; i < count; ++i) points.push_back(whole_point(random, reach));
  return points;
}

/// Two pyramids on one triangle, each at most one unit high. Seen from far away, their faces are almost edge-on.
std::vector<WholePoint> thin_double_pyramid(fuzz::Random& random) {
  const auto rim = [&] { return WholePoint{random.integer(-6, 6), random.integer(-6, 6), 0}; };
  return {rim(), rim(), rim(), {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
}

WholePoint half_edge(fuzz::Random& random) { return random.chance(0.2) ? WholePoint{} : whole_point(random, 2); }

WholeCase whole_case(fuzz::Random& random) {
  WholeCase c{whole_point(random, 5), random.chance(0.25), {}, random.chance(0.5), {}};
  while (c.hull.faces.empty()) c.hull = hull_of(random.chance(0.2) ? thin_double_pyramid(random) : lattice_points(random));
  const auto vertex = [&]() -> const WholePoint& { return c.hull.points[random.index(c.hull.points.size())]; };
  const WholePoint start = c.at_infinity ? vertex() : plus(c.view, sight(c, vertex()));
  c.box.center = plus(start, times(random.integer(0, 5), sight(c, vertex())));
  if (random.chance(0.5)) c.box.center = plus(c.box.center, whole_point(random, 4));
  for (WholePoint& h : c.box.half_edges) h = half_edge(random);
  if (random.chance(0.3)) {
    for (std::size_t k = 0; k < 3; ++k) {
      c.box.half_edges[k] = {};
      c.box.half_edges[k][k] = random.integer(0, 3);
    }
  }
  return c;
}

/// Writes a face in one of the ways in which it may be written: whole or as triangles around a corner, starting at any
/// corner, in either direction, with a vertex twice.
void write_face(std::vector<std::vector<std::uint32_t>>& faces, WholeLoop loop, fuzz::Random& random) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random.index(loop.size())), loop.end());
  if (random.chance(0.5)) std::ranges::reverse(loop);
  if (random.chance(0.3)) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) faces.push_back({loop[0], loop[i], loop[i + 1]});
  } else {
    if (random.chance(0.2)) loop.insert(loop.begin() + 1, loop[0]);
    faces.push_back(loop);
  }
}

Polytope written(const Hull& hull, fuzz::Random& random) {
  Polytope polytope;
  for (const WholePoint& p : hull.points) polytope.vertices.push_back(to_point(p));
  for (const WholeLoop& loop : hull.faces) write_face(polytope.faces, loop, random);
  return polytope;
}

Box written(const WholeBox& box) {
  return Obb{to_point(box.center), {to_point(box.half_edges[0]), to_point(box.half_edges[1]), to_point(box.half_edges[2])}};
}

TEST(Weights, AgreeWithTheOracle) {
  fuzz::Random random(1);
  std::array<std::array<int, 3>, 2> counts{};
  int refused = 0;
  for (int i = 0; i < 8000; ++i) {
    const WholeCase c = whole_case(random);
    const Answer answer = relation({to_point(c.view), c.at_infinity}, written(c.hull, random),
                                   c.is_surface ? kSurface : kFarthest, written(c.box));
    const bool legal = c.at_infinity ? c.view != WholePoint{} : !is_eye_within(c);
    ASSERT_EQ(answer.refusal.empty(), legal) << "case " << i << ": " << answer.refusal;
    if (!legal) {
      ++refused;
      continue;
    }
    ASSERT_EQ(answer.relation, second_way(c)) << "case " << i;
    ++counts[c.is_surface ? 1 : 0][static_cast<std::size_t>(answer.relation)];
  }
  for (const auto& of_near : counts) {
    for (const int count : of_near) EXPECT_GT(count, 200);
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 2000);
}

}  // namespace weights_test
}  // namespace occlude::oracle
