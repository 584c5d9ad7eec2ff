// SPDX-License-Identifier: MIT
// Points and predicates of CGAL's exact kernel, and the translation from the oracle's types.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <vector>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle::second {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_3;
using ExactVector = Kernel::Vector_3;

inline ExactPoint exact(const Point& p) { return {p[0], p[1], p[2]}; }
inline ExactVector from_origin(const Point& p) { return {p[0], p[1], p[2]}; }

/// The vertices of a polygon or of a polytope.
inline const std::vector<Point>& vertices_of(const Occluder& occluder) {
  if (const Loop* loop = std::get_if<Loop>(&occluder)) return *loop;
  return std::get<Polytope>(occluder).vertices;
}

}  // namespace occlude::oracle::second
