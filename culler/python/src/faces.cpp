// SPDX-License-Identifier: MIT
// Faces of any shape.
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "view.h"

namespace occlude::python {
namespace {

/// One loop of whole numbers.
std::vector<std::uint32_t> to_loop(const py::object& numbers) {
  constexpr std::uint64_t kMost = 0xFFFFFFFF;
  std::vector<std::uint32_t> loop;
  for (const std::uint64_t number : to_whole(numbers, "loop", kMost)) loop.push_back(static_cast<std::uint32_t>(number));
  return loop;
}

std::vector<std::uint32_t> counted(std::size_t count) {
  std::vector<std::uint32_t> loop(count);
  std::iota(loop.begin(), loop.end(), 0U);
  return loop;
}

bool is_fan(const Doubles& vertices, const py::object& numbers) {
  const std::vector<std::uint32_t> loop = to_loop(numbers);
  return culler::fan_is_face(to_face(vertices, loop), counted(loop.size()));
}

py::array_t<std::uint32_t> triangulate(const Doubles& vertices, const py::object& numbers) {
  const std::vector<std::uint32_t> loop = to_loop(numbers);
  const auto triangles = culler::triangles_of_face(to_face(vertices, loop), counted(loop.size()));
  if (!triangles) throw std::invalid_argument("the face crosses itself");
  std::vector<std::uint32_t> indices;
  for (const culler::FaceTriangle& triangle : *triangles) {
    for (const std::uint32_t corner : triangle) indices.push_back(loop[corner]);
  }
  return to_array(std::move(indices), {static_cast<py::ssize_t>(triangles->size()), 3});
}

}  // namespace

void define_faces(py::module_& module) {
  using py::literals::operator""_a;
  module.def(
      "is_fan", &is_fan, "vertices"_a, "loop"_a,
      "Whether the fan of a loop of vertices draws the face that it is: not of all that are concave or have openings.");
  module.def(
      "triangulate", &triangulate, "vertices"_a, "loop"_a,
      "Triangles that are the face of a loop, which may be concave and have openings by keyholes: vertices, three a row.");
}

}  // namespace occlude::python
