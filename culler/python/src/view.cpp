// SPDX-License-Identifier: MIT
#include "view.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <shared_mutex>
#include <stdexcept>
#include <string>

#include "occlude/culler/camera.h"

namespace occlude::python {
namespace {

using culler::Camera;
using culler::EyeRegion;

glm::dvec3 to_dvec3(const Doubles& v, const char* name) {
  const auto [x, y, z] = to_vec3(v, name);
  return {x, y, z};
}

Camera make_camera(const Doubles& eye, const Doubles& target, const Doubles& up, const std::string& projection,
                   double fov_y_deg, double height, double aspect, double near, double far, const EyeRegion& eyes) {
  const Camera camera{.eye = to_dvec3(eye, "eye"),
                      .target = to_dvec3(target, "target"),
                      .up = to_dvec3(up, "up"),
                      .projection = to_choice(projection, "projection",
                                              {std::pair{"perspective", culler::Projection::perspective},
                                               {"orthographic", culler::Projection::orthographic}}),
                      .fov_y_deg = fov_y_deg,
                      .height = height,
                      .aspect = aspect,
                      .near_plane = near,
                      .far_plane = far,
                      .eyes = eyes};
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument(reason);
  return camera;
}

py::tuple list(const glm::dvec3& v) { return py::make_tuple(v.x, v.y, v.z); }

/// As it is made.
py::object to_text(const EyeRegion& eyes) {
  if (eyes.radius != 0) return py::str("occlude.EyeRegion.ball({})").format(eyes.radius);
  const auto& [a, b, c] = eyes.half_edges;
  return py::str("occlude.EyeRegion.box({}, {}, {})").format(list(a), list(b), list(c));
}

/// As it is made.
py::object to_text(const Camera& c) {
  const char* projection = c.projection == culler::Projection::perspective ? "perspective" : "orthographic";
  return py::str(
             "occlude.Camera(eye={}, target={}, up={}, projection={!r}, fov_y_deg={}, height={}, aspect={}, near={}, "
             "far={}, eyes={})")
      .format(list(c.eye), list(c.target), list(c.up), projection, c.fov_y_deg, c.height, c.aspect, c.near_plane,
              c.far_plane, to_text(c.eyes));
}

culler::ClipDepth to_depth(const std::string& depth) {
  return to_choice(
      depth, "depth",
      {std::pair{"minus_w_to_w", culler::ClipDepth::minus_w_to_w}, {"zero_to_w", culler::ClipDepth::zero_to_w}});
}

/// A TypeError with this text for what is not of the type.
template <class T>
T to_option(const py::object& option, const char* text) {
  try {
    return option.cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(text);
  }
}

culler::Nearer to_nearer(const std::string& nearer) {
  return to_choice(nearer, "nearer", {std::pair{"less", culler::Nearer::less}, {"greater", culler::Nearer::greater}});
}

culler::MatrixCamera make_matrix_camera(const Doubles& matrix, const std::string& depth, const py::object& nearer,
                                        const EyeRegion& eyes) {
  if (matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4) {
    throw std::invalid_argument("matrix must have shape (4, 4)");
  }
  culler::MatrixCamera camera;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) camera.matrix[column][row] = matrix.at(row, column);
  }
  camera.depth = to_depth(depth);
  if (!nearer.is_none()) camera.nearer = to_nearer(to_option<std::string>(nearer, "nearer is no text"));
  camera.eyes = eyes;
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument(reason);
  return camera;
}

std::vector<double> rows_of(const glm::dmat4& matrix) {
  std::vector<double> numbers;
  for (int i = 0; i < 16; ++i) numbers.push_back(matrix[i % 4][i / 4]);
  return numbers;
}

