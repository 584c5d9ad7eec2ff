// SPDX-License-Identifier: MIT
// The kernel's question, answered by the oracle. A module by itself, because of its licences.
#include "occlude/oracle/oracle.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>

#include "numbers.h"

namespace occlude::python {
namespace {

oracle::Point to_point(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

oracle::Box to_oracle(const culler::Box& box) {
  if (const auto* aligned = std::get_if<kernel::Aabb>(&box)) {
    return oracle::Aabb{to_point(aligned->min), to_point(aligned->max)};
  }
  const auto& [center, edges] = std::get<kernel::Obb>(box);
  return oracle::Obb{to_point(center), {to_point(edges[0]), to_point(edges[1]), to_point(edges[2])}};
}

oracle::Occluder to_occluder(const Doubles& vertices, const py::object& faces) {
  oracle::Polytope polytope;
  for (const kernel::Vec3& v : to_points(vertices, "vertices")) polytope.vertices.push_back(to_point(v));
  if (faces.is_none()) return polytope.vertices;
  polytope.faces = to_loops(faces);
  return polytope;
}

/// As the frustum has it: by name, or the plane (normal, point) that was chosen for it.
oracle::Near to_near(const std::string& near, const py::object& support_plane) {
  using Kind = oracle::Near::Kind;
  if (support_plane.is_none()) {
    return {to_choice(near, "near", {std::pair{"surface", Kind::surface}, {"farthest", Kind::farthest}}), {}, {}};
  }
  const auto [normal, point] = support_plane.cast<std::pair<Doubles, Doubles>>();
  return {Kind::plane, to_point(to_vec3(normal, "normal")), to_point(to_vec3(point, "point"))};
}

py::array_t<std::uint8_t> relations(const Doubles& viewpoint, bool is_direction, const Doubles& vertices,
                                    const py::object& faces, const std::string& near, const py::object& support_plane,
                                    const Doubles& given) {
  const std::vector<culler::Box> boxes = to_boxes(given);
  const oracle::Viewpoint view{to_point(to_vec3(viewpoint, "viewpoint")), is_direction};
  const oracle::Occluder occluder = to_occluder(vertices, faces);
  const oracle::Near where = to_near(near, support_plane);
  std::vector<std::uint8_t> result;
  {
    const py::gil_scoped_release others_run;
    oracle::Shadow shadow(view, occluder, where);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto [refusal, relation] = shadow.relation(to_oracle(boxes[i]));
      if (!refusal.empty()) throw std::invalid_argument("box " + std::to_string(i) + ": " + refusal);
      result.push_back(static_cast<std::uint8_t>(relation));
    }
  }
  return to_array(std::move(result));
}

}  // namespace
}  // namespace occlude::python

PYBIND11_MODULE(_oracle, module) {
  using pybind11::literals::operator""_a;
  namespace py = pybind11;
  module.def("relations", &occlude::python::relations, "viewpoint"_a, "is_direction"_a, "vertices"_a, "faces"_a, "near"_a,
             "support_plane"_a, "boxes"_a);
}
