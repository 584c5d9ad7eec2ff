// SPDX-License-Identifier: MIT
// Simplified occluders.
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "occlude/culler/simplified_occluders.h"
#include "view.h"

namespace occlude::python {
namespace {

using culler::OccluderOrigin;
using culler::SimplifiedOccluders;

SimplifiedOccluders simplify(const Doubles& vertices, const py::object& polygons, const py::object& sizes,
                             const py::object& see_through, std::size_t triangles, const std::vector<culler::Camera>& views,
                             std::size_t boxes, std::size_t cells, double inset) {
  const culler::PolygonSoup soup = to_soup(vertices, polygons, sizes, see_through);
  const py::gil_scoped_release others_run;
  return simplified_occluders(
      soup, {.triangles = triangles, .views = views, .boxes = {.boxes = boxes, .cells = cells}, .inset = inset});
}

py::array_t<double> vertices_of(const SimplifiedOccluders& simplified) {
  std::vector<double> numbers;
  for (const glm::dvec3& v : simplified.soup.vertices) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  return to_array(std::move(numbers), {static_cast<py::ssize_t>(simplified.soup.vertices.size()), 3});
}

py::array_t<std::uint32_t> triangles_of(const SimplifiedOccluders& simplified) {
  return to_array(simplified.soup.indices, {static_cast<py::ssize_t>(simplified.origins.size()), 3});
}

py::array_t<std::uint32_t> polygons_of(const SimplifiedOccluders& simplified) {
  std::vector<std::uint32_t> polygons;
  for (const OccluderOrigin& origin : simplified.origins) polygons.push_back(origin.polygon);
  return to_array(std::move(polygons));
}

py::array_t<std::int64_t> box_of_each(const SimplifiedOccluders& simplified) {
  std::vector<std::int64_t> boxes;
  for (const OccluderOrigin& origin : simplified.origins) {
    boxes.push_back(origin.box == OccluderOrigin::kNoBox ? -1 : std::int64_t{origin.box});
  }
  return to_array(std::move(boxes));
}

py::array_t<double> boxes_of(const SimplifiedOccluders& simplified) {
  std::vector<double> numbers;
  for (const auto& [box, polygon] : simplified.boxes) {
    numbers.insert(numbers.end(), {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
  }
  return to_array(std::move(numbers), {static_cast<py::ssize_t>(simplified.boxes.size()), 6});
}

}  // namespace

void define_simplified(py::module_& module) {
  using py::literals::operator""_a;
  const culler::SimplifyOptions defaults;
  py::class_<SimplifiedOccluders>(module, "SimplifiedOccluders", "Few triangles that hide for a mesh, the best first.")
      .def_property_readonly("vertices", &vertices_of, "Rows (x, y, z).")
      .def_property_readonly("triangles", &triangles_of, "Vertices, three a row: the polygons of an OccluderMesh.")
      .def_property_readonly("polygons", &polygons_of,
                             "Of each triangle, a polygon on which it lies, or the first of the part in which its box lies.")
      .def_property_readonly("box", &box_of_each, "Of each triangle, the row in `boxes` of which it is half a face, or -1.")
      .def_property_readonly("boxes", &boxes_of, "Inner boxes of closed parts, six numbers a row.")
      .def_readonly("drawn_triangles", &SimplifiedOccluders::drawn_triangles, "How many the mesh has.")
      .def_readonly("flat_triangles", &SimplifiedOccluders::flat_triangles, "How many do for all of them.")
      .def("__len__", [](const SimplifiedOccluders& simplified) { return simplified.origins.size(); })
      .def("__repr__", [](const SimplifiedOccluders& simplified) {
        return described("SimplifiedOccluders", count_of(simplified.origins.size(), "triangle"));
      });
  module.def(
      "simplified_occluders", &simplify, "vertices"_a, "polygons"_a, "sizes"_a = py::none(), py::kw_only(),
      "see_through"_a = py::none(), "triangles"_a = defaults.triangles, "views"_a = py::list(),
      "boxes"_a = defaults.boxes.boxes, "cells"_a = defaults.boxes.cells, "inset"_a = defaults.inset,
      "At most so many triangles that lie exactly on opaque polygons: those that hide most in all views together, "
      "or have the largest area. With boxes, halves of faces of so many inner boxes of each closed part as well, and with "
      "an inset, triangles inside of closed parts that are flat up to it: these hide for eyes alone that are never inside "
      "of one.");
}

}  // namespace occlude::python
