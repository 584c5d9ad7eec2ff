// SPDX-License-Identifier: MIT
#include <algorithm>

#include "box.h"
#include "faults.h"
#include "frustum.h"
#include "occlude/oracle/oracle.h"

namespace occlude::oracle {
namespace {

/// For one plane, bit c set when corner c of the box is strictly outside.
unsigned outer_corners(Plane<OrientedPlane>& plane, const Box& box) {
  const OfCorners<CGAL::Sign> sides = corner_sides(plane, box);
  unsigned outer = 0;
  for (unsigned c = 0; c < kCorners; ++c) {
    if (sides[c] == CGAL::NEGATIVE) outer |= 1U << c;
  }
  return outer;
}

bool is_strictly_inside(Plane<OrientedPlane>& plane, const Box& box) {
  return std::ranges::all_of(corner_sides(plane, box), [](CGAL::Sign side) { return side == CGAL::POSITIVE; });
}

std::vector<Plane<OrientedPlane>*> planes_of(Frustum& frustum) {
  std::vector<Plane<OrientedPlane>*> planes;
  for (auto* part : {&frustum.sides, &frustum.near}) {
    for (Plane<OrientedPlane>& plane : *part) planes.push_back(&plane);
  }
  return planes;
}

/// Whether some point of the box is outside of none of the planes.
bool share_a_point(const std::vector<Plane<OrientedPlane>*>& planes, const Box& box) {
  return decide([&]<class N>() {
    std::vector<Inequality<N, 3>> inequalities;
    for (Plane<OrientedPlane>* plane : planes) inequalities.push_back(in_own_coordinates(plane->in<N>(), box));
    return is_feasible<N>(own_bounds<N>(box), std::move(inequalities));
  });
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
  return share_a_point(crossing, box) ? Relation::partial : Relation::outside;
}

const Loop& vertices_of(const Loop& loop) { return loop; }
const Loop& vertices_of(const Polytope& polytope) { return polytope.vertices; }

}  // namespace

/// The frustum, or its fault. A question's faults have an order, in which those of the box come between these two.
struct Shadow::Prepared {
  std::string number_fault, shape_fault;
  Frustum frustum;

  /// What makes the question about `box` unanswerable.
  [[nodiscard]] std::string fault(const Box& box) const {
    if (!number_fault.empty()) return number_fault;
    std::string fault = strict_box_fault(box);
    return fault.empty() ? shape_fault : fault;
  }
};

Shadow::Shadow(const Viewpoint& view, const Occluder& occluder, const Near& near) : prepared_(std::make_unique<Prepared>()) {
  const RoundUpward rounding;
  const auto& vertices = std::visit([](const auto& kind) -> const Loop& { return vertices_of(kind); }, occluder);
  prepared_->number_fault = number_fault(view, vertices);
  if (!prepared_->number_fault.empty()) return;
  prepared_->shape_fault = setting_fault(view, near);
  if (!prepared_->shape_fault.empty()) return;
  auto [frustum, fault] = std::visit([&](const auto& kind) { return frustum_of(view, kind, near); }, occluder);
  prepared_->frustum = std::move(frustum);
  prepared_->shape_fault = std::move(fault);
}

Shadow::~Shadow() = default;
Shadow::Shadow(Shadow&& other) noexcept = default;
Shadow& Shadow::operator=(Shadow&& other) noexcept = default;

const std::string& Shadow::refusal() const {
  return prepared_->number_fault.empty() ? prepared_->shape_fault : prepared_->number_fault;
}

Answer Shadow::relation(const Box& box) {
  const RoundUpward rounding;
  if (std::string fault = prepared_->fault(box); !fault.empty()) return {std::move(fault), Relation::partial};
  return {"", relate(prepared_->frustum, box)};
}

std::string Shadow::refute_cull(const Box& box) {
  const RoundUpward rounding;
  if (std::string fault = prepared_->fault(box); !fault.empty()) return fault;
  Frustum& frustum = prepared_->frustum;
  for (Plane<OrientedPlane>* plane : planes_of(frustum)) {
    if (outer_corners(*plane, box) != 0) return "the box is not inside the frustum";
  }
  const auto is_beyond = [&](Plane<OrientedPlane>& plane) { return is_strictly_inside(plane, box); };
  return std::ranges::all_of(frustum.near, is_beyond) ? "" : "the box touches the near plane";
}

Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  return Shadow(view, occluder, near).relation(box);
}

std::string refute_shadow_cull(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  return Shadow(view, occluder, near).refute_cull(box);
}

}  // namespace occlude::oracle
