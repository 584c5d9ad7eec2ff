// SPDX-License-Identifier: MIT
// Short names for what the oracle is asked and answers, and two occluders.
#pragma once

#include <cmath>
#include <limits>
#include <ostream>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

inline void PrintTo(Relation relation, std::ostream* out) {
  *out << (relation == Relation::inside ? "inside" : relation == Relation::partial ? "partial" : "outside");
}

inline constexpr Relation kInside = Relation::inside, kPartial = Relation::partial, kOutside = Relation::outside;
inline constexpr Near kFarthest{}, kSurface{Near::Kind::surface, {}, {}};
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline double above(double value) { return std::nextafter(value, kInfinity); }
inline double below(double value) { return std::nextafter(value, -kInfinity); }

inline constexpr Viewpoint kOrigin{};

// From the origin, with near `surface`: F is |x| <= z, |y| <= z, z >= 1.
inline const Loop kSquare{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};

// From the origin, with near `surface`: F is |x| + |y| <= 2z, z >= 1.
inline const Loop kDiamond{{2, 0, 1}, {0, 2, 1}, {-2, 0, 1}, {0, -2, 1}};

}  // namespace occlude::oracle
