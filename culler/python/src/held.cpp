// SPDX-License-Identifier: MIT
#include "held.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model.h"
#include "scene.h"
#include "view.h"

namespace occlude::python {
namespace {

using culler::Culler;

culler::HeldOptions to_held_options(double aside, double up, double turn_degrees, bool repeatable) {
  return {.way = to_way(aside, up, turn_degrees), .is_repeatable = repeatable};
}

/// Python keeps the culler for as long as this.
class HeldModel {
 public:
  HeldModel(const Culler& culler, culler::HeldOptions options, const culler::CullOptions& cull, py::object later)
      : culler_(culler), held_(culler, std::move(options), cull, std::move(later)) {}

  template <class Camera>
  HeldFrame cull(const Camera& camera, double seconds) {
    std::vector<RangeRow> drawn;
    std::vector<std::uint32_t> polygons;
    const bool is_of_point = held_.use([&](culler::HeldCull& cull) {
      const culler::HeldResult& result = cull.cull(camera, seconds);
      append_drawn(culler_, result.drawn, drawn, polygons);
      return result.is_of_point;
    });
    held_.hand_on();
    return {to_array(std::move(drawn)), to_array(std::move(polygons)), is_of_point};
  }
  culler::HeldStats stats() {
    return held_.use([](const culler::HeldCull& cull) { return cull.stats(); });
  }

 private:
  const Culler& culler_;
  SharedHeld<culler::HeldCull> held_;
};

/// Python keeps the scene for as long as this.
class HeldScene {
 public:
  HeldScene(const SharedScene& scene, culler::HeldOptions options, const culler::SceneOptions& cull, std::size_t threads,
            py::object later)
      : scene_(scene),
        executor_(on_threads(threads)),
        held_(scene.scene(), std::move(options), with_executor(cull), std::move(later)) {}

  template <class Camera>
  SceneFrame cull(const Camera& camera, double seconds) {
    SceneRows rows = held_.use([&](culler::HeldSceneCull& cull) {
      const auto lock = scene_.keep_from_updates();
      return SceneRows(cull.cull(camera, seconds));
    });
    held_.hand_on();
    return to_frame(std::move(rows));
  }
  bool is_of_point() {
    return held_.use([](const culler::HeldSceneCull& cull) { return cull.is_of_point(); });
  }
  culler::HeldStats stats() {
    return held_.use([](const culler::HeldSceneCull& cull) { return cull.stats(); });
  }

 private:
  [[nodiscard]] culler::SceneOptions with_executor(culler::SceneOptions options) const {
    options.executor = &executor_;
    return options;
  }

