// SPDX-License-Identifier: MIT
// A program that links the culler and the kernel. A wall hides a thing: exit code 0 only when the thing is culled and the
// wall is drawn, and the kernel says the same of a batch of one box.
#include <occlude/culler/culler.h>
#include <occlude/kernel/batch.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace occlude::culler;

namespace {

/// A square across the x axis.
void add_square(PolygonSoup& soup, double x, double half_edge) {
  const std::uint32_t a = soup.add_vertex({x, -half_edge, -half_edge});
  const std::uint32_t b = soup.add_vertex({x, half_edge, -half_edge});
  const std::uint32_t c = soup.add_vertex({x, half_edge, half_edge});
  const std::uint32_t d = soup.add_vertex({x, -half_edge, half_edge});
  soup.add_polygon(std::array{a, b, c, d});
}

}  // namespace

int main() {
  PolygonSoup soup;
  add_square(soup, 4, 0.5);  // the thing
  add_square(soup, 2, 1);    // the wall

  BuildConfig config;
  config.hierarchy.leaf_size = 1;
  const Culler culler(soup, config);
  const CullResult frame = culler.cull(Camera{});  // from the origin along x

  std::vector<std::uint32_t> drawn;
  for (const auto [first, count] : frame.drawn) {
    for (std::uint32_t p = first; p < first + count; ++p) drawn.push_back(culler.hierarchy().original(p));
  }
  const bool culled = drawn == std::vector<std::uint32_t>{1} && frame.stats.shadow_culled_polygons == 1;

  // The shadow frusta of the paper's method, and the kernel. Batches call Highway: that it is linked too shows only here.
  const CullResult shadows = culler.cull(Camera{}, {.method = Method::frusta});
  namespace kernel = occlude::kernel;
  const kernel::BoxBatch boxes(std::array{kernel::Aabb{{4, -0.5, -0.5}, {4, 0.5, 0.5}}});
  std::array relations{kernel::Relation::outside};
  bool inside = false;
  for (const Occluder& occluder : shadows.occluders) {
    kernel::overlap_certified(occluder.frustum, boxes, kernel::NearBoundary::open, relations);
    inside |= relations[0] == kernel::Relation::inside;
  }

  std::printf("%s, %s\n", culled ? "culled" : "not culled", inside ? "inside" : "not inside");
  return culled && inside ? 0 : 1;
}
