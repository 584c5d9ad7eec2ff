// SPDX-License-Identifier: MIT
#include "lattice.h"

#include <algorithm>

namespace occlude::fuzz {
namespace {

/// Angles are counter-clockwise from the positive a axis.
bool has_lower_angle(const Step& p, const Step& q) {
  const auto half = [](const Step& s) { return s.b < 0 || (s.b == 0 && s.a < 0); };
  return half(p) != half(q) ? half(q) : cross(p, q) > 0;
}

bool have_one_direction(const Step& p, const Step& q) { return cross(p, q) == 0 && p.a * q.a + p.b * q.b > 0; }

/// `count - 1` random steps of different directions, and the step that closes the loop.
std::vector<Step> closed_steps(Random& random, int count, int reach) {
  std::vector<Step> steps;
  Step closing;
  while (static_cast<int>(steps.size()) < count - 1) {
    const Step step{random.integer(-reach, reach), random.integer(-reach, reach)};
    const bool is_old = std::ranges::any_of(steps, [&](const Step& s) { return have_one_direction(s, step); });
    if ((step.a == 0 && step.b == 0) || is_old) continue;
    steps.push_back(step);
    closing = {closing.a - step.a, closing.b - step.b};
  }
  if (closing.a != 0 || closing.b != 0) steps.push_back(closing);
  return steps;
}

/// Two vectors that span a plane. They are often axes, so that side planes are often parallel to axes too.
std::array<Vec3, 2> lattice_basis(Random& random) {
  while (true) {
    const int reach = random.integer(1, 2);
    const Vec3 e = lattice_vector(random, reach), f = lattice_vector(random, reach);
    if (cross(e, f) != Vec3{}) return {e, f};
  }
}

}  // namespace

std::vector<Step> lattice_edges(Random& random, int count, int reach) {
  while (true) {
    std::vector<Step> steps = closed_steps(random, count, reach);
    if (std::ranges::all_of(steps, [&](const Step& s) { return cross(steps[0], s) == 0; })) continue;  // no area
    std::ranges::stable_sort(steps, has_lower_angle);  // two may have one direction: the same order with every library
    return steps;
  }
}

Vec3 lattice_vector(Random& random, int reach) {
  const auto next = [&] { return static_cast<double>(random.integer(-reach, reach)); };
  const double x = next(), y = next(), z = next();
  return {x, y, z};
}

Vec3 random_vector(Random& random, double reach) {
  const double x = random.real(-reach, reach), y = random.real(-reach, reach), z = random.real(-reach, reach);
  return {x, y, z};
}

std::vector<Vec3> embed(Random& random, const std::vector<Step>& steps) {
  const auto [e, f] = lattice_basis(random);
  std::vector<Vec3> polygon;
  Vec3 at = lattice_vector(random, 4);
  for (const Step& step : steps) {
    polygon.push_back(at);
    at = at + static_cast<double>(step.a) * e + static_cast<double>(step.b) * f;
  }
  if (random.chance(0.5)) std::ranges::reverse(polygon);
  return polygon;
}

Vec3 plane_normal(const std::vector<Vec3>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3 normal = cross(polygon[1] - polygon[0], polygon[i] - polygon[0]);
    if (normal != Vec3{}) return normal;
  }
  return {};
}

std::vector<Step> few_edges(Random& random) { return lattice_edges(random, random.integer(3, 6), 3); }

}  // namespace occlude::fuzz
