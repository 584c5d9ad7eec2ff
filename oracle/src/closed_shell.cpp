// SPDX-License-Identifier: MIT
// Two compact convex sets are apart if a plane separates them strictly. A triangle without its borders is apart from another
// one if a plane has them on its two sides, and not all of the first in it (Rockafellar, Convex Analysis, 20.2).
//
// The ray goes along x from the middle of the corners, which is moved by (0, e, e^2) with e smaller than any number. So it
// meets no edge, and what it crosses is decided by signs alone. The middle is on no triangle, so it is inside if the moved
// point is.
#include "occlude/oracle/closed_shell.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "feasibility.h"
#include "numbers.h"
#include "occludee.h"
#include "separation.h"

namespace occlude::oracle {
namespace {

bool boxes_meet(const Aabb& a, const Aabb& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.max[k] < b.min[k] || b.max[k] < a.min[k]) return false;
  }
  return true;
}

std::string fault_of_edges(std::span<const Triangle> triangles) {
  std::map<std::array<Point, 2>, bool> is_odd;
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      if (low != high) is_odd[{low, high}] ^= true;
    }
  }
  const bool is_closed = std::ranges::none_of(is_odd, [](const auto& edge) { return edge.second; });
  return is_closed ? "" : "the shell is not closed";
}

/// The sides of the plane of a triangle on which the corners of another lie.
std::array<CGAL::Sign, 3> sides(const Triangle& plane, const Triangle& of) {
  std::array<CGAL::Sign, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = sign_of([&]<class N>() -> N {
      return CGAL::cross_product(difference<N>(plane[0], plane[1]), difference<N>(plane[0], plane[2])) *
             difference<N>(plane[0], of[i]);
    });
  }
  return result;
}

bool are_strictly_aside(const std::array<CGAL::Sign, 3>& sides) {
  return sides[0] != CGAL::ZERO && sides[0] == sides[1] && sides[1] == sides[2];
}

/// Whether none is on one side, and not all are in the plane.
bool are_aside(const std::array<CGAL::Sign, 3>& sides) {
  return (std::ranges::count(sides, CGAL::POSITIVE) == 0) != (std::ranges::count(sides, CGAL::NEGATIVE) == 0);
}

/// Whether no point of one triangle is on the other.
bool are_apart(const Triangle& a, const Triangle& b) {
  if (are_strictly_aside(sides(b, a)) || are_strictly_aside(sides(a, b))) return true;
  return decide([&]<class N>() {
    std::vector<Around<N>> differences;
    for (const Point& p : a) {
      for (const Point& q : b) differences.push_back({difference<N>(p, q), N(0)});
    }
    return separate(differences).exists;
  });
}

/// The same of `a` without its borders. Some corner of it is then strictly on one side.
bool is_apart_without_borders(const Triangle& a, const Triangle& b) {
  if (are_aside(sides(b, a))) return true;
  const auto separates = [&]<class N>(std::size_t strictly) {
    std::vector<Inequality<N, 3>> weak, strict;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Point& q : b) {
        const Vector<N> back = difference<N>(q, a[i]);
        (i == strictly ? strict : weak).push_back({{back.x(), back.y(), back.z()}, N(0)});
      }
    }
    return feasible_point<N>({{N(-1), N(-1), N(-1)}, {N(1), N(1), N(1)}}, weak, strict).has_value();
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (decide([&]<class N>() { return separates.template operator()<N>(i); })) return true;
  }
  return false;
}

/// Three times the vector from `origin` to the middle of the corners.
template <class N>
Vector<N> to_middle(const Point& origin, const Triangle& triangle) {
  return difference<N>(origin, triangle[0]) + difference<N>(origin, triangle[1]) + difference<N>(origin, triangle[2]);
}

/// On which side of the line from u to v, seen along x, the moved middle of the triangle is.
CGAL::Sign turn_of_middle(const Triangle& triangle, const Point& u, const Point& v) {
  const CGAL::Sign sign = sign_of([&]<class N>() -> N {
    const Vector<N> along = difference<N>(u, v), to = to_middle<N>(u, triangle);
    return along.y() * to.z() - along.z() * to.y();
  });
  if (sign != CGAL::ZERO) return sign;
  return u[2] != v[2] ? CGAL::compare(u[2], v[2]) : CGAL::compare(v[1], u[1]);
}

