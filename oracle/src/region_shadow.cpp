// SPDX-License-Identifier: MIT
// The umbra is the intersection of the shadows from all corners of the region, and each of these has the planes that its
// definition states. The penumbra is bounded by the planes that have the occluder on one side and the region on the other
// and touch both, and by faces that have all of the region before them. All planes through corners and points are tried, and
// none is left out because another is tighter.
#include "occlude/oracle/region_shadow.h"

#include <algorithm>

#include "faults.h"
#include "loop.h"
#include "polytope.h"
#include "prepared.h"
#include "relate.h"

namespace occlude::oracle {
namespace {

constexpr std::array<Point, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The sign of a half-space at corner `c` of the region; for a direction of view, at the eye at infinity from which it
/// comes.
template <class Definition>
CGAL::Sign side_of_corner(const Definition& definition, const ViewRegion& region, std::size_t c) {
  return sign_of([&]<class N>() -> N {
    const HalfSpace<N> half_space = definition.template operator()<N>();
    const Vector<N> corner = corners_of<N>(region.box)[c];
    return region.at_infinity ? N(-(half_space.normal * corner)) : half_space.height(corner);
  });
}

/// What the planes are made of. A polygon has two faces.
struct Body {
  std::vector<OrientedPlane> faces;
  std::vector<Point> points;
};

class PlaneMaker {
 public:
  PlaneMaker(const ViewRegion& region, const Body& body, bool is_loop)
      : region_(region), body_(body), is_loop_(is_loop), corners_(corners_of<Interval>(region.box).size()) {}

  void make(ShadowKind kind, std::vector<Plane<OrientedPlane>>& near, std::vector<Plane<OrientedPlane>>& sides) {
    near_ = &near;
    sides_ = &sides;
    for (const OrientedPlane& face : body_.faces) {
      const auto [least, greatest] = std::ranges::minmax(sides_of_corners(face));
      const bool is_near = (kind == ShadowKind::umbra ? least : greatest) == CGAL::NEGATIVE;
      if (is_near) near.emplace_back(face);
      if (!is_near && kind == ShadowKind::penumbra && greatest == CGAL::ZERO) sides.emplace_back(face);
    }
    for (unsigned c = 0; c < corners_; ++c) {
      for (std::size_t i = 0; i < body_.points.size(); ++i) {
        add_through(c, i, kind);
        for (unsigned d = 0; d < c && kind == ShadowKind::penumbra; ++d) add({region_, {c, d}, {body_.points[i]}}, kind);
      }
    }
  }

 private:
  std::vector<CGAL::Sign> sides_of_corners(const OrientedPlane& plane) const {
    std::vector<CGAL::Sign> sides;
    for (unsigned c = 0; c < corners_; ++c) sides.push_back(side_of_corner(plane, region_, c));
    return sides;
  }

  /// Through corner c, point i, and the next point of a loop, or each point of a polytope before it.
  void add_through(unsigned c, std::size_t i, ShadowKind kind) {
    const std::vector<Point>& points = body_.points;
    if (is_loop_) return add({region_, {c}, {points[i], points[(i + 1) % points.size()]}}, kind);
    for (std::size_t j = 0; j < i; ++j) add({region_, {c}, {points[i], points[j]}}, kind);
  }

  /// Adds the plane if the occluder touches it from one side, and, for a penumbra, the region from the other.
  void add(const RegionPlane& plane, ShadowKind kind) {
    const CGAL::Sign interior = side_of_all(plane, body_.points);
    if (interior == CGAL::ZERO) return;
    const OrientedPlane oriented{plane, interior};
    if (kind == ShadowKind::penumbra && std::ranges::max(sides_of_corners(oriented)) == CGAL::POSITIVE) return;
    sides_->emplace_back(oriented);
  }

