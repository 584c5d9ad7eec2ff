// SPDX-License-Identifier: MIT
// A mesh as an engine stores it, with vertices and an index buffer: a wall with rows of small pyramids behind it. The
// example walks past the wall and prints how much of the mesh is drawn.
#include <occlude/culler/culler.h>

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

  void draw_indexed(std::uint32_t /*first_index*/, std::uint32_t index_count) {
    ++calls;
    indices += index_count;
  }
};

struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle
};

void add_pyramid(Mesh& mesh, float x, float y) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}, {x, y, 1}});
  for (const std::uint32_t corner : {0U, 1U, 4U, 1U, 2U, 4U, 2U, 3U, 4U, 3U, 0U, 4U}) mesh.indices.push_back(first + corner);
}

Mesh wall_and_pyramids() {
  Mesh mesh{{{-10, 10, 0}, {10, 10, 0}, {10, 10, 4}, {-10, 10, 4}}, {0, 1, 2, 0, 2, 3}};
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 40; ++column) {
      add_pyramid(mesh, 2 * static_cast<float>(column) - 40, 15 + 2 * static_cast<float>(row));
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
  const Culler culler(soup);       // throws std::invalid_argument, with the place, where the soup is not legal
  culler.prepare(Method::frusta);  // otherwise the first frame does

  // The triangles in the order of the culler's tree. Upload this index buffer instead of your own.
  std::vector<std::uint32_t> ordered;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    for (const std::uint32_t vertex : soup.loop(culler.hierarchy().original(p))) ordered.push_back(vertex);
  }

  // Once for each camera. Each view is used by one thread at a time.
  View view;
  Camera camera;
  for (int frame = 0; frame < 10; ++frame) {
    camera.eye = {2.0 * frame - 10, 0, 2};
    camera.target = camera.eye + glm::dvec3{0, 1, 0};
    Device device;
    // Each frame, draw ranges of the ordered index buffer.
    const CullResult& result = culler.cull(camera, {.occluders = 8}, view);
    for (const auto& [first, count] : result.drawn) device.draw_indexed(3 * first, 3 * count);
    std::printf("frame %d: %4zu of %zu triangles in %zu calls\n", frame, device.indices / 3, soup.size(), device.calls);
  }
}
