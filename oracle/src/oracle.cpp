// SPDX-License-Identifier: MIT
#include "occlude/oracle/oracle.h"

#include <algorithm>
#include <cmath>

#include "box.h"
#include "faults.h"
#include "frustum.h"

namespace occlude::oracle {
namespace {

/// For one plane, bit c set when corner c of the box is strictly outside.
unsigned outer_corners(Plane<OrientedPlane>& plane, const Box& box) {
  unsigned outer = 0;
  for (unsigned c = 0; c < kCorners; ++c) {
    if (plane.side(Corner{box, c}) == CGAL::NEGATIVE) outer |= 1U << c;
  }
  return outer;
}

bool is_strictly_inside(Plane<OrientedPlane>& plane, const Box& box) {
  for (unsigned c = 0; c < kCorners; ++c) {
    if (plane.side(Corner{box, c}) != CGAL::POSITIVE) return false;
  }
  return true;
}

std::vector<Plane<OrientedPlane>*> planes_of(Frustum& frustum) {
  std::vector<Plane<OrientedPlane>*> planes;
  for (auto* part : {&frustum.sides, &frustum.near}) {
    for (Plane<OrientedPlane>& plane : *part) planes.push_back(&plane);
  }
  return planes;
}

Relation relate(Frustum& frustum, const Box& box) {
  constexpr unsigned kAllCorners = (1U << kCorners) - 1;
  std::vector<Plane<OrientedPlane>*> crossing;  // the planes that some of the box is outside of
  unsigned outer_of_any = 0;
  for (Plane<OrientedPlane>* plane : planes_of(frustum)) {
    const unsigned outer = outer_corners(*plane, box);
    if (outer == kAllCorners) return Relation::outside;
    if (outer != 0) crossing.push_back(plane);
    outer_of_any |= outer;
  }
  if (crossing.empty()) return Relation::inside;
  if (outer_of_any != kAllCorners) return Relation::partial;  // some corner is in F
  std::vector<Inequality<3>> inequalities;
  for (Plane<OrientedPlane>* plane : crossing) inequalities.push_back(in_own_coordinates(plane->exact(), box));
  return is_feasible(own_bounds(box), std::move(inequalities)) ? Relation::partial : Relation::outside;
}

const Loop& vertices_of(const Loop& loop) { return loop; }
const Loop& vertices_of(const Polytope& polytope) { return polytope.vertices; }

/// The frustum of the question, or what makes it unanswerable.
FrustumOrFault examine(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  const auto& vertices = std::visit([](const auto& kind) -> const Loop& { return vertices_of(kind); }, occluder);
  std::string fault = number_fault(view, vertices, near, box);
  if (fault.empty()) fault = view_fault(view);
  if (!fault.empty()) return {{}, std::move(fault)};
  return std::visit([&](const auto& kind) { return frustum_of(view, kind, near); }, occluder);
}

}  // namespace

Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  const RoundUpward rounding;
  auto [frustum, fault] = examine(view, occluder, near, box);
  if (!fault.empty()) return {std::move(fault), Relation::partial};
  return {"", relate(frustum, box)};
}

std::string refute_shadow_cull(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  const RoundUpward rounding;
  auto [frustum, fault] = examine(view, occluder, near, box);
  if (!fault.empty()) return std::move(fault);
  for (Plane<OrientedPlane>* plane : planes_of(frustum)) {
    if (outer_corners(*plane, box) != 0) return "the box is not inside the frustum";
  }
  const auto is_beyond = [&](Plane<OrientedPlane>& plane) { return is_strictly_inside(plane, box); };
  return std::ranges::all_of(frustum.near, is_beyond) ? "" : "the box touches the near plane";
}

std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box) {
  const RoundUpward rounding;
  if (!std::ranges::all_of(plane, [](double value) { return std::isfinite(value); })) return "a number is not finite";
  if (std::string fault = box_fault(box); !fault.empty()) return fault;
  const Point normal{plane[0], plane[1], plane[2]};
  for (unsigned c = 0; c < kCorners; ++c) {
    const auto height = [&]<class N>() { return N(vector_of<N>(normal) * vector_of<N>(Corner{box, c}) + N(plane[3])); };
    if (sign_of(height) != CGAL::NEGATIVE) return "the box reaches the plane";
  }
  return "";
}

}  // namespace occlude::oracle
