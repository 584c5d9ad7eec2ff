// SPDX-License-Identifier: MIT
// Arrays of NumPy as the library's geometry, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::python {

namespace py = pybind11;

/// Numbers of any type and with any strides, as doubles.
using Doubles = py::array_t<double, py::array::forcecast>;

/// Throws std::invalid_argument, which is ValueError in Python: "boxes has shape (6,), must be …".
[[noreturn]] void refuse_shape(const char* name, const py::array& array, const char* wanted);

// All of these throw it, too, for arrays of another shape or type.

/// Shape (3).
[[nodiscard]] kernel::Vec3 to_vec3(const Doubles& numbers, const char* name);
/// Shape (n, 3).
[[nodiscard]] std::vector<kernel::Vec3> to_points(const Doubles& points, const char* name);
/// Shape (n, 6) or (n, 2, 3): axis-aligned; (n, 12) or (n, 4, 3): oriented.
[[nodiscard]] std::vector<culler::Box> to_boxes(const Doubles& boxes);
/// The same without n.
[[nodiscard]] culler::Box to_box(const Doubles& box);
/// Whole numbers of any shape, one after another, each at most `most`.
[[nodiscard]] std::vector<std::uint64_t> to_whole(const py::object& numbers, const char* name, std::uint64_t most);
/// Polygons: an array (m, k), all with k corners; a sequence of sequences; or, with sizes, one loop after another.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> to_loops(const py::object& polygons);
/// `see_through` is None, or tells of each polygon whether it hides nothing.
[[nodiscard]] culler::PolygonSoup to_soup(const Doubles& vertices, const py::object& polygons, const py::object& sizes,
                                          const py::object& see_through);
/// The corners of one face, and the loop of these alone. Numbers nearer to 0 than 2^-100 become 0.
[[nodiscard]] std::vector<glm::dvec3> to_face(const Doubles& vertices, const std::vector<std::uint32_t>& loop);

/// The array has the vector's memory.
template <class Value>
[[nodiscard]] py::array_t<Value> to_array(std::vector<Value> values, std::vector<py::ssize_t> shape = {}) {
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  if (shape.empty()) shape.push_back(static_cast<py::ssize_t>(kept->size()));
  const Value* data = kept->data();
  py::capsule owner(kept.get(), [](void* memory) { delete static_cast<std::vector<Value>*>(memory); });
  static_cast<void>(kept.release());
  return py::array_t<Value>(std::move(shape), data, owner);
}

/// One of several words.
template <class Value>
[[nodiscard]] Value to_choice(const std::string& word, const char* name,
                              std::initializer_list<std::pair<const char*, Value>> choices) {
  std::string all;
  for (const auto& [known, value] : choices) {
    if (word == known) return value;
    all += std::string(all.empty() ? "" : " or ") + "'" + known + "'";
  }
  throw std::invalid_argument(std::string(name) + " is '" + word + "', must be " + all);
}

}  // namespace occlude::python
