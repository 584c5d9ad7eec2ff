// SPDX-License-Identifier: MIT
// A mesh as an engine stores it, with vertices, an index buffer and materials: a wall with rows of small pyramids of three
// colours behind it. The example walks past the wall and prints how much of the mesh is drawn.
#include <occlude/culler/culler.h>
#include <occlude/culler/hierarchy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace occlude::culler;

namespace {

/// Stands in for a graphics interface. It counts what it is asked to draw.
struct Device {
  std::size_t calls = 0, indices = 0;

  void draw_indexed(std::uint32_t /*material*/, std::uint32_t /*first_index*/, std::uint32_t index_count) {
    ++calls;
    indices += index_count;
  }
};

struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::uint32_t> indices;    // three per triangle
  std::vector<std::uint32_t> materials;  // one per triangle
};

void add_pyramid(Mesh& mesh, float x, float y, std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}, {x, y, 1}});
  for (const std::uint32_t corner : {0U, 1U, 4U, 1U, 2U, 4U, 2U, 3U, 4U, 3U, 0U, 4U}) mesh.indices.push_back(first + corner);
  mesh.materials.insert(mesh.materials.end(), 4, material);
}

Mesh wall_and_pyramids() {
  Mesh mesh{{{-10, 10, 0}, {10, 10, 0}, {10, 10, 4}, {-10, 10, 4}}, {0, 1, 2, 0, 2, 3}, {0, 0}};
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 40; ++column) {
      const auto colour = static_cast<std::uint32_t>((row + column) % 3);
      add_pyramid(mesh, 2 * static_cast<float>(column) - 40, 15 + 2 * static_cast<float>(row), 1 + colour);
    }
  }
  return mesh;
}

}  // namespace

int main() {
  const Mesh mesh = wall_and_pyramids();
  // Once, when the model is loaded.
  PolygonSoup soup;
  for (const auto& [x, y, z] : mesh.vertices) soup.add_vertex({x, y, z});
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    soup.add_polygon(std::array{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  const Culler culler(soup);  // throws std::invalid_argument, with the place, where the soup is not legal
  culler.prepare();           // otherwise the first frame does

  // The triangles by material, those of each in the order of the culler's tree. Upload this index buffer instead of your
  // own.
  const DrawOrder order(culler.hierarchy(), mesh.materials);
  std::vector<std::uint32_t> ordered;
  for (const std::uint32_t p : order.polygons()) {
    for (const std::uint32_t vertex : soup.loop(p)) ordered.push_back(vertex);
  }

  // Once for each camera. Each view is used by one thread at a time.
  View view;
  Camera camera;
  std::vector<MaterialRange> ranges;
  for (int frame = 0; frame < 10; ++frame) {
    camera.eye = {2.0 * frame - 10, 0, 2};
    camera.target = camera.eye + glm::dvec3{0, 1, 0};
    Device device;
    // Each frame, draw ranges of the ordered index buffer. Without materials, result.drawn are the ranges to draw.
    const CullResult& result = culler.cull(camera, {.occluders = 8}, view);
    order.find_ranges(result.drawn, ranges);
    for (const auto& [material, first, count] : ranges) device.draw_indexed(material, 3 * first, 3 * count);
    std::printf("frame %d: %4zu of %zu triangles in %zu calls\n", frame, device.indices / 3, soup.size(), device.calls);
  }
}
