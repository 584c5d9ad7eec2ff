// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "faults.h"
#include "occlude/oracle/questions.h"
#include "relate.h"

namespace occlude::oracle {
namespace {

bool has_finite_coefficients(const HalfSpaceCoefficients& coefficients) {
  return std::ranges::all_of(coefficients, [](double value) { return std::isfinite(value); });
}

}  // namespace

Answer relation_to_half_spaces(std::span<const HalfSpaceCoefficients> half_spaces, const Box& box) {
  const RoundUpward rounding;
  if (!std::ranges::all_of(half_spaces, has_finite_coefficients)) return {"a number is not finite", Relation::partial};
  if (std::string fault = strict_box_fault(box); !fault.empty()) return {std::move(fault), Relation::partial};
  std::vector<Plane<OrientedPlane>> given;
  for (const HalfSpaceCoefficients& coefficients : half_spaces) {
    given.emplace_back(OrientedPlane{CoefficientPlane{coefficients}});
  }
  Planes planes;
  append(planes, given);
  return {"", relate(planes, box)};
}

}  // namespace occlude::oracle
