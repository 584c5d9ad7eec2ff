// SPDX-License-Identifier: MIT
#include "minimise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "cut_vertex.h"

namespace occlude::fuzz {
namespace {

using kernel::Vec3;
using Shows = std::function<bool(const Case&)>;

/// The points, which move with the scene.
std::vector<Vec3*> points_of(Case& c) {
  std::vector<Vec3*> points;
  if (c.viewpoint.is_eye()) points.push_back(&c.viewpoint.value);
  for (Vec3& vertex : vertices_of(c.occluder)) points.push_back(&vertex);
  if (auto* const aabb = std::get_if<kernel::Aabb>(&c.box)) {
    points.insert(points.end(), {&aabb->min, &aabb->max});
  } else {
    points.push_back(&std::get<kernel::Obb>(c.box).center);
  }
  return points;
}

/// All points, directions and half edges.
std::vector<Vec3*> vectors_of(Case& c) {
  std::vector<Vec3*> vectors = points_of(c);
  if (!c.viewpoint.is_eye()) vectors.push_back(&c.viewpoint.value);
  if (auto* const obb = std::get_if<kernel::Obb>(&c.box)) {
    for (Vec3& half_edge : obb->half_edges) vectors.push_back(&half_edge);
  }
  return vectors;
}

/// The number of bits of the mantissa up to the last one that is set.
int length(double x) {
  if (x == 0) return 0;
  if (!std::isfinite(x)) return std::numeric_limits<double>::digits + 1;  // longer than any number
  int exponent = 0, used = 0;
  for (double rest = std::fabs(std::frexp(x, &exponent)); rest != 0; ++used) {
    rest *= 2;
    rest -= std::floor(rest);
  }
  return used;
}

/// x with `bits` bits of mantissa, rounded towards zero.
double shortened(double x, int bits) {
  int exponent = 0;
  return std::ldexp(std::trunc(std::ldexp(std::frexp(x, &exponent), bits)), exponent - bits);
}

/// Values that may replace x, the best first.
std::vector<double> simpler(double x) {
  if (!std::isfinite(x)) return {0, 1};
  std::vector<double> choices{0, std::copysign(1.0, x), std::trunc(x), std::round(x)};
  for (int bits = 1; bits < length(x); bits = bits < 8 ? bits + 1 : bits + bits / 4) choices.push_back(shortened(x, bits));
  return choices;
}

bool is_simpler(double a, double b) {
  return length(a) < length(b) || (length(a) == length(b) && std::fabs(a) < std::fabs(b));
}

class Minimiser {
 public:
  Minimiser(Case question, const Shows& shows) : best_(std::move(question)), shows_(shows) {}

  Case run() {
    while (step()) {
    }
    return std::move(best_);
  }

 private:
  /// This is enough for some hundred coordinates. If the second oracle is wrong, it takes about a second, because that is
  /// the slowest to ask.
  static constexpr int kMostTries = 10'000;

  bool step() {
    const bool fewer = drop_vertices(), moved = move_to_origin(), shorter = shorten();
    return (fewer || moved || shorter) && tries_ < kMostTries;
  }

  bool take(const Case& candidate) {
    if (++tries_ > kMostTries || !shows_(candidate)) return false;
    best_ = candidate;
    return true;
  }

  bool drop_vertices() {
    bool any = false;
    for (std::size_t i = 0; i < vertices_of(best_.occluder).size();) {
      if (drop_vertex(i)) {
        any = true;
      } else {
        ++i;
      }
    }
    return any;
  }

  bool drop_vertex(std::size_t i) {
    Case candidate = best_;
    if (auto* const polygon = std::get_if<Polygon>(&candidate.occluder)) {
      polygon->erase(polygon->begin() + static_cast<std::ptrdiff_t>(i));
      return take(candidate);
    }
    for (kernel::Polytope& cut : cut_vertex(std::get<kernel::Polytope>(best_.occluder), static_cast<std::uint32_t>(i))) {
      candidate.occluder = std::move(cut);
      if (take(candidate)) return true;
    }
    return false;
  }

  /// Moves a point to the origin where no coordinate loses a bit. A scene that already has a point at the origin stays.
  bool move_to_origin() {
    for (const Vec3* const p : points_of(best_)) {
      if (*p == Vec3{}) return false;
    }
    for (const Vec3* const p : points_of(best_)) {
      const Vec3 shift = *p;
      Case candidate = best_;
      bool exact = true;
      for (Vec3* const q : points_of(candidate)) {
        for (int axis = 0; axis < 3; ++axis) {
          const double moved = (*q)[axis] - shift[axis];
          exact = exact && moved + shift[axis] == (*q)[axis] && length(moved) <= 53 && (*q)[axis] - moved == shift[axis];
          (*q)[axis] = moved;
        }
      }
      if (exact && take(candidate)) return true;
    }
    return false;
  }

  bool shorten() {
    bool any = false;
    const std::size_t count = 3 * vectors_of(best_).size();
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate(best_, i);
      for (const double choice : simpler(x)) {
        if (!is_simpler(choice, x)) continue;
        Case candidate = best_;
        coordinate(candidate, i) = choice;
        if (!take(candidate)) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  static double& coordinate(Case& c, std::size_t i) { return (*vectors_of(c)[i / 3])[static_cast<int>(i % 3)]; }

  Case best_;
  const Shows& shows_;
  int tries_ = 0;
};

}  // namespace

Case minimise(Case question, const Shows& shows) { return Minimiser(std::move(question), shows).run(); }

}  // namespace occlude::fuzz
