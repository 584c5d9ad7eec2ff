// SPDX-License-Identifier: MIT
// Views and frames of the C interface.
#include "frames.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "arrays.h"
#include "cameras.h"
#include "executors.h"
#include "handles.h"
#include "ids.h"
#include "status.h"
#include "structs.h"

namespace occlude::c {
namespace {

/// A limit of the caller, of which 0 is none.
template <class To, class From>
To limit(From given, To none) {
  if (given == From{0}) return none;
  return static_cast<To>(std::min<From>(given, static_cast<From>(std::numeric_limits<To>::max())));
}

/// The next frame of the view, by a camera of either kind; with `held`, one that is held against that view's.
template <class Camera, class... Held>
occlude_status cull(const occlude_scene* scene, const Camera* given, const occlude_cull_options* given_options,
                    occlude_view* view, const Held*... held) {
  return guarded([&] {
    require(scene, "scene");
    require(view, "view");
    (require(held, "held"), ...);
    const auto camera = to_camera(given);
    const auto options = read_cull_options(given_options, "options");
    const culler::Executor executor = executor_of(options);
    culler::SceneOptions asked = to_scene_options(options);
    asked.executor = &executor;
    view->frame.keep(scene->scene.cull(camera, asked, held->view..., view->view));
    view->camera = camera;
    asked.executor = nullptr;  // it is of this frame alone
    view->options = asked;
  });
}

/// Whether the last frame of the view does for a camera of either kind.
template <class Camera>
occlude_status holds_for(const occlude_view* view, const Camera* camera, std::int32_t* holds) {
  return guarded([&] {
    require(view, "view");
    require(holds, "holds");
    *holds = view->view.holds_for(to_camera(camera)) ? 1 : 0;
  });
}

/// Whether frames can be held against it.
template <class Camera>
occlude_status scene_holds(const occlude_scene* scene, const occlude_view* held, const Camera* camera,
                           const occlude_cull_options* options, std::int32_t* holds) {
  return guarded([&] {
    require(scene, "scene");
    require(held, "held");
    require(holds, "holds");
    const culler::SceneOptions asked = to_scene_options(read_cull_options(options, "options"));
    *holds = scene->scene.holds(held->view, to_camera(camera), asked) ? 1 : 0;
  });
}

std::vector<culler::ObjectFate> fates_of(const occlude_scene& scene, const occlude_view& view,
                                         std::span<const culler::ObjectId> objects) {
  if (const auto* camera = std::get_if<culler::Camera>(&view.camera)) {
    return scene.scene.why(*camera, view.options, view.view, objects);
  }
  if (const auto* camera = std::get_if<culler::MatrixCamera>(&view.camera)) {
    return scene.scene.why(*camera, view.options, view.view, objects);
  }
  throw std::invalid_argument("the view has no frame");
}

occlude_reason to_reason(culler::ObjectFate::Reason reason) {
  using Reason = culler::ObjectFate::Reason;
  switch (reason) {
    case Reason::drawn:
      return OCCLUDE_DRAWN;
    case Reason::always_drawn:
      return OCCLUDE_ALWAYS_DRAWN;
    case Reason::out_of_view:
      return OCCLUDE_OUT_OF_PLANE;
    case Reason::hidden:
      return OCCLUDE_HIDDEN;
    case Reason::too_small:
      return OCCLUDE_TOO_SMALL;
    case Reason::in_no_layer:
      return OCCLUDE_IN_NO_LAYER;
    case Reason::not_in_scene:
      break;
  }
  return OCCLUDE_NOT_IN_SCENE;
}

/// Writes the fates. Their arrays are memory of the view, which is taken first, so that it stays where it is.
void copy_fates(const std::vector<culler::ObjectFate>& from, occlude_view& view, occlude_fate* to) {
  std::size_t hiding = 0, corners = 0;
  for (const culler::ObjectFate& fate : from) {
    hiding += fate.by.size();
    for (const auto& by : fate.by) corners += 3 * by.corners.size();
  }
  view.hiding.clear();
  view.hiding.reserve(hiding);
  view.corners.clear();
  view.corners.reserve(corners);
  for (const culler::ObjectFate& fate : from) {
    *to++ = {to_reason(fate.reason), fate.plane, fate.by.size(), view.hiding.data() + view.hiding.size()};
    for (const auto& by : fate.by) {
      view.hiding.push_back({from_id(by.occluder), by.polygon, static_cast<std::uint32_t>(by.corners.size()),
                             view.corners.data() + view.corners.size()});
      for (const kernel::Vec3& v : by.corners) view.corners.insert(view.corners.end(), {v.x, v.y, v.z});
    }
  }
}

occlude_visibility to_visibility(culler::Visibility visibility) {
  switch (visibility) {
    case culler::Visibility::occluded:
      return OCCLUDE_OCCLUDED;
    case culler::Visibility::out_of_view:
      return OCCLUDE_OUT_OF_VIEW;
    case culler::Visibility::visible:
      break;
  }
  return OCCLUDE_VISIBLE;
}

}  // namespace

void KeptFrame::keep(const culler::SceneResult& result) {
  objects_.clear();
  sizes_.clear();
  distances_.clear();
  planes_.clear();
  idle_occluders_.clear();
  const std::size_t room = result.drawn.capacity();
  objects_.reserve(room);
  sizes_.reserve(room);
  distances_.reserve(room);
  idle_occluders_.reserve(result.idle_occluders.capacity());
  for (const culler::DrawnObject& drawn : result.drawn) {
    objects_.push_back(from_id(drawn.id));
    sizes_.push_back(drawn.size);
    distances_.push_back(drawn.distance);
  }
  for (const auto& [normal, offset] : result.view) planes_.push_back({{normal.x, normal.y, normal.z}, offset});
  for (const culler::OccluderId id : result.idle_occluders) idle_occluders_.push_back(from_id(id));
  stats_ = result.stats;
}

void KeptFrame::write_to(occlude_frame* frame) const {
  const occlude_frame values{.size = 0,
                             .count = objects_.size(),
                             .objects = objects_.data(),
                             .sizes = sizes_.data(),
                             .distances = distances_.data(),
                             .planes = planes_.data(),
                             .plane_count = planes_.size(),
                             .idle_occluders = idle_occluders_.data(),
                             .idle_occluder_count = idle_occluders_.size()};
  write(values, frame, "frame");
}

void KeptFrame::write_to(occlude_statistics* statistics) const {
  const occlude_statistics values{.size = 0,
                                  .drawn = stats_.drawn,
                                  .out_of_view = stats_.out_of_view,
                                  .hidden = stats_.hidden,
                                  .too_small = stats_.too_small,
                                  .occluders = stats_.occluders,
                                  .nodes_visited = stats_.work.nodes_visited,
                                  .view_tests = stats_.work.view_tests,
                                  .cover_tests = stats_.work.cover_tests,
                                  .cover_groups = stats_.work.cover_groups,
                                  .cover_groups_left = stats_.work.cover_groups_left,
                                  .cover_triangles = stats_.work.cover_triangles,
                                  .cover_work = stats_.work.cover_work.drawing};
  write(values, statistics, "statistics");
}

occlude_cull_options read_cull_options(const occlude_cull_options* given, const char* name) {
  return read_options(given, occlude_cull_options OCCLUDE_CULL_OPTIONS_INIT, name);
}

culler::Executor executor_of(const occlude_cull_options& options) {
  return options.executor == nullptr ? culler::Executor() : to_executor(options.executor);
}

culler::SceneOptions to_scene_options(const occlude_cull_options& options) {
  const culler::CoverOptions none;
  return {.cover = {.width = options.cover_width,
                    .height = options.cover_height,
                    .work = limit<std::size_t>(options.cover_work, none.work),
                    .ms = options.cover_ms == 0 ? none.ms : options.cover_ms,
                    .as_before = {}},
          .margin = options.margin,
          .mask = options.mask,
          .least_size = options.least_size,
          .is_front_to_back = options.is_front_to_back != 0,
          .is_to_be_held = options.is_to_be_held != 0,
          .is_adaptive = options.is_adaptive != 0};
}

}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_view_create(occlude_view** view) noexcept {
  return guarded([&] {
    require(view, "view");
    *view = new occlude_view;
  });
}