/// Whether the ray from the moved middle of the triangle crosses the other. REQUIRES: the middle is not on that.
bool crosses(const Triangle& triangle, const Triangle& other) {
  const CGAL::Sign turn = turn_of_middle(triangle, other[0], other[1]);
  if (turn == CGAL::ZERO || turn_of_middle(triangle, other[1], other[2]) != turn ||
      turn_of_middle(triangle, other[2], other[0]) != turn) {
    return false;
  }
  const CGAL::Sign side = sign_of([&]<class N>() -> N {
    return CGAL::cross_product(difference<N>(other[0], other[1]), difference<N>(other[0], other[2])) *
           to_middle<N>(other[0], triangle);
  });
  return side == -turn;
}

}  // namespace

/// The triangles in a tree of boxes.
struct ClosedShell::Prepared {
  struct Node {
    Aabb box;
    std::size_t first, count, right;  ///< a leaf has right = 0; the left child follows its parent
  };

  std::string fault;
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;

  /// Adds the node of triangles [first, first + count).
  void add_node(std::size_t first, std::size_t count) {
    constexpr std::size_t kOfLeaf = 4;
    const std::span part = std::span(triangles).subspan(first, count);
    std::vector<Point> corners;
    for (const Triangle& triangle : part) corners.insert(corners.end(), triangle.begin(), triangle.end());
    const Aabb box = bounding_box(corners);
    const std::size_t node = nodes.size();
    nodes.push_back({box, first, count, 0});
    if (count <= kOfLeaf) return;
    const auto length = [&](std::size_t k) { return box.max[k] - box.min[k]; };
    const std::size_t axis = length(0) >= length(1) && length(0) >= length(2) ? 0 : length(1) >= length(2) ? 1 : 2;
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::ranges::nth_element(part, middle, {}, [&](const Triangle& triangle) { return bounding_box(triangle).min[axis]; });
    add_node(first, count / 2);
    nodes[node].right = nodes.size();
    add_node(first + count / 2, count - count / 2);
  }

  /// Calls visit(triangle) for those whose node meets the box, until it returns false.
  template <class Visit>
  void visit_near(const Aabb& box, const Visit& visit) const {
    std::vector<std::size_t> waiting;
    if (!nodes.empty()) waiting.push_back(0);
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      const Node& node = nodes[i];
      waiting.pop_back();
      if (!boxes_meet(node.box, box)) continue;
      if (node.right != 0) {
        waiting.push_back(node.right);
        waiting.push_back(i + 1);
        continue;
      }
      for (const Triangle& triangle : std::span(triangles).subspan(node.first, node.count)) {
        if (!visit(triangle)) return;
      }
    }
  }
};

ClosedShell::ClosedShell(std::span<const Triangle> triangles) {
  auto prepared = std::make_unique<Prepared>();
  prepared->fault = fault_of_edges(triangles);
  prepared->triangles.assign(triangles.begin(), triangles.end());
  if (!triangles.empty()) prepared->add_node(0, triangles.size());
  prepared_ = std::move(prepared);
}

ClosedShell::~ClosedShell() = default;
ClosedShell::ClosedShell(ClosedShell&& other) noexcept = default;
ClosedShell& ClosedShell::operator=(ClosedShell&& other) noexcept = default;

const std::string& ClosedShell::fault() const { return prepared_->fault; }

std::string ClosedShell::refute_inside(const Triangle& triangle, bool may_touch) const {
  const RoundUpward rounding;
  const Aabb box = bounding_box(triangle);
  Aabb ray = box;
  ray.max[0] = std::numeric_limits<double>::infinity();
  bool is_odd = false, is_met = false;
  prepared_->visit_near(ray, [&](const Triangle& other) {
    is_met = boxes_meet(box, bounding_box(other)) &&
             !(may_touch ? is_apart_without_borders(triangle, other) : are_apart(triangle, other));
    is_odd ^= !is_met && crosses(triangle, other);
    return !is_met;
  });
  return is_met ? "the shell meets it" : is_odd ? "" : "it is outside of the shell";
}

}  // namespace occlude::oracle
