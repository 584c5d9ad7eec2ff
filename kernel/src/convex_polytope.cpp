// SPDX-License-Identifier: MIT
#include "occlude/kernel/convex_polytope.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "plane_coefficients.h"
#include "scratch.h"
#include "silhouette.h"

namespace occlude::kernel {
namespace {

using Index = std::uint32_t;
using Loop = std::vector<Index>;

/// For every vertex, the index of the first vertex at the same place.
std::vector<Index> first_at_same_place(std::span<const Vec3> vertices) {
  std::vector<Index> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return precedes(vertices[a], vertices[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

ExactPlane plane_through(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {.direct = false, .a_to = b, .a_from = a, .b_to = c, .b_from = a, .origin = a};
}

bool are_in_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  return certified([&]<class A>(A& arithmetic) {
    const auto n = normal<A>(plane_through(a, b, c));
    return arithmetic.sign(n.x) == 0 && arithmetic.sign(n.y) == 0 && arithmetic.sign(n.z) == 0;
  });
}

/// Three vertices of the loop that span its plane, or nothing when the loop has no area.
std::optional<std::array<Index, 3>> spanning_corners(std::span<const Vec3> v, const Loop& loop) {
  for (std::size_t i = 1; i < loop.size(); ++i) {
    if (loop[i] == loop[0]) continue;
    for (std::size_t j = i + 1; j < loop.size(); ++j) {
      if (!are_in_line(v[loop[0]], v[loop[i]], v[loop[j]])) return std::array{loop[0], loop[i], loop[j]};
    }
    return std::nullopt;
  }
  return std::nullopt;
}

/// A face with area. After turn_outwards() its spanning corners run counter-clockwise seen from outside.
struct Side {
  std::array<Index, 3> corners;
  Loop loop;
};

ExactPlane outer_plane(std::span<const Vec3> v, const std::array<Index, 3>& corners) {
  return plane_through(v[corners[0]], v[corners[1]], v[corners[2]]);
}

/// A coordinate axis that crosses the plane of the face. Seen along it, the face is convex exactly when it is convex in its
/// own plane.
Vec3 crossing_axis(std::span<const Vec3> v, const Side& side) {
  const auto crosses = [&](int axis) {
    return certified(
               [&]<class A>(A& arithmetic) { return arithmetic.sign(normal<A>(outer_plane(v, side.corners))[axis]); }) != 0;
  };
  return crosses(0) ? Vec3{1, 0, 0} : crosses(1) ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

bool is_convex(std::span<const Vec3> v, const Side& side) {
  Scratch scratch;
  std::pmr::vector<Vec3> loop(&scratch.memory());
  for (const Index i : side.loop) loop.push_back(v[i]);
  return silhouette(Viewpoint::direction(crossing_axis(v, side)), loop, scratch.memory()).refusal == Refusal::none;
}

/// Turns the face so that all vertices lie on the inner side of its plane. Returns false when that is impossible, when all
/// vertices lie on the plane, or when the face is not planar.
bool turn_outwards(std::span<const Vec3> v, Side& side) {
  const ExactPlane plane = outer_plane(v, side.corners);
  bool above = false, below = false;
  for (const Vec3& vertex : v) {
    const int sign = sign_at(plane, vertex);
    above = above || sign > 0;
    below = below || sign < 0;
  }
  if (above == below) return false;
  if (above) std::swap(side.corners[1], side.corners[2]);
  return std::all_of(side.loop.begin(), side.loop.end(), [&](Index i) { return sign_at(plane, v[i]) == 0; });
}

bool is_between(const Vec3& a, const Vec3& x, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (x[axis] < std::min(a[axis], b[axis]) || x[axis] > std::max(a[axis], b[axis])) return false;
  }
  return x != a && x != b && are_in_line(a, b, x);
}

/// The ends of the pieces into which vertices of other faces divide an edge, in order.
Loop divide(std::span<const Vec3> v, std::span<const Index> used, Index from, Index to) {
  Loop pieces{from, to};
  for (const Index i : used) {
    if (is_between(v[from], v[i], v[to])) pieces.push_back(i);
  }
  const bool ascending = precedes(v[from], v[to]);
  std::sort(pieces.begin(), pieces.end(),
            [&](Index a, Index b) { return ascending ? precedes(v[a], v[b]) : precedes(v[b], v[a]); });
  return pieces;
}

/// The faces at every piece of an edge.
using Border = std::map<std::pair<Index, Index>, std::vector<Index>>;

Border border_of(std::span<const Vec3> v, const std::vector<Side>& sides) {
  Loop used;
  for (const Side& side : sides) used.insert(used.end(), side.loop.begin(), side.loop.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  Border border;
  for (Index face = 0; face < sides.size(); ++face) {
    const Loop& loop = sides[face].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index from = loop[i], to = loop[(i + 1) % loop.size()];
      if (from == to) continue;
      const Loop pieces = divide(v, used, from, to);
      for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
        border[std::minmax(pieces[k], pieces[k + 1])].push_back(face);
      }
    }
  }
  return border;
}

/// Groups of faces: coplanar neighbours are joined into one.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  Index of(Index face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }
  void join(Index a, Index b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<Index> parent_;
};

/// Whether two coplanar faces that share an edge lie on the same side of it.
bool overlap(std::span<const Vec3> v, const std::pair<Index, Index>& edge, const Side& a, const Side& b) {
  const ExactPlane across = side_plane(Viewpoint::direction(crossing_axis(v, a)), v[edge.first], v[edge.second]);
  const auto is_on_inner_side = [&](const Side& face) {
    return std::any_of(face.loop.begin(), face.loop.end(), [&](Index i) { return sign_at(across, v[i]) > 0; });
  };
  return is_on_inner_side(a) == is_on_inner_side(b);
}

bool are_coplanar(std::span<const Vec3> v, const Side& a, const Side& b) {
  const ExactPlane plane = outer_plane(v, a.corners);
  return std::all_of(b.corners.begin(), b.corners.end(), [&](Index i) { return sign_at(plane, v[i]) == 0; });
}

/// Whether the edge from -> to runs counter-clockwise round `left`, seen from outside.
bool has_on_left(std::span<const Vec3> v, Index from, Index to, const Side& left, const Side& right) {
  return certified([&]<class A>(A& arithmetic) {
    const auto along = cross(normal<A>(outer_plane(v, left.corners)), normal<A>(outer_plane(v, right.corners)));
    return arithmetic.sign(dot(along, difference<A>(v[to], v[from]))) > 0;
  });
}

}  // namespace

ConvexPolytopeResult ConvexPolytope::make(const Polytope& polytope) {
  const auto refuse = [](Refusal refusal) { return ConvexPolytopeResult{std::nullopt, refusal}; };
  const std::vector<Vec3>& v = polytope.vertices;
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refuse(refusal);
  if (const Refusal refusal = check(v); refusal != Refusal::none) return refuse(refusal);
  const std::vector<Index> first = first_at_same_place(v);
  std::vector<Side> sides;
  std::vector<Index> distinct;
  for (const Loop& face : polytope.faces) {
    Loop loop;
    for (const Index i : face) {
      if (i >= v.size()) return refuse(Refusal::bad_face_index);
      loop.push_back(first[i]);
    }
    distinct.insert(distinct.end(), loop.begin(), loop.end());
    if (const auto corners = spanning_corners(v, loop)) sides.push_back({*corners, std::move(loop)});
  }
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 3) return refuse(Refusal::too_few_vertices);
  for (Side& side : sides) {
    if (!turn_outwards(v, side) || !is_convex(v, side)) return refuse(Refusal::polytope_not_convex);
  }

