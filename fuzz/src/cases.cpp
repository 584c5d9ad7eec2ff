// SPDX-License-Identifier: MIT
#include "occlude/fuzz/cases.h"

#include <array>
#include <iterator>
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

constexpr Recipe kRecipes[] = {
#define FAMILY(name, ...) {#name, __VA_ARGS__},
#include "occlude/fuzz/families.inc"
};

constexpr auto kFamilies = [] {
  std::array<Family, std::size(kRecipes)> families{};
  for (std::size_t i = 0; i < families.size(); ++i) families[i] = static_cast<Family>(i);
  return families;
}();

constexpr const Recipe& recipe_of(Family family) { return kRecipes[static_cast<std::size_t>(family)]; }

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
