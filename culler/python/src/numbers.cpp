// SPDX-License-Identifier: MIT
#include "numbers.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "occlude/kernel/validity.h"

namespace occlude::python {
namespace {

std::string shape_of(const py::array& array) {
  return "has shape " + py::repr(py::tuple(array.attr("shape"))).cast<std::string>();
}

bool has_shape(const py::array& array, py::ssize_t flat, py::ssize_t rows) {
  return (array.ndim() == 2 && array.shape(1) == flat) ||
         (array.ndim() == 3 && array.shape(1) == rows && array.shape(2) == 3);
}

constexpr std::uint64_t kMostIndex = std::numeric_limits<std::uint32_t>::max();

/// Numbers of which it is known that 32 bits hold them.
std::vector<std::uint32_t> to_indices(const py::object& numbers, const char* name) {
  const std::vector<std::uint64_t> whole = to_whole(numbers, name, kMostIndex);
  std::vector<std::uint32_t> result;
  result.reserve(whole.size());
  for (const std::uint64_t number : whole) result.push_back(static_cast<std::uint32_t>(number));
  return result;
}

/// Whether it is an array whose rows are polygons with as many corners each.
bool is_table(const py::object& polygons) { return py::isinstance<py::array>(polygons) && py::array(polygons).ndim() == 2; }

void add_table(const py::array& polygons, culler::PolygonSoup& soup) {
  soup.indices = to_indices(polygons, "polygons");
  const auto corners = static_cast<std::size_t>(polygons.shape(1));
  for (py::ssize_t p = 1; p <= polygons.shape(0); ++p) {
    soup.first.push_back(culler::PolygonSoup::narrowed(static_cast<std::size_t>(p) * corners));
  }
}

void add_sizes(const py::object& polygons, const py::object& sizes, culler::PolygonSoup& soup) {
  soup.indices = to_indices(polygons, "polygons");
  std::uint64_t end = 0;
  for (const std::uint32_t size : to_indices(sizes, "sizes")) {
    end += size;
    soup.first.push_back(culler::PolygonSoup::narrowed(end));
  }
}

}  // namespace

void refuse_shape(const char* name, const py::array& array, const char* wanted) {
  throw std::invalid_argument(std::string(name) + " " + shape_of(array) + ", must be " + wanted);
}

kernel::Vec3 to_vec3(const Doubles& numbers, const char* name) {
  if (numbers.ndim() != 1 || numbers.shape(0) != 3) refuse_shape(name, numbers, "(3,)");
  return vec3_at(numbers.data());
}

std::vector<kernel::Vec3> to_points(const Doubles& points, const char* name) {
  if (points.ndim() != 2 || points.shape(1) != 3) refuse_shape(name, points, "(n, 3)");
  std::vector<kernel::Vec3> result;
  result.reserve(static_cast<std::size_t>(points.shape(0)));
  for (py::ssize_t i = 0; i < points.shape(0); ++i) result.push_back(vec3_at(points.data() + 3 * i));
  return result;
}

bool are_aligned(const Doubles& boxes) {
  const bool is_aligned = has_shape(boxes, 6, 2);
  if (!is_aligned && !has_shape(boxes, 12, 4)) {
    refuse_shape("boxes", boxes, "(n, 6) or (n, 2, 3), or (n, 12) or (n, 4, 3) if they are oriented");
  }
  return is_aligned;
}

std::vector<culler::Box> to_boxes(const Doubles& boxes) {
  const bool is_aligned = are_aligned(boxes);
  const double *at = boxes.data(), *const end = at + boxes.size();
  std::vector<culler::Box> result;
  result.reserve(static_cast<std::size_t>(boxes.shape(0)));
  for (; at != end; at += is_aligned ? 6 : 12) {
    if (is_aligned) {
      result.emplace_back(aligned_at(at));
    } else {
      result.emplace_back(oriented_at(at));
    }
  }
  return result;
}

culler::Box to_box(const Doubles& box) {
  const bool is_flat = box.ndim() == 1 && (box.shape(0) == 6 || box.shape(0) == 12);
  const bool is_rows = box.ndim() == 2 && (box.shape(0) == 2 || box.shape(0) == 4) && box.shape(1) == 3;
  if (!is_flat && !is_rows) refuse_shape("box", box, "(6,) or (2, 3), or (12,) or (4, 3) if it is oriented");
  return to_boxes(Doubles(box.attr("__getitem__")(py::none())))[0];
}

std::vector<std::uint64_t> to_whole(const py::object& numbers, const char* name, std::uint64_t most) {
  const py::array array = py::array::ensure(numbers);
  if (!array) throw py::error_already_set();
  const char kind = array.dtype().kind();
  if (array.size() == 0) return {};
  if (kind != 'i' && kind != 'u') throw std::invalid_argument(std::string(name) + " are not whole numbers");
  const bool has_sign = kind == 'i';
  if (has_sign && array.attr("min")().cast<std::int64_t>() < 0) {
    throw std::invalid_argument(std::string(name) + " has a number below 0");
  }
  const py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast> whole(array);
  std::vector<std::uint64_t> result(whole.data(), whole.data() + whole.size());
  for (const std::uint64_t number : result) {
    if (number > most) throw std::invalid_argument(std::string(name) + " has a number above " + std::to_string(most));
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> to_loops(const py::object& polygons) {
  std::vector<std::vector<std::uint32_t>> result;
  for (const py::handle polygon : polygons) {
    result.push_back(to_indices(py::reinterpret_borrow<py::object>(polygon), "polygons"));
  }
  return result;
}

std::vector<glm::dvec3> to_face(const Doubles& vertices, const std::vector<std::uint32_t>& loop) {
  const std::vector<kernel::Vec3> points = to_points(vertices, "vertices");
  if (loop.size() < 3) throw std::invalid_argument("the face has fewer than 3 corners");
  if (kernel::check_rounding() != kernel::Refusal::none) throw std::runtime_error("the processor does not round to nearest");
  std::vector<glm::dvec3> corners;
  for (const std::uint32_t index : loop) {
    if (index >= points.size())
      throw std::invalid_argument("vertex " + std::to_string(index) + " of " + std::to_string(points.size()));
    glm::dvec3& corner = corners.emplace_back();
    for (int axis = 0; axis < 3; ++axis) corner[axis] = kernel::flushed(points[index][axis]);
    const kernel::Refusal refusal = kernel::check(kernel::Vec3{corner.x, corner.y, corner.z});
    if (refusal == kernel::Refusal::none) continue;
    throw std::invalid_argument("vertex " + std::to_string(index) + ": " + std::string(kernel::to_string(refusal)));
  }
  return corners;
}

culler::PolygonSoup to_soup(const Doubles& vertices, const py::object& polygons, const py::object& sizes,
                            const py::object& see_through) {
  culler::PolygonSoup soup;
  for (const kernel::Vec3& v : to_points(vertices, "vertices")) soup.add_vertex({v.x, v.y, v.z});
  if (!sizes.is_none()) {
    add_sizes(polygons, sizes, soup);
  } else if (is_table(polygons)) {
    add_table(py::array(polygons), soup);
  } else {
    for (const std::vector<std::uint32_t>& loop : to_loops(polygons)) soup.add_polygon(loop);
  }
  if (!see_through.is_none()) {
    const py::array given = py::array::ensure(see_through);
    if (!given) throw py::error_already_set();
    if (std::string_view("biu").find(given.dtype().kind()) == std::string_view::npos)
      throw std::invalid_argument("see_through are not truth values");
    const py::array_t<bool, py::array::c_style | py::array::forcecast> marks(given);
    soup.see_through.assign(marks.data(), marks.data() + marks.size());
    if (soup.see_through.size() != soup.size()) throw std::invalid_argument("see_through has another length than polygons");
  }
  return soup;
}

}  // namespace occlude::python
