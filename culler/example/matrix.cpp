// SPDX-License-Identifier: MIT
// Cameras as an engine has them, as matrices: a head with two eyes, and a lamp with its shadow map. The example prints how
// much of a wall with rows of tiles behind it, and of a roof with rows of tiles below it, each of them must draw.
#include <occlude/culler/camera.h>
#include <occlude/culler/culler.h>

#include <array>
#include <cstdint>
#include <cstdio>

using namespace occlude::culler;

namespace {

using Matrix = std::array<float, 16>;  // column after column, as OpenGL, Vulkan and Direct3D take it

/// For an eye that looks along +y: reversed depth from 1 at the near plane to 0 at infinity, as is usual with floats.
Matrix head(float x, float y, float z, float near) { return {1, 0, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, -x, z, near, -y}; }

/// For a lamp that shines along -z from this height on 64 x 64 units: depth from 0 at the lamp to 1 at the ground.
Matrix lamp(float height) { return {1.0F / 32, 0, 0, 0, 0, 1.0F / 32, 0, 0, 0, 0, -1 / height, 0, 0, 0, 1, 1}; }

void add_square(PolygonSoup& soup, const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b) {
  const std::array loop{soup.add_vertex(corner), soup.add_vertex(corner + a), soup.add_vertex(corner + a + b),
                        soup.add_vertex(corner + b)};
  soup.add_polygon(loop);
}

}  // namespace

int main() {
  PolygonSoup soup;
  add_square(soup, {-10, 10, 0}, {20, 0, 0}, {0, 0, 10});   // the wall
  add_square(soup, {-10, 10, 10}, {20, 0, 0}, {0, 20, 0});  // the roof
  for (int row = 0; row < 15; ++row) {
    for (int column = 0; column < 30; ++column) {
      add_square(soup, {column - 14.75, row + 12.25, 0}, {0.5, 0, 0}, {0, 0.5, 0});
    }
  }
  const Culler culler(soup);
  const CullOptions options;

  // One cull for both eyes: what either of them sees is drawn.
  MatrixCamera both = MatrixCamera::from_columns(head(0, 0, 2, 0.1F).data(), ClipDepth::zero_to_w);
  both.eyes = EyeRegion::ball(0.032);  // half of the distance of the eyes
  const CullResult seen = culler.cull(both, options);
  std::printf("head: %3zu of %zu polygons\n", seen.stats.drawn_polygons, soup.size());

  // With parallel rays it must be said which depths are nearer.
  const MatrixCamera light = MatrixCamera::from_columns(lamp(40).data(), ClipDepth::zero_to_w, Nearer::less);
  const CullResult lit = culler.cull(light, options);
  std::printf("lamp: %3zu of %zu polygons\n", lit.stats.drawn_polygons, soup.size());
}