py::object to_text(const culler::MatrixCamera& c) {
  py::list rows;
  for (int row = 0; row < 4; ++row)
    rows.append(py::make_tuple(c.matrix[0][row], c.matrix[1][row], c.matrix[2][row], c.matrix[3][row]));
  const char* depth = c.depth == culler::ClipDepth::minus_w_to_w ? "minus_w_to_w" : "zero_to_w";
  py::object nearer = py::none();
  if (c.nearer != culler::Nearer::unsaid) nearer = py::str(c.nearer == culler::Nearer::less ? "less" : "greater");
  return py::str("occlude.MatrixCamera({}, depth={!r}, nearer={!r}, eyes={})").format(rows, depth, nearer, to_text(c.eyes));
}

std::string to_text(const AnyView& view) {
  const py::gil_scoped_release others_run;
  const std::shared_lock lock(view.mutex);
  if (!view.is_of_scene) {
    return described("View", "of a model, " + count_of(view.model.result().stats.drawn_polygons, "polygon") + " drawn");
  }
  if (std::holds_alternative<std::monostate>(view.camera)) return described("View", "no frame");
  return described("View", "of a scene, " + count_of(view.scene.result().drawn.size(), "object") + " drawn");
}

std::vector<std::uint8_t> visibilities(const AnyView& view, const std::vector<culler::Box>& boxes) {
  const py::gil_scoped_release others_run;
  const std::shared_lock lock(view.mutex);
  std::vector<std::uint8_t> result;
  result.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    try {
      const culler::Visibility seen = view.is_of_scene ? view.scene.visibility(boxes[i]) : view.model.visibility(boxes[i]);
      result.push_back(static_cast<std::uint8_t>(seen));
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument("box " + std::to_string(i) + ": " + e.what());
    }
  }
  return result;
}

/// What depends on the kind of camera.
template <class Camera>
void define_for(py::module_& module, py::class_<AnyView>& view) {
  using py::literals::operator""_a;
  view.def(
      "holds_for",
      [](const AnyView& v, const Camera& camera) {
        const py::gil_scoped_release others_run;
        const std::shared_lock lock(v.mutex);
        return v.is_of_scene ? v.scene.holds_for(camera) : v.model.holds_for(camera);
      },
      "camera"_a,
      "Whether the last frame does for this camera, too: it leaves out nothing that the camera shows from its eye and from "
      "all of its `eyes`. Never true by rounding, and not before the first frame.");
  const culler::AheadOptions defaults;
  module.def(
      "ahead",
      [](const Camera& camera, const Doubles& velocity, double seconds, double aside, double up, double turn_degrees) {
        const auto [x, y, z] = to_vec3(velocity, "velocity");
        return ahead(camera, {x, y, z}, seconds, to_way(aside, up, turn_degrees));
      },
      "camera"_a, "velocity"_a, "seconds"_a, py::kw_only(), "aside"_a = defaults.aside, "up"_a = defaults.up,
      "turn_degrees"_a = defaults.turn_degrees,
      "A Camera from the middle of the way that the eye takes in so many seconds, with all eyes near the way: up to `aside` "
      "beside it and `up` above and below. A frame of it holds (View.holds_for) for a camera with the same picture that is "
      "anywhere there, turned by up to turn_degrees.");
}

}  // namespace

py::array_t<double> to_array(const std::vector<culler::HalfSpace>& planes) {
  std::vector<double> numbers;
  for (const auto& [normal, offset] : planes) numbers.insert(numbers.end(), {normal.x, normal.y, normal.z, offset});
  return to_array(std::move(numbers), {static_cast<py::ssize_t>(planes.size()), 4});
}

culler::CoverOptions to_cover_options(const std::pair<int, int>& size, const py::object& work, const py::object& ms) {
  culler::CoverOptions options{.width = size.first, .height = size.second};
  if (!work.is_none()) options.work = to_option<std::size_t>(work, "cover_work is no number from 0 on");
  if (!ms.is_none()) options.ms = to_option<double>(ms, "cover_ms is no number");
  return options;
}