  const ViewRegion& region_;
  const Body& body_;
  bool is_loop_;
  std::size_t corners_;
  std::vector<Plane<OrientedPlane>>* near_ = nullptr;
  std::vector<Plane<OrientedPlane>>* sides_ = nullptr;
};

/// The fault of a loop that is seen along an axis along which it is not seen edge-on.
std::string shape_fault(const Loop& loop) {
  for (const Point& axis : kAxes) {
    const Viewpoint view{axis, true};
    if (turn_along(axis, loop) == CGAL::ZERO) continue;
    std::string fault = see(view, loop).fault;
    return !fault.empty() || is_coplanar(loop) ? fault : "the vertices are not coplanar";
  }
  return "the vertices are on one line";
}

std::string fill(Body& body, const Loop& loop, const ViewRegion& region) {
  if (std::string fault = shape_fault(loop); !fault.empty()) return fault;
  const OrientedPlane plane{LoopPlane{loop}};
  std::vector<CGAL::Sign> sides;
  for (std::size_t c = 0; c < corners_of<Interval>(region.box).size(); ++c) {
    sides.push_back(side_of_corner(plane, region, c));
  }
  const auto [least, greatest] = std::ranges::minmax(sides);
  if (least != greatest || least == CGAL::ZERO) return "the region meets the polygon's plane";
  body = {{plane, {LoopPlane{loop}, CGAL::NEGATIVE}}, loop};
  return "";
}

std::string fill(Body& body, const Polytope& polytope, const ViewRegion& region) {
  auto [solid, fault] = solid_of(polytope);
  if (!fault.empty()) return fault;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) body.faces.push_back(solid.half_space(f));
  body.points = std::move(solid.points);
  if (region.at_infinity) return contains(region.box, {}) ? "the region of directions contains zero" : "";
  std::vector<Plane<OrientedPlane>> faces(body.faces.begin(), body.faces.end());
  Planes planes;
  append(planes, faces);
  return relate(planes, region.box) == Relation::outside ? "" : "the region meets the polytope";
}

}  // namespace

/// The planes of the shadow, or its fault.
struct PreparedRegionShadow {
  std::string fault;
  std::vector<Plane<OrientedPlane>> near{}, sides{};

  PreparedRegionShadow(const ViewRegion& region, const Occluder& occluder, ShadowKind kind)
      : fault(range_fault(vertices_of(occluder))) {
    if (fault.empty()) fault = strict_box_fault(region.box);
    if (!fault.empty()) return;
    Body body;
    const Loop* loop = std::get_if<Loop>(&occluder);
    fault = loop ? fill(body, *loop, region) : fill(body, std::get<Polytope>(occluder), region);
    if (fault.empty()) PlaneMaker(region, body, loop != nullptr).make(kind, near, sides);
  }
};

RegionShadow::RegionShadow(const ViewRegion& region, const Occluder& occluder, ShadowKind kind) {
  const RoundUpward rounding;
  prepared_ = std::make_unique<PreparedRegionShadow>(region, occluder, kind);
}

RegionShadow::~RegionShadow() = default;
RegionShadow::RegionShadow(RegionShadow&& other) noexcept = default;
RegionShadow& RegionShadow::operator=(RegionShadow&& other) noexcept = default;

const std::string& RegionShadow::refusal() const { return prepared_->fault; }

Answer RegionShadow::relation(const Box& box) {
  const RoundUpward rounding;
  if (!prepared_->fault.empty()) return {prepared_->fault, Relation::partial};
  if (std::string fault = strict_box_fault(box); !fault.empty()) return {std::move(fault), Relation::partial};
  Planes planes;
  append(planes, prepared_->near);
  append(planes, prepared_->sides);
  return {"", relate(planes, box)};
}

bool RegionShadow::reaches_surface(const Box& box) {
  const RoundUpward rounding;
  return !std::ranges::all_of(prepared_->near, [&](Plane<OrientedPlane>& plane) {
    return std::ranges::all_of(corner_sides(plane, box), [](CGAL::Sign side) { return side == CGAL::POSITIVE; });
  });
}

}  // namespace occlude::oracle
