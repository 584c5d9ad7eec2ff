// SPDX-License-Identifier: MIT
// Scenes of the C interface, and their objects.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "arrays.h"
#include "executors.h"
#include "handles.h"
#include "ids.h"
#include "status.h"
#include "structs.h"

namespace occlude::c {
namespace {

culler::ObjectOptions to_options(const occlude_object_options* given) {
  const auto options = read_options(given, occlude_object_options OCCLUDE_OBJECT_OPTIONS_INIT, "options");
  return {.moves = options.moves != 0, .is_always_drawn = options.is_always_drawn != 0, .mask = options.mask};
}

/// What a scene would refuse, found before anything is changed.
void require_legal(const Boxes& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string_view reason = culler::fault(boxes[i]);
    if (!reason.empty()) throw std::invalid_argument("box " + std::to_string(i) + ": " + std::string(reason));
  }
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_scene_create(occlude_scene** scene) noexcept {
  return guarded([&] {
    require(scene, "scene");
    *scene = new occlude_scene;
  });
}

void occlude_scene_destroy(occlude_scene* scene) noexcept { delete scene; }

occlude_status occlude_scene_add_object(occlude_scene* scene, const occlude_box* box, const occlude_object_options* options,
                                        occlude_object* object) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(object, "object");
    *object = from_id(scene->scene.add(to_box(box), to_options(options)));
  });
}

occlude_status occlude_scene_add_objects(occlude_scene* scene, const occlude_boxes* boxes,
                                         const occlude_object_options* options, occlude_object* objects) noexcept {
  return guarded([&] {
    require(scene, "scene");
    const Boxes all(boxes);
    if (all.size() != 0) require(objects, "objects");
    const occlude::culler::ObjectOptions each = to_options(options);
    require_legal(all);
    std::fill_n(objects, all.size(), occlude_object OCCLUDE_NONE);
    for (std::size_t i = 0; i < all.size(); ++i) objects[i] = from_id(scene->scene.add(all[i], each));
  });
}

occlude_status occlude_scene_remove_object(occlude_scene* scene, occlude_object object) noexcept {
  return guarded([&] {
    const auto id = known(scene, object);
    scene->scene.remove(id);
  });
}

occlude_status occlude_scene_remove_objects(occlude_scene* scene, const occlude_object* objects, size_t count) noexcept {
  return guarded([&] {
    require(scene, "scene");
    if (count != 0) require(objects, "objects");
    scene->scene.remove(known(*scene, {objects, count}));
  });
}

occlude_status occlude_scene_move_object(occlude_scene* scene, occlude_object object, const occlude_box* box) noexcept {
  return guarded([&] {
    const auto id = known(scene, object);
    scene->scene.move(id, to_box(box));
  });
}

occlude_status occlude_scene_move_objects(occlude_scene* scene, const occlude_object* objects,
                                          const occlude_boxes* boxes) noexcept {
  return guarded([&] {
    require(scene, "scene");
    const Boxes all(boxes);
    if (all.size() != 0) require(objects, "objects");
    const auto ids = known(*scene, {objects, all.size()});
    require_legal(all);
    for (std::size_t i = 0; i < all.size(); ++i) scene->scene.move(ids[i], all[i]);
  });
}

occlude_status occlude_scene_enable_object(occlude_scene* scene, occlude_object object, int32_t is_enabled) noexcept {
  return guarded([&] {
    const auto id = known(scene, object);
    scene->scene.set_enabled(id, is_enabled != 0);
  });
}

occlude_status occlude_scene_mask_object(occlude_scene* scene, occlude_object object, uint32_t mask) noexcept {
  return guarded([&] {
    const auto id = known(scene, object);
    scene->scene.set_mask(id, mask);
  });
}

int32_t occlude_scene_has_object(const occlude_scene* scene, occlude_object object) noexcept {
  return scene != nullptr && scene->scene.contains(to_id(object)) ? 1 : 0;
}

occlude_status occlude_scene_update(occlude_scene* scene) noexcept {
  return guarded([&] {
    require(scene, "scene");
    scene->scene.update();
  });
}

occlude_status occlude_scene_update_by(occlude_scene* scene, const occlude_executor* executor) noexcept {
  return guarded([&] {
    require(scene, "scene");
    scene->scene.update(to_executor(executor));
  });
}

size_t occlude_scene_objects(const occlude_scene* scene) noexcept { return scene == nullptr ? 0 : scene->scene.objects(); }

size_t occlude_scene_object_bytes(const occlude_scene* scene) noexcept {
  return scene == nullptr ? 0 : scene->scene.object_bytes();
}
