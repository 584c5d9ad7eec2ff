// SPDX-License-Identifier: MIT
// The kernel's question in bulk: boxes against a shadow frustum.
#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "view.h"

namespace occlude::python {
namespace {

void require_none(kernel::Refusal refusal) {
  if (refusal != kernel::Refusal::none) throw std::invalid_argument(std::string(kernel::to_string(refusal)));
}

/// A frustum, and what it was made of, for the oracle.
struct Shadow {
  kernel::ShadowFrustum frustum;
  Doubles vertices;
  py::object faces;
  std::string near;
};

kernel::Viewpoint to_viewpoint(const py::object& eye, const py::object& direction) {
  if (eye.is_none() == direction.is_none()) throw std::invalid_argument("either an eye or a direction is needed");
  if (!eye.is_none()) return kernel::Viewpoint::eye(to_vec3(eye.cast<Doubles>(), "eye"));
  return kernel::Viewpoint::direction(to_vec3(direction.cast<Doubles>(), "direction"));
}

kernel::ShadowFrustumResult make(const kernel::Viewpoint& viewpoint, const std::vector<kernel::Vec3>& vertices,
                                 const py::object& faces, kernel::Near near) {
  if (faces.is_none()) return kernel::ShadowFrustum::make(viewpoint, vertices, near);
  const auto [polytope, refusal] = kernel::ConvexPolytope::make({vertices, to_loops(faces)});
  require_none(refusal);
  return kernel::ShadowFrustum::make(viewpoint, *polytope, near);
}

Shadow make_shadow(const Doubles& vertices, const py::object& faces, const py::object& eye, const py::object& direction,
                   const std::string& near) {
  const auto where =
      to_choice(near, "near", {std::pair{"surface", kernel::Near::surface}, {"farthest", kernel::Near::farthest}});
  kernel::ShadowFrustumResult made = make(to_viewpoint(eye, direction), to_points(vertices, "vertices"), faces, where);
  require_none(made.refusal);
  return {std::move(*made.frustum), Doubles(vertices.attr("copy")()), faces, near};
}

struct Question {
  kernel::Arithmetic arithmetic;
  kernel::Test test;
  kernel::NearBoundary boundary;
};

Question to_question(const std::string& arithmetic, const std::string& test, const std::string& boundary) {
  return {
      to_choice(arithmetic, "arithmetic",
                {std::pair{"certified", kernel::Arithmetic::certified}, {"plain", kernel::Arithmetic::plain}}),
      to_choice(test, "test", {std::pair{"overlap", kernel::Test::overlap}, {"conservative", kernel::Test::conservative}}),
      to_choice(boundary, "near_boundary",
                {std::pair{"closed", kernel::NearBoundary::closed}, {"open", kernel::NearBoundary::open}})};
}

py::tuple relations(const Shadow& shadow, const Doubles& given, const std::string& arithmetic, const std::string& test,
                    const std::string& near_boundary) {
  const Question q = to_question(arithmetic, test, near_boundary);
  const std::vector<culler::Box> boxes = to_boxes(given);
  std::vector<std::uint8_t> relation(boxes.size()), stage(boxes.size());
  {
    const py::gil_scoped_release others_run;
    require_none(kernel::check_rounding());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto refusal = std::visit([](const auto& box) { return kernel::check(box); }, boxes[i]);
      if (refusal != kernel::Refusal::none) {
        throw std::invalid_argument("box " + std::to_string(i) + ": " + std::string(kernel::to_string(refusal)));
      }
      const auto decide = [&](const auto& box) {
        return kernel::decide(shadow.frustum, box, q.arithmetic, q.test, q.boundary);
      };
      const kernel::Decision decision = std::visit(decide, boxes[i]);
      relation[i] = static_cast<std::uint8_t>(decision.relation);
      stage[i] = static_cast<std::uint8_t>(decision.stage);
    }
  }
  return py::make_tuple(to_array(std::move(relation)), to_array(std::move(stage)));
}

py::array_t<double> vec3_array(const kernel::Vec3& v) { return to_array(std::vector<double>{v.x, v.y, v.z}); }

/// The near plane that was chosen for a polygon that is not coplanar: (normal, point), or None.
py::object support_plane(const Shadow& shadow) {
  const std::optional<kernel::SupportPlane>& plane = shadow.frustum.support_plane();
  if (!plane) return py::none();
  return py::make_tuple(vec3_array(plane->normal), vec3_array(plane->point));
}

}  // namespace

void define_kernel(py::module_& module) {
  using py::literals::operator""_a;
  py::class_<Shadow>(module, "ShadowFrustum",
                     "What a convex polygon, or a convex polytope if there are faces, hides from an eye or along a "
                     "direction.")
      .def(py::init(&make_shadow), "vertices"_a, "faces"_a = py::none(), py::kw_only(), "eye"_a = py::none(),
           "direction"_a = py::none(), "near"_a = "surface")
      .def("relations", &relations, "boxes"_a, py::kw_only(), "arithmetic"_a = "certified", "test"_a = "overlap",
           "near_boundary"_a = "closed",
           "The relation of each box to the shadow, and the stage that decided: arrays of Relation and Stage.")
      .def_readonly("vertices", &Shadow::vertices)
      .def_readonly("faces", &Shadow::faces)
      .def_readonly("near", &Shadow::near)
      .def_property_readonly("viewpoint", [](const Shadow& s) { return vec3_array(s.frustum.viewpoint().value); })
      .def_property_readonly("is_direction", [](const Shadow& s) { return !s.frustum.viewpoint().is_eye(); })
      .def_property_readonly("support_plane", &support_plane);
}

}  // namespace occlude::python
