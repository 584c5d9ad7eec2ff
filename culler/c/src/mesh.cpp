// SPDX-License-Identifier: MIT
// Meshes of the C interface.
#include <utility>

#include "handles.h"
#include "mesh_data.h"
#include "status.h"
#include "structs.h"

using namespace occlude::c;

occlude_status occlude_mesh_create(const occlude_mesh_data* data, occlude_mesh** mesh) noexcept {
  return guarded([&] {
    require(mesh, "mesh");
    const occlude_mesh_data read_data = read(data, occlude_mesh_data OCCLUDE_MESH_DATA_INIT, "data");
    auto made = std::make_shared<const occlude::culler::OccluderMesh>(soup_of(read_data), checkpoint_of(read_data));
    *mesh = new occlude_mesh{std::move(made)};
  });
}

void occlude_mesh_destroy(occlude_mesh* mesh) noexcept { delete mesh; }

size_t occlude_mesh_polygons(const occlude_mesh* mesh) noexcept { return mesh == nullptr ? 0 : mesh->mesh->size(); }

occlude_status occlude_mesh_box(const occlude_mesh* mesh, occlude_box* box) noexcept {
  return guarded([&] {
    require(mesh, "mesh");
    require(box, "box");
    const auto [min, max] = mesh->mesh->box();
    *box = {{min.x, min.y, min.z}, {max.x, max.y, max.z}};
  });
}
