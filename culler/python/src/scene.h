// SPDX-License-Identifier: MIT
// Scenes and their frames, which several Python threads may hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "numbers.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/scene.h"

namespace occlude::python {

/// A scene that several Python threads may use at once, in any way.
class SharedScene {
 public:
  /// Runs work that may run beside changes: all that takes a const scene.
  template <class Work>
  auto look(Work&& work) const {
    const py::gil_scoped_release others_run;
    const std::shared_lock lock(updates_);
    return work(scene_);
  }
  /// Runs a change, one at a time.
  template <class Work>
  auto change(Work&& work) {
    const py::gil_scoped_release others_run;
    const std::shared_lock lock(updates_);
    const std::scoped_lock one(changes_);
    return work(scene_);
  }
  void update(const culler::Executor& executor) {
    const py::gil_scoped_release others_run;
    const std::unique_lock lock(updates_);
    scene_.update(executor);
  }
  /// For what culls the scene again and again. Frames keep from updates; regions that are culled beside them need not.
  [[nodiscard]] const culler::Scene& scene() const { return scene_; }
  [[nodiscard]] std::shared_lock<std::shared_mutex> keep_from_updates() const { return std::shared_lock(updates_); }

 private:
  culler::Scene scene_;
  mutable std::shared_mutex updates_;
  std::mutex changes_;
};

struct DrawnRow {
  std::uint64_t id;
  float size, distance;
};

/// A frame that Python keeps.
struct SceneFrame {
  py::array_t<DrawnRow> drawn;
  py::array_t<double> planes;
  py::dict statistics;
  py::array_t<std::uint64_t> idle_occluders;
};

/// The same before it is Python's: made while other threads run.
struct SceneRows {
  explicit SceneRows(const culler::SceneResult& result);

  std::vector<DrawnRow> drawn;
  std::vector<culler::HalfSpace> planes;
  culler::SceneStats stats;
  std::vector<std::uint64_t> idle_occluders;
};

[[nodiscard]] SceneFrame to_frame(SceneRows rows);

/// Threads that are started for each call. Throws std::invalid_argument for a number that is not legal.
[[nodiscard]] culler::Executor on_threads(std::size_t threads);

/// How frames are asked for.
[[nodiscard]] culler::SceneOptions to_scene_options(const std::pair<int, int>& cover_size, const py::object& cover_work,
                                                    const py::object& cover_ms, double margin, std::uint32_t mask,
                                                    float least_size, bool front_to_back);

}  // namespace occlude::python
