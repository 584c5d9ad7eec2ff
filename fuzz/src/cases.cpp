// SPDX-License-Identifier: MIT
#include "occlude/fuzz/cases.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "placement.h"
#include "scenes.h"
#include "vector_math.h"

namespace occlude::fuzz {
namespace {

/// Applies `change` to every coordinate of the case, a direction of view excepted.
template <class Change>
void for_each_point(Case& made, const Change& change) {
  for (Vec3& vertex : made.polygon) change(vertex);
  if (made.viewpoint.is_eye()) change(made.viewpoint.value);
  change(made.box.min);
  change(made.box.max);
}

void leave(Random&, Case&) {}

/// Moves a coordinate of the box or of the viewpoint, or of a triangle, to a neighbouring double or the one after it.
void nudge(Random& random, Case& made) {
  const bool may_bend = made.polygon.size() == 3 || made.near == Near::farthest;
  Vec3& min = made.box.min;
  Vec3& max = made.box.max;
  for (int moves = random.integer(1, 3); moves > 0; --moves) {
    const std::array<Vec3*, 6> points{
        &min, &max, &min, &max, &made.viewpoint.value, may_bend ? &made.polygon[random.index(made.polygon.size())] : &max};
    double& value = (*points[random.index(points.size())])[random.integer(0, 2)];
    if (value != 0) value = std::nextafter(value, random.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
  }
  for (int axis = 0; axis < 3; ++axis) max[axis] = std::max(min[axis], max[axis]);
}

/// Exactly, by a few thousand million: what was a small number becomes the last bits of a large one.
void move_far(Random& random, Case& made) {
  const double unit = 0x1p-8;
  const auto part = [&] { return 4e9 * random.integer(-1, 1) + unit * random.integer(-1000, 1000); };
  const double x = part(), y = part(), z = part();
  for_each_point(made, [&](Vec3& p) { p = unit * p + Vec3{x, y, z}; });
}

void shrink(Random&, Case& made) {
  for_each_point(made, [](Vec3& p) { p = 0x1p-60 * p; });
}

void grow(Random&, Case& made) {
  for_each_point(made, [](Vec3& p) { p = 0x1p60 * p; });
}

/// Rounds every coordinate as decimal input or thirds do: what touched is now off by a rounding or not.
void make_decimal(Random& random, Case& made) {
  const bool tenths = random.chance(0.5);
  for_each_point(made, [&](Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = tenths ? p[axis] * 0.1 : p[axis] / 3;
  });
}

/// How a family is made: a scene, a box put to it, a finish.
struct Recipe {
  Family family;
  std::string_view name;
  Case (*make_scene)(Random&);
  Placement placement;
  void (*finish)(Random&, Case&);
};

constexpr Placement kReal{Feature::any, false, 0};
constexpr Placement kLattice{Feature::any, true, 0};

constexpr std::array kRecipes{
    Recipe{Family::random, "random", random_scene, kReal, leave},
    Recipe{Family::lattice, "lattice", lattice_scene, kLattice, leave},
    Recipe{Family::face_touch, "face_touch", lattice_scene, {Feature::face, true, 0}, leave},
    Recipe{Family::ray_touch, "ray_touch", lattice_scene, {Feature::ray, true, 0}, leave},
    Recipe{Family::near_touch, "near_touch", lattice_scene, {Feature::near, true, 0}, leave},
    Recipe{Family::corner_touch, "corner_touch", lattice_scene, {Feature::corner, true, 0}, leave},
    Recipe{Family::ulp_lattice, "ulp_lattice", lattice_scene, kLattice, nudge},
    Recipe{Family::ulp_random, "ulp_random", random_scene, kReal, nudge},
    Recipe{Family::flat_box, "flat_box", lattice_scene, {Feature::any, true, 1}, leave},
    Recipe{Family::needle_box, "needle_box", lattice_scene, {Feature::any, true, 2}, leave},
    Recipe{Family::point_box, "point_box", lattice_scene, {Feature::any, true, 3}, leave},
    Recipe{Family::eye_in_box, "eye_in_box", lattice_scene, kLattice, leave},
    Recipe{Family::sliver, "sliver", sliver_scene, kReal, leave},
    Recipe{Family::sliver_lattice, "sliver_lattice", lattice_sliver_scene, kLattice, leave},
    Recipe{Family::many_sided, "many_sided", many_sided_scene, kLattice, leave},
    Recipe{Family::collinear, "collinear", collinear_scene, kLattice, leave},
    Recipe{Family::equal_farthest, "equal_farthest", equal_farthest_scene, kLattice, leave},
    Recipe{Family::far_offset, "far_offset", lattice_scene, kLattice, move_far},
    Recipe{Family::tiny_scale, "tiny_scale", random_scene, kReal, shrink},
    Recipe{Family::huge_scale, "huge_scale", lattice_scene, kLattice, grow},
    Recipe{Family::decimal, "decimal", sturdy_lattice_scene, kLattice, make_decimal},
    Recipe{Family::non_coplanar, "non_coplanar", folded_scene, kReal, leave},
    Recipe{Family::orthographic, "orthographic", orthographic_scene, kReal, leave},
    Recipe{Family::orthographic_touch, "orthographic_touch", orthographic_lattice_scene, kLattice, leave},
    Recipe{Family::orthographic_ulp, "orthographic_ulp", orthographic_lattice_scene, kLattice, nudge},
};

constexpr auto kFamilies = [] {
  std::array<Family, kRecipes.size()> families{};
  for (std::size_t i = 0; i < families.size(); ++i) families[i] = kRecipes[i].family;
  return families;
}();

/// Recipes stand in the order of the enumeration.
constexpr const Recipe& recipe_of(Family family) { return kRecipes[static_cast<std::size_t>(family)]; }

static_assert([] {
  for (const Family family : kFamilies) {
    if (recipe_of(family).family != family) return false;
  }
  return true;
}());

}  // namespace

std::span<const Family> families() { return kFamilies; }

std::string_view name(Family family) { return recipe_of(family).name; }

Case make_case(Family family, std::uint64_t seed) {
  const Recipe& recipe = recipe_of(family);
  // Families do not share their scenes for the same seed.
  Random random(seed ^ (static_cast<std::uint64_t>(family) << 56));
  Case made = recipe.make_scene(random);
  if (family == Family::eye_in_box) {
    place_box_about_eye(random, made);
  } else {
    place_box(random, made, recipe.placement);
  }
  recipe.finish(random, made);
  return made;
}

}  // namespace occlude::fuzz
