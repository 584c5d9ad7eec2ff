// SPDX-License-Identifier: MIT
#include "occlude/fuzz/cases.h"

#include <array>
#include <optional>
#include <utility>

#include "finish.h"
#include "placement.h"
#include "polytope_scenes.h"
#include "scenes.h"

namespace occlude::fuzz {
namespace {

/// How a family is made: a scene, a way to place a box in it, and a finish.
struct Recipe {
  Family family;
  std::string_view name;
  Scene (*make_scene)(Random&);
  Box (*place)(Random&, Scene&, const Placement&);
  Placement placement;
  void (*finish)(Random&, Case&);
};

/// Several finishes, one after the other.
template <auto... kFinishes>
void finish_with(Random& random, Case& made) {
  (kFinishes(random, made), ...);
}

constexpr Placement kReal{Feature::any, false, 0, {}};
constexpr Placement kLattice{};
constexpr Placement kLatticeEdges{Feature::edge, true, 0, {}};
constexpr Placement kRealEdges{Feature::edge, false, 0, {}};
constexpr Placement kRealVertices{Feature::vertex, false, 0, {}};

constexpr Placement lattice_at(Feature feature) { return {feature, true, 0, {}}; }
constexpr Placement flat(int axes, std::optional<FrameKind> frame = {}) { return {Feature::any, true, axes, frame}; }
constexpr Placement oriented(FrameKind frame, Feature feature = Feature::any) { return {feature, true, 0, frame}; }

constexpr Placement kRealObb{Feature::any, false, 0, FrameKind::real};
constexpr Placement kFlatRealObb{Feature::any, false, 1, FrameKind::real};
constexpr Placement kLatticeObb = oriented(FrameKind::lattice);
constexpr Placement kParallelObb = oriented(FrameKind::parallel);
constexpr Placement kLatticeObbEdges = oriented(FrameKind::lattice, Feature::edge);

constexpr std::array kRecipes{
    Recipe{Family::random, "random", random_scene, place_box, kReal, leave},
    Recipe{Family::lattice, "lattice", lattice_scene, place_box, kLattice, leave},
    Recipe{Family::face_touch, "face_touch", lattice_scene, place_box, lattice_at(Feature::face), leave},
    Recipe{Family::ray_touch, "ray_touch", lattice_scene, place_box, lattice_at(Feature::ray), leave},
    Recipe{Family::near_touch, "near_touch", lattice_scene, place_box, lattice_at(Feature::near), leave},
    Recipe{Family::corner_touch, "corner_touch", lattice_scene, place_box, lattice_at(Feature::corner), leave},
    Recipe{Family::ulp_lattice, "ulp_lattice", lattice_scene, place_box, kLattice, nudge},
    Recipe{Family::ulp_random, "ulp_random", random_scene, place_box, kReal, nudge},
    Recipe{Family::flat_box, "flat_box", lattice_scene, place_box, flat(1), leave},
    Recipe{Family::needle_box, "needle_box", lattice_scene, place_box, flat(2), leave},
    Recipe{Family::point_box, "point_box", lattice_scene, place_box, flat(3), leave},
    Recipe{Family::eye_in_box, "eye_in_box", lattice_scene, place_box_about_eye, kLattice, leave},
    Recipe{Family::sliver, "sliver", sliver_scene, place_box, kReal, leave},
    Recipe{Family::sliver_lattice, "sliver_lattice", lattice_sliver_scene, place_box, kLattice, leave},
    Recipe{Family::many_sided, "many_sided", many_sided_scene, place_box, kLattice, leave},
    Recipe{Family::collinear, "collinear", collinear_scene, place_box, kLattice, leave},
    Recipe{Family::equal_farthest, "equal_farthest", equal_farthest_scene, place_box, kLattice, leave},
    Recipe{Family::far_offset, "far_offset", lattice_scene, place_box, kLattice, move_far},
    Recipe{Family::tiny_scale, "tiny_scale", random_scene, place_box, kReal, shrink},
    Recipe{Family::huge_scale, "huge_scale", lattice_scene, place_box, kLattice, grow},
    Recipe{Family::decimal, "decimal", sturdy_lattice_scene, place_box, kLattice, make_decimal},
    Recipe{Family::non_coplanar, "non_coplanar", folded_scene, place_box, kReal, leave},
    Recipe{Family::orthographic, "orthographic", orthographic_scene, place_box, kReal, leave},
    Recipe{Family::orthographic_touch, "orthographic_touch", orthographic_lattice_scene, place_box, kLattice, leave},
    Recipe{Family::orthographic_ulp, "orthographic_ulp", orthographic_lattice_scene, place_box, kLattice, nudge},
    Recipe{Family::wide_frustum, "wide_frustum", wide_scene, place_box_for_other_near, kLattice, leave},
    Recipe{Family::wide_frustum_ulp, "wide_frustum_ulp", wide_scene, place_box_for_other_near, kLattice, nudge},
    Recipe{Family::axis_aligned_faces, "axis_aligned_faces", axis_aligned_scene, place_box, kLattice, leave},
    Recipe{Family::shared_vertex, "shared_vertex", shared_coordinates_scene, place_box_at_vertices, kRealVertices, leave},
    Recipe{Family::edge_crossing, "edge_crossing", lattice_scene, place_box_across, kLatticeEdges, leave},
    Recipe{Family::edge_crossing_ulp, "edge_crossing_ulp", lattice_scene, place_box_across, kLatticeEdges, nudge},
    Recipe{Family::edge_crossing_random, "edge_crossing_random", random_scene, place_box_across, kRealEdges, leave},
    Recipe{Family::orthographic_axis_aligned, "orthographic_axis_aligned", orthographic_axis_aligned_scene, place_box,
           kLattice, leave},
    Recipe{Family::orthographic_edge_crossing, "orthographic_edge_crossing", orthographic_lattice_scene, place_box_across,
           kLatticeEdges, leave},
    Recipe{Family::obb_random, "obb_random", random_scene, place_box, kRealObb, leave},
    Recipe{Family::obb_lattice, "obb_lattice", lattice_scene, place_box, kLatticeObb, leave},
    Recipe{Family::obb_flat, "obb_flat", lattice_scene, place_box, flat(1, FrameKind::lattice), leave},
    Recipe{Family::obb_needle, "obb_needle", lattice_scene, place_box, flat(2, FrameKind::lattice), leave},
    Recipe{Family::obb_point, "obb_point", lattice_scene, place_box, flat(3, FrameKind::lattice), leave},
    Recipe{Family::obb_dependent, "obb_dependent", lattice_scene, place_box, oriented(FrameKind::dependent), leave},
    Recipe{Family::obb_axis, "obb_axis", lattice_scene, place_box, oriented(FrameKind::axes), leave},
    Recipe{Family::obb_ulp, "obb_ulp", lattice_scene, place_box, kLatticeObb, nudge},
    Recipe{Family::obb_parallel, "obb_parallel", lattice_scene, place_box, kParallelObb, leave},
    Recipe{Family::obb_parallel_ulp, "obb_parallel_ulp", lattice_scene, place_box, kParallelObb, nudge},
    Recipe{Family::obb_about_eye, "obb_about_eye", lattice_scene, place_box_about_eye, kLatticeObb, leave},
    Recipe{Family::obb_shared_vertex, "obb_shared_vertex", large_lattice_scene, place_box,
           oriented(FrameKind::large, Feature::vertex), leave},
    Recipe{Family::obb_edge_crossing, "obb_edge_crossing", lattice_scene, place_box_across, kLatticeObbEdges, leave},
    Recipe{Family::obb_edge_crossing_ulp, "obb_edge_crossing_ulp", lattice_scene, place_box_across, kLatticeObbEdges, nudge},
    Recipe{Family::obb_wide_frustum, "obb_wide_frustum", wide_scene, place_box_for_other_near, kLatticeObb, leave},
    Recipe{Family::obb_sliver, "obb_sliver", sliver_scene, place_box, kRealObb, leave},
    Recipe{Family::obb_many_sided, "obb_many_sided", many_sided_scene, place_box, kLatticeObb, leave},
    Recipe{Family::obb_decimal, "obb_decimal", sturdy_lattice_scene, place_box, kLatticeObb, make_decimal},
    Recipe{Family::obb_far_offset, "obb_far_offset", lattice_scene, place_box, kLatticeObb, move_far},
    Recipe{Family::obb_tiny_scale, "obb_tiny_scale", lattice_scene, place_box, kLatticeObb, shrink},
    Recipe{Family::obb_huge_scale, "obb_huge_scale", random_scene, place_box, kRealObb, grow},
    Recipe{Family::obb_orthographic, "obb_orthographic", orthographic_scene, place_box, kRealObb, leave},
    Recipe{Family::obb_orthographic_touch, "obb_orthographic_touch", orthographic_lattice_scene, place_box, kLatticeObb,
           leave},
    Recipe{Family::obb_orthographic_parallel, "obb_orthographic_parallel", orthographic_lattice_scene, place_box,
           kParallelObb, leave},
    Recipe{Family::obb_orthographic_ulp, "obb_orthographic_ulp", orthographic_lattice_scene, place_box, kLatticeObb, nudge},
    Recipe{Family::polytope_random, "polytope_random", polytope_scene, place_box, kReal, reorder},
    Recipe{Family::polytope_box, "polytope_box", lattice_box_scene, place_box, kLattice, disguise},
    Recipe{Family::polytope_hull, "polytope_hull", lattice_hull_scene, place_box, kLattice, disguise},
    Recipe{Family::polytope_near, "polytope_near", lattice_surface_scene, place_box, lattice_at(Feature::front), disguise},
    Recipe{Family::polytope_edge_on, "polytope_edge_on", edge_on_scene, place_box, kLattice, disguise},
    Recipe{Family::polytope_ulp, "polytope_ulp", simplicial_lattice_scene, place_box, kLattice, finish_with<reorder, nudge>},
    Recipe{Family::polytope_many, "polytope_many", many_sided_polytope_scene, place_box, kLattice, disguise},
    Recipe{Family::polytope_equal_farthest, "polytope_equal_farthest", equal_farthest_polytope_scene, place_box, kLattice,
           disguise},
    Recipe{Family::polytope_wide_frustum, "polytope_wide_frustum", wide_polytope_scene, place_box_for_other_near, kLattice,
           disguise},
    Recipe{Family::polytope_edge_crossing, "polytope_edge_crossing", lattice_polytope_scene, place_box_across, kLatticeEdges,
           disguise},
    Recipe{Family::polytope_shared_vertex, "polytope_shared_vertex", polytope_scene, place_box_at_vertices, kRealVertices,
           reorder},
    Recipe{Family::polytope_decimal, "polytope_decimal", simplicial_lattice_scene, place_box, kLattice,
           finish_with<reorder, make_decimal>},
    Recipe{Family::polytope_far_offset, "polytope_far_offset", lattice_polytope_scene, place_box, kLattice,
           finish_with<disguise, move_far>},
    Recipe{Family::polytope_tiny_scale, "polytope_tiny_scale", polytope_scene, place_box, kReal,
           finish_with<reorder, shrink>},
    Recipe{Family::polytope_huge_scale, "polytope_huge_scale", lattice_polytope_scene, place_box, kLattice,
           finish_with<disguise, grow>},
    Recipe{Family::polytope_orthographic, "polytope_orthographic", orthographic_polytope_scene, place_box, kReal, reorder},
    Recipe{Family::polytope_orthographic_touch, "polytope_orthographic_touch", orthographic_lattice_polytope_scene,
           place_box, kLattice, disguise},
    Recipe{Family::polytope_orthographic_edge_on, "polytope_orthographic_edge_on", orthographic_edge_on_scene, place_box,
           kLattice, disguise},
    Recipe{Family::polytope_orthographic_ulp, "polytope_orthographic_ulp", orthographic_simplicial_lattice_scene, place_box,
           kLattice, finish_with<reorder, nudge>},
    Recipe{Family::obb_polytope, "obb_polytope", lattice_polytope_scene, place_box, kLatticeObb, disguise},
    Recipe{Family::obb_polytope_random, "obb_polytope_random", polytope_scene, place_box, kRealObb, reorder},
    Recipe{Family::obb_polytope_near, "obb_polytope_near", lattice_surface_scene, place_box,
           oriented(FrameKind::lattice, Feature::front), disguise},
    Recipe{Family::obb_polytope_edge_on, "obb_polytope_edge_on", edge_on_scene, place_box, kParallelObb, disguise},
    Recipe{Family::obb_polytope_edge_crossing, "obb_polytope_edge_crossing", lattice_polytope_scene, place_box_across,
           kLatticeObbEdges, disguise},
    Recipe{Family::obb_polytope_ulp, "obb_polytope_ulp", simplicial_lattice_scene, place_box, kLatticeObb,
           finish_with<reorder, nudge>},
    Recipe{Family::obb_polytope_orthographic, "obb_polytope_orthographic", orthographic_lattice_polytope_scene, place_box,
           kLatticeObb, disguise},
    Recipe{Family::hair, "hair", lattice_scene, place_box, kLattice, move_by_a_hair},
    Recipe{Family::obb_hair, "obb_hair", lattice_scene, place_box, kLatticeObb, move_by_a_hair},
    Recipe{Family::polytope_hair, "polytope_hair", simplicial_lattice_scene, place_box, kLattice,
           finish_with<reorder, move_by_a_hair>},
    Recipe{Family::edge_on, "edge_on", level_with_eye_scene, place_box, kReal, leave},
    Recipe{Family::cospherical, "cospherical", cospherical_scene, place_box, kReal, leave},
    Recipe{Family::any_scale, "any_scale", lattice_scene, place_box, kLattice, stretch},
    Recipe{Family::obb_any_scale, "obb_any_scale", lattice_scene, place_box, kLatticeObb, stretch},
    Recipe{Family::polytope_any_scale, "polytope_any_scale", lattice_polytope_scene, place_box, kLattice,
           finish_with<reorder, stretch>},
    Recipe{Family::long_box, "long_box", lattice_scene, place_box, kLattice, lengthen},
    Recipe{Family::obb_long_box, "obb_long_box", lattice_scene, place_box, kLatticeObb, lengthen},
    Recipe{Family::polytope_long_box, "polytope_long_box", lattice_polytope_scene, place_box, kLattice,
           finish_with<reorder, lengthen>},
    Recipe{Family::edge_at_eye, "edge_at_eye", edge_at_eye_scene, place_box, kReal, leave},
    Recipe{Family::obb_edge_at_eye, "obb_edge_at_eye", edge_at_eye_scene, place_box, kRealObb, leave},
    Recipe{Family::obb_orthographic_long, "obb_orthographic_long", orthographic_scene, place_box, kFlatRealObb,
           lengthen_along_rays},
};

constexpr auto kFamilies = [] {
  std::array<Family, kRecipes.size()> families{};
  for (std::size_t i = 0; i < families.size(); ++i) families[i] = kRecipes[i].family;
  return families;
}();

/// The recipes are in the order of the enumeration.
constexpr const Recipe& recipe_of(Family family) { return kRecipes[static_cast<std::size_t>(family)]; }

static_assert([] {
  for (const Family family : kFamilies) {
    if (recipe_of(family).family != family) return false;
  }
  return true;
}());

Occluder occluder_of(Scene&& scene) {
  if (scene.is_polygon()) return std::move(scene.vertices);
  return kernel::Polytope{std::move(scene.vertices), std::move(scene.faces)};
}

}  // namespace

std::span<const Family> families() { return kFamilies; }

std::string_view name(Family family) { return recipe_of(family).name; }

Case make_case(Family family, std::uint64_t seed) {
  const Recipe& recipe = recipe_of(family);
  // Families have different scenes for the same seed.
  Random random(seed ^ (static_cast<std::uint64_t>(family) << 56));
  Scene scene = recipe.make_scene(random);
  Box box = recipe.place(random, scene, recipe.placement);
  Case made{scene.viewpoint, occluder_of(std::move(scene)), scene.near, box};
  recipe.finish(random, made);
  return made;
}

}  // namespace occlude::fuzz
