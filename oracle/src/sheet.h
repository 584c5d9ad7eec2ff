// SPDX-License-Identifier: MIT
// What a sheet derives from its polygons.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "occlude/oracle/region.h"
#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

struct Sheet::Prepared {
  std::vector<Loop> polygons;
  std::optional<HalfSpaceCoefficients> drawn;
  std::string fault;                         ///< why there is no sheet. Empty when there is one
  std::vector<Triangle> triangles;           ///< those that are partly drawn
  std::vector<std::array<Point, 2>> border;  ///< edges of which a part is drawn or touches what is
  std::vector<Triangle> cut;                 ///< their points on the plane of `drawn` are border
};

}  // namespace occlude::oracle