void occlude_view_destroy(occlude_view* view) noexcept { delete view; }

occlude_status occlude_scene_cull(const occlude_scene* scene, const occlude_matrix_camera* camera,
                                  const occlude_cull_options* options, occlude_view* view) noexcept {
  return cull(scene, camera, options, view);
}

occlude_status occlude_scene_cull_look_at(const occlude_scene* scene, const occlude_look_at_camera* camera,
                                          const occlude_cull_options* options, occlude_view* view) noexcept {
  return cull(scene, camera, options, view);
}

occlude_status occlude_view_holds_for(const occlude_view* view, const occlude_matrix_camera* camera,
                                      int32_t* holds) noexcept {
  return holds_for(view, camera, holds);
}

occlude_status occlude_view_holds_for_look_at(const occlude_view* view, const occlude_look_at_camera* camera,
                                              int32_t* holds) noexcept {
  return holds_for(view, camera, holds);
}

occlude_status occlude_scene_holds(const occlude_scene* scene, const occlude_view* held, const occlude_matrix_camera* camera,
                                   const occlude_cull_options* options, int32_t* holds) noexcept {
  return scene_holds(scene, held, camera, options, holds);
}

occlude_status occlude_scene_holds_look_at(const occlude_scene* scene, const occlude_view* held,
                                           const occlude_look_at_camera* camera, const occlude_cull_options* options,
                                           int32_t* holds) noexcept {
  return scene_holds(scene, held, camera, options, holds);
}