void define_cameras(py::module_& module) {
  using py::literals::operator""_a;
  py::class_<EyeRegion>(module, "EyeRegion",
                        "Where the eye may be, relative to a camera's: EyeRegion.ball(radius), EyeRegion.box(a, b, c) with "
                        "half-edges. What is culled for such a camera is hidden from every eye of the region.")
      .def_static("ball", &EyeRegion::ball, "radius"_a)
      .def_static(
          "box",
          [](const Doubles& a, const Doubles& b, const Doubles& c) {
            return EyeRegion::box(to_dvec3(a, "a"), to_dvec3(b, "b"), to_dvec3(c, "c"));
          },
          "a"_a, "b"_a = std::vector<double>{0, 0, 0}, "c"_a = std::vector<double>{0, 0, 0})
      .def("__repr__", [](const EyeRegion& eyes) { return to_text(eyes); });
  py::class_<Camera>(module, "Camera", "A right-handed camera that looks from `eye` to `target`.")
      .def(py::init(&make_camera), "eye"_a, "target"_a, "up"_a = std::vector<double>{0, 0, 1},
           "projection"_a = "perspective", "fov_y_deg"_a = Camera{}.fov_y_deg, "height"_a = Camera{}.height,
           "aspect"_a = Camera{}.aspect, "near"_a = Camera{}.near_plane, "far"_a = Camera{}.far_plane,
           "eyes"_a = EyeRegion{})
      .def("__repr__", [](const Camera& camera) { return to_text(camera); });
}

void define_matrix_cameras(py::module_& module) {
  using py::literals::operator""_a;
  module.def(
      "margin_for",
      [](double rows, double pixels) {
        if (!(rows > 0)) throw std::invalid_argument("a picture has more than 0 rows");
        return culler::margin_for(rows, pixels);
      },
      "rows"_a, "pixels"_a = culler::kPixelMargin, "The margin of a frame for a picture of so many rows of pixels.");
  py::class_<culler::MatrixCamera>(
      module, "MatrixCamera",
      "Any projective matrix: matrix @ (x, y, z, 1) is a point in clip space. The depth is 'minus_w_to_w', as in OpenGL, "
      "or 'zero_to_w', as in Vulkan, Direct3D and Metal. With parallel rays, 'less' or 'greater' is nearer.")
      .def(py::init(&make_matrix_camera), "matrix"_a, "depth"_a, "nearer"_a = py::none(), "eyes"_a = EyeRegion{})
      .def_static(
          "from_camera",
          [](const Camera& camera, const std::string& depth, const std::string& nearer) {
            return culler::MatrixCamera::from_camera(camera, to_depth(depth), to_nearer(nearer));
          },
          "camera"_a, "depth"_a, "nearer"_a,
          "What a Camera shows. With nearer='greater' and no far plane, depth is reversed and infinite.")
      .def("__repr__", [](const culler::MatrixCamera& camera) { return to_text(camera); })
      .def_property_readonly(
          "matrix",
          [](const culler::MatrixCamera& camera) {
            return to_array(rows_of(camera.matrix), {4, 4});
          },
          "Four rows of four numbers.")
      .def_property_readonly(
          "eye",
          [](const culler::MatrixCamera& camera) {
            const glm::dvec3 eye = camera.eye();
            return to_array(std::vector<double>{eye.x, eye.y, eye.z});
          },
          "Where one looks from, up to rounding; with parallel rays, a point of the near plane.");
}

void define_views(py::module_& module) {
  using py::literals::operator""_a;
  py::class_<AnyView> view(module, "View", "One camera from frame to frame, of any scene or model.");
  view.def(py::init<>())
      .def("__repr__", [](const AnyView& v) { return to_text(v); })
      .def(
          "visibility", [](const AnyView& v, const Doubles& boxes) { return to_array(visibilities(v, to_boxes(boxes))); },
          "boxes"_a,
          "Whether boxes would be visible in the last frame: an array of Visibility. Before the first frame all are.");
  define_for<Camera>(module, view);
  define_for<culler::MatrixCamera>(module, view);
}

}  // namespace occlude::python
