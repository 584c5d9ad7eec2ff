// SPDX-License-Identifier: MIT
// Simplified occluders, in the C interface.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cameras.h"
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

/// Structs of one version follow one another, whichever it is.
std::vector<culler::Camera> views_of(const occlude_simplify_options& options) {
  std::vector<culler::Camera> views;
  if (options.view_count == 0) return views;
  const std::size_t stride = said_size(options.views, sizeof *options.views, "views");
  const auto* at = reinterpret_cast<const std::byte*>(options.views);
  for (std::size_t i = 0; i < options.view_count; ++i, at += stride) {
    views.push_back(to_camera(reinterpret_cast<const occlude_look_at_camera*>(at)));
  }
  return views;
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
    const std::vector<occlude::culler::Camera> views = views_of(read_these);
    const occlude::culler::SimplifyOptions how{.triangles = read_these.triangles,
                                               .views = views,
                                               .boxes = {.boxes = read_these.boxes, .cells = read_these.cells},
                                               .inset = read_these.inset};
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
