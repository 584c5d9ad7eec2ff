// SPDX-License-Identifier: MIT
// Occluders of scenes of the C interface.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arrays.h"
#include "handles.h"
#include "ids.h"
#include "status.h"
#include "structs.h"

namespace occlude::c {
namespace {

culler::OccluderOptions to_options(const occlude_scene* scene, const occlude_occluder_options* given) {
  const auto options = read_options(given, occlude_occluder_options OCCLUDE_OCCLUDER_OPTIONS_INIT, "options");
  return {
      .moves = options.moves != 0,
      .is_one_sided = options.is_one_sided != 0,
      .mask = options.mask,
      .object = options.object.number == 0 ? culler::ObjectId() : known(scene, options.object, "object of the options: "),
      .weld = options.weld};
}

culler::Placement to_placement(const occlude_placement* given) {
  if (given == nullptr) return {};
  return {vec3(given->x), vec3(given->y), vec3(given->z), vec3(given->origin)};
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_scene_add_occluder(occlude_scene* scene, const occlude_mesh* mesh, const occlude_placement* placement,
                                          const occlude_occluder_options* options, occlude_occluder* occluder) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(mesh, "mesh");
    require(occluder, "occluder");
    *occluder = from_id(scene->scene.add(mesh->mesh, to_placement(placement), to_options(scene, options)));
  });
}

occlude_status occlude_scene_add_occluders(occlude_scene* scene, const occlude_mesh* mesh,
                                           const occlude_placement* placements, size_t count,
                                           const occlude_occluder_options* options, occlude_occluder* occluders) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(mesh, "mesh");
    if (count != 0) require(placements, "placements");
    if (count != 0) require(occluders, "occluders");
    const occlude::culler::OccluderOptions each = to_options(scene, options);
    std::fill_n(occluders, count, occlude_occluder OCCLUDE_NONE);
    std::vector<occlude::culler::Placement> all;
    for (const occlude_placement& placement : std::span(placements, count)) all.push_back(to_placement(&placement));
    std::vector<occlude::culler::OccluderId> ids(count);
    const auto write = [&] { std::ranges::transform(ids, occluders, [](const auto& id) { return from_id(id); }); };
    try {
      scene->scene.add(mesh->mesh, all, each, ids);
    } catch (...) {
      write();
      throw;
    }
    write();
  });
}

occlude_status occlude_scene_remove_occluder(occlude_scene* scene, occlude_occluder occluder) noexcept {
  return guarded([&] {
    const auto id = known(scene, occluder);
    scene->scene.remove(id);
  });
}

occlude_status occlude_scene_move_occluder(occlude_scene* scene, occlude_occluder occluder,
                                           const occlude_placement* placement) noexcept {
  return guarded([&] {
    const auto id = known(scene, occluder);
    scene->scene.move(id, to_placement(placement));
  });
}

occlude_status occlude_scene_replace_occluder(occlude_scene* scene, occlude_occluder occluder,
                                              const occlude_mesh* mesh) noexcept {
  return guarded([&] {
    const auto id = known(scene, occluder);
    require(mesh, "mesh");
    scene->scene.replace(id, mesh->mesh);
  });
}

occlude_status occlude_scene_enable_occluder(occlude_scene* scene, occlude_occluder occluder, int32_t is_enabled) noexcept {
  return guarded([&] {
    const auto id = known(scene, occluder);
    scene->scene.set_enabled(id, is_enabled != 0);
  });
}

occlude_status occlude_scene_mask_occluder(occlude_scene* scene, occlude_occluder occluder, uint32_t mask) noexcept {
  return guarded([&] {
    const auto id = known(scene, occluder);
    scene->scene.set_mask(id, mask);
  });
}

int32_t occlude_scene_has_occluder(const occlude_scene* scene, occlude_occluder occluder) noexcept {
  return scene != nullptr && scene->scene.contains(to_id(occluder)) ? 1 : 0;
}

size_t occlude_scene_occluders(const occlude_scene* scene) noexcept {
  return scene == nullptr ? 0 : scene->scene.occluders();
}
