// SPDX-License-Identifier: MIT
#include "polytope.h"

#include <algorithm>
#include <map>

#include "loop.h"

namespace occlude::oracle {
namespace {

bool names_vertices(const Polytope& polytope) {
  return std::ranges::all_of(polytope.faces, [&](const auto& face) {
    return std::ranges::all_of(face, [&](std::uint32_t index) { return index < polytope.vertices.size(); });
  });
}

std::vector<Point> distinct(std::vector<Point> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The turn of the loop, seen along the first axis that is not in its plane. ZERO for a loop without area. Empty for a loop
/// that is not convex.
std::optional<CGAL::Sign> turn_along_an_axis(const Loop& loop) {
  for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) {
    const std::optional<CGAL::Sign> turn = turn_along(axis, loop);
    if (turn != CGAL::ZERO) return turn;
  }
  return CGAL::ZERO;
}

/// Collects the faces that have an area. Returns a fault, or an empty string.
std::string take_faces(const Polytope& polytope, std::vector<Loop>& faces) {
  for (const auto& indices : polytope.faces) {
    Loop loop;
    for (const std::uint32_t index : indices) loop.push_back(polytope.vertices[index]);
    const std::optional<CGAL::Sign> turn = turn_along_an_axis(loop);
    if (turn == CGAL::ZERO) continue;
    if (!turn || !is_coplanar(loop)) return "a face is not plane and convex";
    faces.push_back(std::move(loop));
  }
  return "";
}

bool are_in_line(const Point& a, const Point& b, const Point& c) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto area = [&]<class N>() { return N(CGAL::cross_product(difference<N>(a, b), difference<N>(a, c))[axis]); };
    if (sign_of(area) != CGAL::ZERO) return false;
  }
  return true;
}

/// A piece of an edge with no vertex between its ends, the end that is lexicographically lower first.
using Piece = std::array<Point, 2>;

/// For each piece, the faces that have it on an edge.
using FacesOfPieces = std::map<Piece, std::vector<std::size_t>>;

/// Cuts the edge at every point on it. In lexicographic order, points on one line are in their order along it.
std::vector<Piece> pieces_of(const Point& from, const Point& to, const std::vector<Point>& points) {
  const auto [low, high] = std::minmax(from, to);
  std::vector<Piece> pieces;
  Point last = low;
  for (auto p = std::ranges::upper_bound(points, low); p != points.end() && *p <= high; ++p) {
    if (*p != high && !are_in_line(low, high, *p)) continue;
    pieces.push_back({last, *p});
    last = *p;
  }
  return pieces;
}

FacesOfPieces faces_of_pieces(const Solid& solid) {
  FacesOfPieces result;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const Loop& loop = solid.faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      for (const Piece& piece : pieces_of(loop[i], loop[(i + 1) % loop.size()], solid.points)) result[piece].push_back(f);
    }
  }
  return result;
}

bool is_closed(const FacesOfPieces& pieces) {
  return !pieces.empty() && std::ranges::all_of(pieces, [](const auto& piece) { return piece.second.size() == 2; });
}

/// Whether two faces that share the piece lie in one plane and on the same side of the piece.
bool are_folded(const Piece& piece, const Loop& f, const Loop& g) {
  Plane plane(LoopPlane{f});
  if (!std::ranges::all_of(g, [&](const Point& vertex) { return plane.side(vertex) == CGAL::ZERO; })) return false;
  const auto is_off = [&](const Point& vertex) { return !are_in_line(piece[0], piece[1], vertex); };
  const Point &p = *std::ranges::find_if(f, is_off), &q = *std::ranges::find_if(g, is_off);
  const auto same_side = [&]<class N>() {
    const Vector<N> along = difference<N>(piece[0], piece[1]);
    return N(CGAL::cross_product(along, difference<N>(piece[0], p)) *
             CGAL::cross_product(along, difference<N>(piece[0], q)));
  };
  return sign_of(same_side) == CGAL::POSITIVE;
}

}  // namespace

SolidOrFault solid_of(const Polytope& polytope) {
  if (!names_vertices(polytope)) return {{}, "a face names a vertex that does not exist"};
  Solid solid{distinct(polytope.vertices), {}, {}};
  if (std::string fault = take_faces(polytope, solid.faces); !fault.empty()) return {{}, std::move(fault)};
  const FacesOfPieces pieces = faces_of_pieces(solid);
  if (!is_closed(pieces)) return {{}, "the polytope is not closed"};
  for (const Loop& loop : solid.faces) {
    solid.interior.push_back(side_of_all(LoopPlane{loop}, solid.points));
    if (solid.interior.back() == CGAL::ZERO) return {{}, "the polytope is flat or not convex"};
  }
  for (const auto& [piece, faces] : pieces) {
    if (are_folded(piece, solid.faces[faces[0]], solid.faces[faces[1]])) return {{}, "two faces of the polytope overlap"};
  }
  return {std::move(solid), ""};
}

}  // namespace occlude::oracle
