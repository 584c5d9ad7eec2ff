// SPDX-License-Identifier: MIT
// Ids of the C interface, which are the numbers of those of C++.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "handles.h"
#include "occlude.h"
#include "occlude/culler/scene.h"
#include "status.h"

namespace occlude::c {

[[nodiscard]] inline culler::ObjectId to_id(occlude_object object) { return culler::ObjectId::from_number(object.number); }
[[nodiscard]] inline culler::OccluderId to_id(occlude_occluder occluder) {
  return culler::OccluderId::from_number(occluder.number);
}
[[nodiscard]] inline occlude_object from_id(culler::ObjectId id) { return {id.number()}; }
[[nodiscard]] inline occlude_occluder from_id(culler::OccluderId id) { return {id.number()}; }

/// An id of something that is in the scene. `place` is for the message.
template <class Id>
[[nodiscard]] auto known(const occlude_scene* scene, Id id, const char* place = "") {
  require(scene, "scene");
  if (const std::string reason = scene->scene.fault(to_id(id)); !reason.empty()) throw UnknownId(place + reason);
  return to_id(id);
}

/// The same of several.
[[nodiscard]] inline std::vector<culler::ObjectId> known(const occlude_scene& scene,
                                                         std::span<const occlude_object> objects) {
  std::vector<culler::ObjectId> ids;
  ids.reserve(objects.size());
  for (const occlude_object object : objects) {
    ids.push_back(to_id(object));
    if (scene.scene.contains(ids.back())) continue;
    static_cast<void>(known(&scene, object, ("object " + std::to_string(ids.size() - 1) + ": ").c_str()));
  }
  return ids;
}

}  // namespace occlude::c