  const SharedScene& scene_;
  culler::Executor executor_;
  SharedHeld<culler::HeldSceneCull> held_;
};

py::dict to_dict(const culler::HeldStats& stats) {
  using py::literals::operator""_a;
  return py::dict("frames"_a = stats.frames, "of_point"_a = stats.of_point, "regions"_a = stats.regions,
                  "around"_a = stats.around, "late"_a = stats.late);
}

/// What both kinds have.
template <class Held>
void define_common(py::class_<Held>& held, const char* name, const char* what) {
  using py::literals::operator""_a;
  held.def("cull", &Held::template cull<culler::Camera>, "camera"_a, "seconds"_a, what)
      .def("cull", &Held::template cull<culler::MatrixCamera>, "camera"_a, "seconds"_a, what)
      .def_property_readonly(
          "statistics", [](Held& h) { return to_dict(h.stats()); },
          "What became of the frames so far: how many `frames`, of these `of_point`, culled for themselves alone; `regions` "
          "that were culled, of these `around`, for all directions, and `late`, too late to hold.")
      .def("__repr__", [name](Held& h) {
        const culler::HeldStats stats = h.stats();
        return described(name, count_of(stats.frames, "frame") + ", " + std::to_string(stats.of_point) + " of point, " +
                                   count_of(stats.regions, "region"));
      });
}

constexpr const char* kOfModels =
    "Culls a model for one camera that moves, at a small part of the time of a cull for each frame: while one region of "
    "eyes holds, the next is culled beside it, for where the eye will be. No frame can be wrong by it. Regions reach "
    "`aside` and `up` from the way of the eye and hold for a camera that turns by turn_degrees, at least. They are culled "
    "on a thread of the module, or by `later`, such as the submit of an Executor: it is called with a function without "
    "parameters, which it calls on any thread, now or later, or never. The results of a cull that is `repeatable` do not "
    "depend on threads.";
constexpr const char* kOfScenes =
    "As HeldCull, of a scene. Each object is asked in each frame where it is then, so that objects may come, go and move. "
    "Occluders that move hide in frames for themselves alone.";

void define_held_models(py::module_& module) {
  using py::literals::operator""_a;
  const culler::HeldOptions held_defaults;
  const culler::CullOptions defaults;
  py::class_<HeldModel> held(module, "HeldCull", kOfModels);
  held.def(py::init([](const Culler& culler, double aside, double up, double turn_degrees, py::object later, bool repeatable,
                       const std::string& method, std::size_t occluders, std::size_t probes, const std::string& near,
                       const std::string& arithmetic, const std::string& test, double margin, bool unions,
                       const std::pair<int, int>& cover_size, const py::object& cover_work, const py::object& cover_ms) {
             const culler::CullOptions options = to_cull_options(method, occluders, probes, near, arithmetic, test, margin,
                                                                 unions, cover_size, cover_work, cover_ms);
             return std::make_unique<HeldModel>(culler, to_held_options(aside, up, turn_degrees, repeatable), options,
                                                std::move(later));
           }),
           py::keep_alive<1, 2>(), "culler"_a, py::kw_only(), "aside"_a = held_defaults.way.aside,
           "up"_a = held_defaults.way.up, "turn_degrees"_a = held_defaults.way.turn_degrees, "later"_a = py::none(),
           "repeatable"_a = false, "method"_a = "automatic", "occluders"_a = defaults.occluders,
           "probes"_a = defaults.probes, "near"_a = "surface", "arithmetic"_a = "certified", "test"_a = "conservative",
           "margin"_a = defaults.margin, "unions"_a = defaults.unions,
           "cover_size"_a = std::pair{defaults.cover.width, defaults.cover.height}, "cover_work"_a = py::none(),
           "cover_ms"_a = py::none());
  define_common(held, "HeldCull", "What to draw for the next frame, at this time, by any clock: a HeldFrame.");
}

void define_held_scenes(py::module_& module) {
  using py::literals::operator""_a;
  const culler::HeldOptions held_defaults;
  const culler::SceneOptions defaults;
  py::class_<HeldScene> held(module, "HeldSceneCull", kOfScenes);
  held.def(
      py::init([](const SharedScene& scene, double aside, double up, double turn_degrees, py::object later, bool repeatable,
                  const std::pair<int, int>& cover_size, const py::object& cover_work, const py::object& cover_ms,
                  double margin, std::uint32_t mask, float least_size, bool front_to_back, std::size_t threads) {
        const culler::SceneOptions options =
            to_scene_options(cover_size, cover_work, cover_ms, margin, mask, least_size, front_to_back);
        return std::make_unique<HeldScene>(scene, to_held_options(aside, up, turn_degrees, repeatable), options, threads,
                                           std::move(later));
      }),
      py::keep_alive<1, 2>(), "scene"_a, py::kw_only(), "aside"_a = held_defaults.way.aside, "up"_a = held_defaults.way.up,
      "turn_degrees"_a = held_defaults.way.turn_degrees, "later"_a = py::none(), "repeatable"_a = false,
      "cover_size"_a = std::pair{defaults.cover.width, defaults.cover.height}, "cover_work"_a = py::none(),
      "cover_ms"_a = py::none(), "margin"_a = defaults.margin, "mask"_a = defaults.mask,
      "least_size"_a = defaults.least_size, "front_to_back"_a = false, "threads"_a = 1);
  define_common(held, "HeldSceneCull", "What to draw for the next frame, at this time, by any clock: a SceneFrame.");
  held.def_property_readonly("is_of_point", &HeldScene::is_of_point, "Whether the last frame was culled for itself alone.");
}

}  // namespace

void define_held_culls(py::module_& module) {
  define_held_models(module);
  define_held_scenes(module);
}

}  // namespace occlude::python
