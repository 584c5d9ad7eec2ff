// SPDX-License-Identifier: MIT
// Arrays of NumPy as the library's geometry, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::python {

namespace py = pybind11;

/// Real numbers of any type and with any strides, as doubles one after another. A function that takes it refuses all else
/// with TypeError.
class Doubles : public py::array_t<double, py::array::c_style | py::array::forcecast> {
  using Base = py::array_t<double, py::array::c_style | py::array::forcecast>;

 public:
  using Base::Base;
};

/// Throws std::invalid_argument, which is ValueError in Python: "boxes has shape (6,), must be …".
[[noreturn]] void refuse_shape(const char* name, const py::array& array, const char* wanted);

// All of these throw it, too, for arrays of another shape or type.

/// Shape (3).
[[nodiscard]] kernel::Vec3 to_vec3(const Doubles& numbers, const char* name);
/// Shape (n, 3).
[[nodiscard]] std::vector<kernel::Vec3> to_points(const Doubles& points, const char* name);
/// Shape (n, 6) or (n, 2, 3): axis-aligned; (n, 12) or (n, 4, 3): oriented.
[[nodiscard]] std::vector<culler::Box> to_boxes(const Doubles& boxes);
/// Which of both.
[[nodiscard]] bool are_aligned(const Doubles& boxes);
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

// Boxes of such an array, from their first number.

[[nodiscard]] inline kernel::Vec3 vec3_at(const double* v) { return {v[0], v[1], v[2]}; }
[[nodiscard]] inline kernel::Aabb aligned_at(const double* v) { return {vec3_at(v), vec3_at(v + 3)}; }
[[nodiscard]] inline kernel::Obb oriented_at(const double* v) {
  return {vec3_at(v), {vec3_at(v + 3), vec3_at(v + 6), vec3_at(v + 9)}};
}

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

namespace pybind11::detail {

template <>
struct type_caster<occlude::python::Doubles> {
  using Doubles = occlude::python::Doubles;
  PYBIND11_TYPE_CASTER(Doubles, const_name("numpy.ndarray[numpy.float64]"));

  bool load(handle given, bool) {
    // Numbers, and objects that are numbers. NumPy would drop the imaginary part of complex ones, and read texts.
    constexpr std::string_view kKinds = "biufO";
    const auto numbers = array::ensure(given);
    if (!numbers) throw type_error("an array of real numbers is needed");
    const bool is_real = kKinds.find(numbers.dtype().kind()) != std::string_view::npos;
    auto doubles = is_real ? array_t<double, array::c_style | array::forcecast>::ensure(numbers) : object();
    if (!doubles) throw type_error("an array of real numbers is needed, not of " + str(numbers.dtype()).cast<std::string>());
    value = Doubles(std::move(doubles));
    return true;
  }
  static handle cast(const Doubles& array, return_value_policy, handle) { return array.inc_ref(); }
};

}  // namespace pybind11::detail
