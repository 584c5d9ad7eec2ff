// SPDX-License-Identifier: MIT
// Held culls of the C interface.
#include <functional>
#include <memory>
#include <utility>

#include "cameras.h"
#include "frames.h"
#include "handles.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/held_cull.h"
#include "status.h"
#include "structs.h"

struct occlude_held_cull {
  occlude_held_cull(const occlude_scene& scene, const occlude_cull_options& options, occlude::culler::HeldOptions held)
      : executor(occlude::c::executor_of(options)), cull(scene.scene, std::move(held), with_executor(options)) {}

  occlude::culler::Executor executor;  ///< of its frames
  occlude::culler::HeldSceneCull cull;
  occlude::c::KeptFrame frame;  ///< the last one

 private:
  [[nodiscard]] occlude::culler::SceneOptions with_executor(const occlude_cull_options& options) const {
    occlude::culler::SceneOptions result = occlude::c::to_scene_options(options);
    result.executor = &executor;
    return result;
  }
};

namespace occlude::c {
namespace {

/// The caller's function, which is given a task that it owns until it calls it.
culler::Later to_later(const occlude_held_options& options) {
  using Task = std::function<void()>;
  if (options.later == nullptr) return {};
  return [later = options.later, context = options.context](Task task) {
    const auto call = [](void* work) { (*std::unique_ptr<Task>(static_cast<Task*>(work)))(); };
    later(context, call, new Task(std::move(task)));
  };
}

culler::HeldOptions to_held_options(const occlude_held_options& options) {
  culler::HeldOptions result{.later = to_later(options), .is_repeatable = options.is_repeatable != 0};
  if (options.way != nullptr) result.way = to_way(options.way);
  return result;
}

/// The next frame, by a camera of either kind.
template <class Camera>
occlude_status cull_next(occlude_held_cull* held, const Camera* camera, double seconds) {
  return guarded([&] {
    require(held, "held");
    held->frame.keep(held->cull.cull(to_camera(camera), seconds));
  });
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_held_cull_create(const occlude_scene* scene, const occlude_held_options* given,
                                        occlude_held_cull** held) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(held, "held");
    const auto options = read_options(given, occlude_held_options OCCLUDE_HELD_OPTIONS_INIT, "options");
    *held = new occlude_held_cull(*scene, read_cull_options(options.cull, "cull of the options"), to_held_options(options));
  });
}

void occlude_held_cull_destroy(occlude_held_cull* held) noexcept { delete held; }

occlude_status occlude_held_cull_next(occlude_held_cull* held, const occlude_matrix_camera* camera,
                                      double seconds) noexcept {
  return cull_next(held, camera, seconds);
}

occlude_status occlude_held_cull_next_look_at(occlude_held_cull* held, const occlude_look_at_camera* camera,
                                              double seconds) noexcept {
  return cull_next(held, camera, seconds);
}

occlude_status occlude_held_cull_frame(const occlude_held_cull* held, occlude_frame* frame) noexcept {
  return guarded([&] {
    require(held, "held");
    held->frame.write_to(frame);
  });
}

occlude_status occlude_held_cull_statistics(const occlude_held_cull* held, occlude_statistics* statistics) noexcept {
  return guarded([&] {
    require(held, "held");
    held->frame.write_to(statistics);
  });
}

int32_t occlude_held_cull_is_of_point(const occlude_held_cull* held) noexcept {
  return held != nullptr && held->cull.is_of_point() ? 1 : 0;
}

occlude_status occlude_held_cull_counts(const occlude_held_cull* held, occlude_held_counts* counts) noexcept {
  return guarded([&] {
    require(held, "held");
    const occlude::culler::HeldStats& stats = held->cull.stats();
    const occlude_held_counts values{
        .size = 0, .frames = stats.frames, .of_point = stats.of_point, .regions = stats.regions, .late = stats.late};
    write(values, counts, "counts");
  });
}
