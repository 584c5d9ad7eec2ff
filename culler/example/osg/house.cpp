// SPDX-License-Identifier: MIT
#include "house.h"

#include <array>
#include <cmath>

namespace occlude::example {
namespace {

constexpr float kStorey = 2.9F;  // metres

/// A pane or a door, painted just before the wall that has `at` as its left lower corner and looks along -y or y.
void paint(TownMesh& mesh, const osg::Vec3& at, const osg::Vec3& along, float width, float height, const Colour& colour) {
  const osg::Vec3 up(0, 0, height), right = along * width;
  mesh.quad({at, at + right, at + right + up, at + up}, colour);
}

}  // namespace

float uniform(std::mt19937& random, float low, float high) {
  return low + (high - low) * (static_cast<float>(random() >> 8U) * 0x1p-24F);
}

House make_house(float width, std::mt19937& random) {
  House house;
  const auto storeys = static_cast<int>(2 + random() % 3);
  house.width = width;
  house.depth = uniform(random, 8, 10);
  house.eaves = kStorey * static_cast<float>(storeys) + 0.4F;
  house.ridge = house.eaves + uniform(random, 2, 4);
  const std::array walls = {Colour(0.78F, 0.70F, 0.58F), Colour(0.66F, 0.42F, 0.33F), Colour(0.82F, 0.80F, 0.76F),
                            Colour(0.72F, 0.60F, 0.42F), Colour(0.60F, 0.62F, 0.60F)};
  const std::array roofs = {Colour(0.50F, 0.24F, 0.18F), Colour(0.32F, 0.32F, 0.36F), Colour(0.42F, 0.28F, 0.22F)};
  const Colour wall = walls[random() % walls.size()], roof = roofs[random() % roofs.size()];
  const Colour pane(0.20F, 0.25F, 0.32F), door(0.30F, 0.18F, 0.12F);
  if (random() % 3 == 0)
    house.openings = {{0.8F, 0.7F, width / 2 - 0.9F, 2.5F}, {width / 2 + 0.9F, 0.7F, width - 0.8F, 2.5F}};

  const float w = house.width, d = house.depth, e = house.eaves, r = house.ridge;
  TownMesh& mesh = house.mesh;
  mesh.wall({0, 0, 0}, {w, 0, 0}, e, wall, house.openings);
  mesh.wall({w, 0, 0}, {w, d, 0}, e, wall);
  mesh.wall({w, d, 0}, {0, d, 0}, e, wall);
  mesh.wall({0, d, 0}, {0, 0, 0}, e, wall);
  // Gables, and a roof that starts at the walls.
  mesh.triangle({osg::Vec3(w, 0, e), {w, d, e}, {w, d / 2, r}}, wall);
  mesh.triangle({osg::Vec3(0, d, e), {0, 0, e}, {0, d / 2, r}}, wall);
  mesh.quad({osg::Vec3(0, 0, e), {w, 0, e}, {w, d / 2, r}, {0, d / 2, r}}, roof);
  mesh.quad({osg::Vec3(w, d, e), {0, d, e}, {0, d / 2, r}, {w, d / 2, r}}, roof);

  constexpr float kBefore = 0.03F;
  paint(mesh, {w / 2 - 0.5F, -kBefore, 0}, {1, 0, 0}, 1, 2.2F, door);
  const int panes = static_cast<int>(w / 2.4F);
  const float pitch = w / static_cast<float>(panes);
  for (int storey = 0; storey < storeys; ++storey) {
    for (int i = 0; i < panes; ++i) {
      const float x = pitch * (static_cast<float>(i) + 0.5F) - 0.5F, z = kStorey * static_cast<float>(storey) + 0.9F;
      const bool is_door = std::abs(x + 0.5F - w / 2) < 1.1F;
      if (storey > 0 || (house.openings.empty() && !is_door)) paint(mesh, {x, -kBefore, z}, {1, 0, 0}, 1, 1.5F, pane);
      paint(mesh, {x + 1, d + kBefore, z}, {-1, 0, 0}, 1, 1.5F, pane);
    }
  }
  return house;
}

}  // namespace occlude::example