occlude_status occlude_scene_cull_held(const occlude_scene* scene, const occlude_matrix_camera* camera,
                                       const occlude_cull_options* options, const occlude_view* held,
                                       occlude_view* view) noexcept {
  return cull(scene, camera, options, view, held);
}

occlude_status occlude_scene_cull_held_look_at(const occlude_scene* scene, const occlude_look_at_camera* camera,
                                               const occlude_cull_options* options, const occlude_view* held,
                                               occlude_view* view) noexcept {
  return cull(scene, camera, options, view, held);
}

occlude_status occlude_view_frame(const occlude_view* view, occlude_frame* frame) noexcept {
  return guarded([&] {
    require(view, "view");
    view->frame.write_to(frame);
  });
}

occlude_status occlude_view_statistics(const occlude_view* view, occlude_statistics* statistics) noexcept {
  return guarded([&] {
    require(view, "view");
    view->frame.write_to(statistics);
  });
}

occlude_status occlude_view_visibility(const occlude_view* view, const occlude_boxes* boxes,
                                       occlude_visibility* visibilities) noexcept {
  return guarded([&] {
    require(view, "view");
    const Boxes all(boxes);
    if (all.size() != 0) require(visibilities, "visibilities");
    for (std::size_t i = 0; i < all.size(); ++i) {
      try {
        visibilities[i] = to_visibility(view->view.visibility(all[i]));
      } catch (const std::invalid_argument& e) {
        throw std::invalid_argument("box " + std::to_string(i) + ": " + e.what());
      }
    }
  });
}

occlude_status occlude_scene_why(const occlude_scene* scene, occlude_view* view, const occlude_object* objects, size_t count,
                                 occlude_fate* fates) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(view, "view");
    if (count != 0) require(objects, "objects");
    if (count != 0) require(fates, "fates");
    copy_fates(fates_of(*scene, *view, known(*scene, {objects, count})), *view, fates);
  });
}
