// SPDX-License-Identifier: MIT
#include <algorithm>

#include "faults.h"
#include "occlude/oracle/oracle.h"
#include "occludee.h"
#include "prepared.h"
#include "union.h"

namespace occlude::oracle {
namespace {

bool is_strictly_inside(Plane<OrientedPlane>& plane, const Box& box) {
  return std::ranges::all_of(corner_sides(plane, box), [](CGAL::Sign side) { return side == CGAL::POSITIVE; });
}

/// The frustum without the points on its near planes.
ConvexSet beyond_near(Frustum& frustum) {
  ConvexSet set;
  append(set.closed, frustum.sides);
  append(set.open, frustum.near);
  return set;
}

}  // namespace

Shadow::Shadow(const Viewpoint& view, const Occluder& occluder, const Near& near) {
  const RoundUpward rounding;
  prepared_ = std::make_unique<Prepared>(view, occluder, near);
}

Shadow::~Shadow() = default;
Shadow::Shadow(Shadow&& other) noexcept = default;
Shadow& Shadow::operator=(Shadow&& other) noexcept = default;

const std::string& Shadow::refusal() const { return prepared_->fault(); }

Answer Shadow::relation(const Box& box) {
  const RoundUpward rounding;
  if (std::string fault = prepared_->fault(box); !fault.empty()) return {std::move(fault), Relation::partial};
  return {"", relate(prepared_->planes(), box)};
}

Answer Shadow::relation(const Polytope& occludee) {
  const RoundUpward rounding;
  if (!refusal().empty()) return {refusal(), Relation::partial};
  if (std::string fault = range_fault(occludee.vertices); !fault.empty()) return {std::move(fault), Relation::partial};
  auto [solid, fault] = solid_of(occludee);
  if (!fault.empty()) return {std::move(fault), Relation::partial};
  return {"", relate(prepared_->planes(), solid)};
}

Answer Shadow::relation_to_union(Shadow& other, const Box& box) {
  const Answer own = relation(box), others = other.relation(box);
  if (!own.refusal.empty()) return own;
  if (!others.refusal.empty()) return others;
  if (own.relation == Relation::outside) return others;
  if (others.relation == Relation::outside) return own;
  const RoundUpward rounding;
  const bool is_covered = cover({prepared_->planes(), {}}, {other.prepared_->planes(), {}}, box);
  return {"", is_covered ? Relation::inside : Relation::partial};
}

std::string Shadow::refute_cull(const Box& box, double margin) {
  const Answer answer = relation(box);
  if (!answer.refusal.empty()) return answer.refusal;
  if (answer.relation != Relation::inside) return "the box is not inside the frustum";
  const RoundUpward rounding;
  const auto is_beyond = [&](Plane<OrientedPlane>& plane) { return is_strictly_inside(plane, box); };
  if (!std::ranges::all_of(prepared_->frustum.near, is_beyond)) return "the box touches the near plane";
  const auto keeps = [&](Plane<OrientedPlane>& plane) { return keeps_distance(plane, box, margin); };
  const bool all_keep =
      std::ranges::all_of(prepared_->frustum.near, keeps) && std::ranges::all_of(prepared_->frustum.sides, keeps);
  return all_keep ? "" : "the box is nearer to a plane of the shadow than its margin";
}

std::string Shadow::refute_union_cull(Shadow& other, const Box& box) {
  const Answer answer = relation_to_union(other, box);
  if (!answer.refusal.empty()) return answer.refusal;
  if (answer.relation != Relation::inside) return "the box is not inside the union of the frusta";
  const RoundUpward rounding;
  const bool is_beyond = cover(beyond_near(prepared_->frustum), beyond_near(other.prepared_->frustum), box);
  return is_beyond ? "" : "the box touches a near plane where the other shadow does not hide it";
}

Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  return Shadow(view, occluder, near).relation(box);
}

std::string refute_shadow_cull(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box) {
  return Shadow(view, occluder, near).refute_cull(box);
}

}  // namespace occlude::oracle
