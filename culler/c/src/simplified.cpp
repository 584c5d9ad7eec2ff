// SPDX-License-Identifier: MIT
// Simplified occluders, in the C interface.
#include <cstdint>
#include <memory>
#include <vector>

#include "arrays.h"
#include "mesh_data.h"
#include "occlude/culler/simplified_occluders.h"
#include "status.h"
#include "structs.h"

struct occlude_simplified {
  occlude::culler::SimplifiedOccluders occluders;
  // Of each triangle.
  std::vector<std::uint32_t> polygons, boxes;
  std::vector<occlude_box> inner_boxes;
};

namespace occlude::c {
namespace {

std::vector<glm::dvec3> eyes_of(const occlude_points& given) {
  const Points points(given.data, given.count, given.stride, given.type, "data of eyes");
  std::vector<glm::dvec3> eyes;
  for (std::size_t i = 0; i < given.count; ++i) {
    const auto [x, y, z] = points[i];
    eyes.emplace_back(x, y, z);
  }
  return eyes;
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_simplified_create(const occlude_mesh_data* data, const occlude_simplify_options* options,
                                         occlude_simplified** simplified) noexcept {
  return guarded([&] {
    require(simplified, "simplified");
    const occlude_mesh_data read_data = read(data, occlude_mesh_data OCCLUDE_MESH_DATA_INIT, "data");
    const auto read_these = read_options(options, occlude_simplify_options OCCLUDE_SIMPLIFY_OPTIONS_INIT, "options");
    const std::vector<glm::dvec3> eyes = eyes_of(read_these.eyes);
    const occlude::culler::SimplifyOptions how{
        .triangles = read_these.triangles, .eyes = eyes, .boxes = {.boxes = read_these.boxes, .cells = read_these.cells}};
    auto made = std::make_unique<occlude_simplified>();
    made->occluders = simplified_occluders(soup_of(read_data), how, checkpoint_of(read_data));
    for (const occlude::culler::OccluderOrigin& origin : made->occluders.origins) {
      made->polygons.push_back(origin.polygon);
      made->boxes.push_back(origin.box);
    }
    for (const auto& [box, polygon] : made->occluders.boxes) {
      made->inner_boxes.push_back({{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}});
    }
    *simplified = made.release();
  });
}

void occlude_simplified_destroy(occlude_simplified* simplified) noexcept { delete simplified; }

occlude_status occlude_simplified_occluders(const occlude_simplified* simplified, occlude_occluders* occluders) noexcept {
  return guarded([&] {
    require(simplified, "simplified");
    const auto& [soup, origins, boxes, drawn_triangles, flat_triangles] = simplified->occluders;
    occlude_occluders result = OCCLUDE_OCCLUDERS_INIT;
    result.vertices = {soup.vertices.data(), soup.vertices.size(), sizeof soup.vertices[0], OCCLUDE_DOUBLE};
    result.indices = soup.indices.data();
    result.polygons = simplified->polygons.data();
    result.boxes = simplified->boxes.data();
    result.triangle_count = origins.size();
    result.inner_boxes = simplified->inner_boxes.data();
    result.inner_box_count = boxes.size();
    result.drawn_triangles = drawn_triangles;
    result.flat_triangles = flat_triangles;
    write(result, occluders, "occluders");
  });
}