  const Border border = border_of(v, sides);
  Groups groups(sides.size());
  for (const auto& [edge, faces] : border) {
    if (faces.size() != 2) return refuse(Refusal::polytope_not_closed);
    const Side &a = sides[faces[0]], &b = sides[faces[1]];
    if (!are_coplanar(v, a, b)) continue;
    if (overlap(v, edge, a, b)) return refuse(Refusal::polytope_not_closed);
    groups.join(faces[0], faces[1]);
  }

  ConvexPolytope result;
  result.vertices_ = v;
  std::vector<Index> number(sides.size());
  for (Index face = 0; face < sides.size(); ++face) {
    if (groups.of(face) != face) continue;
    number[face] = static_cast<Index>(result.faces_.size());
    result.faces_.push_back({sides[face].corners});
  }
  for (const auto& [edge, faces] : border) {
    const Index a = groups.of(faces[0]), b = groups.of(faces[1]);
    if (a == b) continue;
    const bool a_is_left = has_on_left(v, edge.first, edge.second, sides[a], sides[b]);
    result.edges_.push_back({edge.first, edge.second, number[a_is_left ? a : b], number[a_is_left ? b : a]});
  }
  // With at least one edge between two planes the faces cover the whole hull: the hull is a sphere, and the faces have no
  // border on it.
  if (result.edges_.empty()) return refuse(Refusal::polytope_not_closed);
  return {std::move(result), Refusal::none};
}

}  // namespace occlude::kernel
