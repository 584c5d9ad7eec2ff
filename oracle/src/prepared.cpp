// SPDX-License-Identifier: MIT
#include "prepared.h"

#include "faults.h"

namespace occlude::oracle {

Prepared::Prepared(const Viewpoint& view, const Occluder& occluder, const Near& near)
    : number_fault(oracle::number_fault(view, vertices_of(occluder))) {
  if (!number_fault.empty()) return;
  shape_fault = setting_fault(view, near);
  if (!shape_fault.empty()) return;
  FrustumOrFault made = std::visit([&](const auto& kind) { return frustum_of(view, kind, near); }, occluder);
  frustum = std::move(made.frustum);
  shape_fault = std::move(made.fault);
}

std::string Prepared::fault(const Box& box) const {
  if (!number_fault.empty()) return number_fault;
  std::string fault = strict_box_fault(box);
  return fault.empty() ? shape_fault : fault;
}

Planes Prepared::planes() {
  Planes planes;
  append(planes, frustum.sides);
  append(planes, frustum.near);
  return planes;
}

const std::vector<Point>& vertices_of(const Occluder& occluder) {
  if (const Loop* loop = std::get_if<Loop>(&occluder)) return *loop;
  return std::get<Polytope>(occluder).vertices;
}

}  // namespace occlude::oracle
