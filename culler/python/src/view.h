// SPDX-License-Identifier: MIT
// A view of a scene or of a model, which several Python threads may hold.
#pragma once

#include <cstddef>
#include <shared_mutex>
#include <string>
#include <variant>
#include <vector>

#include "numbers.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"

namespace occlude::python {

/// Python code may not crash the program, whatever its threads do. So a view is locked while it is used: by one thread that
/// culls with it, or by several that ask it. The lock is taken without the interpreter's, so that nothing waits for both.
struct AnyView {
  mutable std::shared_mutex mutex;
  culler::SceneView scene;
  culler::View model;
  bool is_of_scene = true;  ///< which of the two has the last frame
  // How the last frame of a scene was asked for.
  std::variant<std::monostate, culler::Camera, culler::MatrixCamera> camera;
  culler::SceneOptions options;
};

/// A frame's half-spaces: rows (a, b, c, d), a x + b y + c z + d >= 0 in view.
[[nodiscard]] py::array_t<double> to_array(const std::vector<culler::HalfSpace>& planes);

/// How the coarse picture is asked for.
[[nodiscard]] culler::CoverOptions to_cover_options(const std::pair<int, int>& size, const py::object& work,
                                                    const py::object& ms);

/// How far the eye may leave its way, and the camera turn.
[[nodiscard]] inline culler::AheadOptions to_way(double aside, double up, double turn_degrees) {
  return {.aside = aside, .up = up, .turn_degrees = turn_degrees};
}

/// "3 objects".
[[nodiscard]] inline std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}
/// What repr() says of things that no expression makes: "<occlude.Scene: 3 objects, 1 occluder>".
[[nodiscard]] inline std::string described(const std::string& type, const std::string& what) {
  return "<occlude." + type + ": " + what + ">";
}

void define_cameras(py::module_& module);
void define_matrix_cameras(py::module_& module);
void define_views(py::module_& module);
void define_scenes(py::module_& module);
void define_models(py::module_& module);
void define_held_culls(py::module_& module);
void define_faces(py::module_& module);
void define_simplified(py::module_& module);
void define_kernel(py::module_& module);

}  // namespace occlude::python
