// SPDX-License-Identifier: MIT
#include "occlude/fuzz/neighbours.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <variant>

#include "occlude/fuzz/random.h"
#include "vector_math.h"

namespace occlude::fuzz {
namespace {

/// The largest power of two of which all the numbers are multiples. 0 when all are zero.
double common_unit(std::initializer_list<Vec3> vectors) {
  double unit = 0;
  for (const Vec3& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) {
      if (v[axis] == 0) continue;
      int exponent = 0;
      const double mantissa = std::frexp(v[axis], &exponent);
      const auto digits = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
      const double lowest = std::ldexp(static_cast<double>(digits & -digits), exponent - 53);
      unit = unit == 0 ? lowest : std::min(unit, lowest);
    }
  }
  return unit;
}

double next(Random& random, double x) { return x == 0 ? x : std::nextafter(x, random.chance(0.5) ? HUGE_VAL : -HUGE_VAL); }

void change(Random& random, kernel::Aabb& box, double unit) {
  const int axis = random.integer(0, 2);
  double &low = box.min[axis], &high = box.max[axis];
  const bool is_low = random.chance(0.5);
  double& bound = is_low ? low : high;
  const double length = high - low;
  switch (random.integer(0, 5)) {
    case 0:
      bound = next(random, bound);
      break;
    case 1:
      bound += random.chance(0.5) ? unit : -unit;
      break;
    case 2:
      bound = is_low ? high : low;
      break;
    case 3:
      bound += is_low ? length / 2 : -length / 2;
      break;
    case 4:
      bound += is_low ? -length : length;
      break;
    default:
      low += is_low ? -length : length;
      high += is_low ? -length : length;
  }
  if (low > high) std::swap(low, high);
}

void change(Random& random, kernel::Obb& box, double unit) {
  Vec3& half_edge = box.half_edges[random.index(3)];
  const double side = random.chance(0.5) ? 1 : -1;
  switch (random.integer(0, 6)) {
    case 0: {
      double& coordinate = (random.chance(0.5) ? half_edge : box.center)[random.integer(0, 2)];
      coordinate = next(random, coordinate);
      break;
    }
    case 1:
      box.center[random.integer(0, 2)] += side * unit;
      break;
    case 2:
      half_edge[random.integer(0, 2)] += side * unit;
      break;
    case 3:  // collapse to a face
      box.center = box.center + side * half_edge;
      half_edge = {};
      break;
    case 4:  // keep one half
      half_edge = 0.5 * half_edge;
      box.center = box.center + side * half_edge;
      break;
    case 5:  // double the length and keep one face
      box.center = box.center + side * half_edge;
      half_edge = 2.0 * half_edge;
      break;
    default:
      box.center = box.center + (2 * side) * half_edge;
  }
}

double unit_of(const kernel::Aabb& box) { return common_unit({box.min, box.max}); }
double unit_of(const kernel::Obb& box) {
  return common_unit({box.center, box.half_edges[0], box.half_edges[1], box.half_edges[2]});
}

}  // namespace

Box neighbour(const Box& box, std::uint64_t seed) {
  Random random(seed);
  Box result = box;
  const auto apply = [&](auto& kind) {
    const double unit = unit_of(kind);
    for (int changes = random.integer(1, 3); changes > 0; --changes) change(random, kind, unit);
  };
  std::visit(apply, result);
  return result;
}

}  // namespace occlude::fuzz
