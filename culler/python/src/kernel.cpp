// SPDX-License-Identifier: MIT
// The kernel's question in bulk: boxes against a shadow frustum.
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "occlude/kernel/batch.h"
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

kernel::Viewpoint to_viewpoint(const std::optional<Doubles>& eye, const std::optional<Doubles>& direction) {
  if (eye.has_value() == direction.has_value()) throw std::invalid_argument("either an eye or a direction is needed");
  if (eye) return kernel::Viewpoint::eye(to_vec3(*eye, "eye"));
  return kernel::Viewpoint::direction(to_vec3(*direction, "direction"));
}

kernel::ShadowFrustumResult make(const kernel::Viewpoint& viewpoint, const std::vector<kernel::Vec3>& vertices,
                                 const py::object& faces, kernel::Near near) {
  if (faces.is_none()) return kernel::ShadowFrustum::make(viewpoint, vertices, near);
  const auto [polytope, refusal] = kernel::ConvexPolytope::make({vertices, to_loops(faces)});
  require_none(refusal);
  return kernel::ShadowFrustum::make(viewpoint, *polytope, near);
}

Shadow make_shadow(const Doubles& vertices, const py::object& faces, const std::optional<Doubles>& eye,
                   const std::optional<Doubles>& direction, const std::string& near) {
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

kernel::Decision decide(const Shadow& shadow, const Question& q, const auto& box) {
  return kernel::decide(shadow.frustum, box, q.arithmetic, q.test, q.boundary);
}

/// What the shadow answers about some boxes.
template <class Box>
void answer(const Shadow& shadow, const Question& q, std::span<const Box> boxes, std::span<kernel::Relation> relations) {
  const auto relation = [&](const Box& box) { return decide(shadow, q, box).relation; };
  std::ranges::transform(boxes, relations.begin(), relation);
}

/// The same of axis-aligned ones, which the certified tests take together.
void answer(const Shadow& shadow, const Question& q, std::span<const kernel::Aabb> boxes,
            std::span<kernel::Relation> relations) {
  if (q.arithmetic == kernel::Arithmetic::plain) return answer<kernel::Aabb>(shadow, q, boxes, relations);
  const kernel::BoxBatch batch(boxes);
  if (q.test == kernel::Test::overlap) {
    kernel::overlap_certified(shadow.frustum, batch, q.boundary, relations);
  } else {
    kernel::conservative_certified(shadow.frustum, batch, q.boundary, relations);
  }
}

/// Calls use(boxes) for some boxes at a time, so many that they, in two orders, and what is written of them stay in the
/// cache: 100 KiB. Throws std::invalid_argument for those that are not legal.
template <class Box, class Use>
void for_boxes(const Doubles& given, Box (*box_at)(const double*), const Use& use) {
  constexpr std::size_t kSome = 1024;
  const auto count = static_cast<std::size_t>(given.shape(0));
  const std::size_t numbers = sizeof(Box) / sizeof(double);
  std::vector<Box> boxes;
  boxes.reserve(kSome);
  for (std::size_t first = 0; first < count; first += boxes.size()) {
    boxes.clear();
    for (std::size_t i = first; i < std::min(first + kSome, count); ++i) {
      boxes.push_back(box_at(given.data() + numbers * i));
      const kernel::Refusal refusal = kernel::check(boxes.back());
      if (refusal == kernel::Refusal::none) continue;
      throw std::invalid_argument("box " + std::to_string(i) + ": " + std::string(kernel::to_string(refusal)));
    }
    use(std::span<const Box>(boxes));
  }
}

/// For each box what ask(boxes, answers) writes of it, some boxes at a time.
template <class Answer, class Ask>
py::array_t<std::uint8_t> ask_all(const Doubles& given, const Ask& ask) {
  std::vector<std::uint8_t> all;
  const bool is_aligned = are_aligned(given);
  all.reserve(static_cast<std::size_t>(given.shape(0)));
  std::vector<Answer> answers;
  const auto use = [&](auto boxes) {
    answers.resize(boxes.size());
    ask(boxes, std::span(answers));
    for (const Answer answer : answers) all.push_back(static_cast<std::uint8_t>(answer));
  };
  {
    const py::gil_scoped_release others_run;
    require_none(kernel::check_rounding());
    if (is_aligned) {
      for_boxes(given, aligned_at, use);
    } else {
      for_boxes(given, oriented_at, use);
    }
  }
  return to_array(std::move(all));
}

py::array_t<std::uint8_t> relations(const Shadow& shadow, const Doubles& boxes, const std::string& arithmetic,
                                    const std::string& test, const std::string& near_boundary) {
  const Question q = to_question(arithmetic, test, near_boundary);
  return ask_all<kernel::Relation>(boxes, [&](auto some, auto relations) { answer(shadow, q, some, relations); });
}

py::array_t<std::uint8_t> stages(const Shadow& shadow, const Doubles& boxes, const std::string& test,
                                 const std::string& near_boundary) {
  const Question q = to_question("certified", test, near_boundary);
  return ask_all<kernel::Stage>(boxes, [&](auto some, auto answers) {
    std::ranges::transform(some, answers.begin(), [&](const auto& box) { return decide(shadow, q, box).stage; });
  });
}

py::array_t<double> vec3_array(const kernel::Vec3& v) { return to_array(std::vector<double>{v.x, v.y, v.z}); }

/// The near plane that was chosen for a polygon that is not coplanar: (normal, point), or None.
py::object support_plane(const Shadow& shadow) {
  const std::optional<kernel::SupportPlane>& plane = shadow.frustum.support_plane();
  if (!plane) return py::none();
  return py::make_tuple(vec3_array(plane->normal), vec3_array(plane->point));
}

std::string to_text(const Shadow& shadow) {
  const kernel::Viewpoint& from = shadow.frustum.viewpoint();
  const std::string where = py::str(py::make_tuple(from.value.x, from.value.y, from.value.z)).cast<std::string>();
  const std::string corners = std::to_string(shadow.vertices.shape(0)) + " vertices";
  return described("ShadowFrustum", corners + (from.is_eye() ? ", eye " : ", direction ") + where);
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
           "near_boundary"_a = "closed", "The relation of each box to the shadow: an array of Relation.")
      .def("stages", &stages, "boxes"_a, py::kw_only(), "test"_a = "overlap", "near_boundary"_a = "closed",
           "Which stage decides of each box: an array of Stage. It takes longer than relations().")
      .def_readonly("vertices", &Shadow::vertices, "As given.")
      .def_readonly("faces", &Shadow::faces, "As given.")
      .def_readonly("near", &Shadow::near, "As given.")
      .def_property_readonly(
          "viewpoint", [](const Shadow& s) { return vec3_array(s.frustum.viewpoint().value); }, "The eye or the direction.")
      .def_property_readonly(
          "is_direction", [](const Shadow& s) { return !s.frustum.viewpoint().is_eye(); }, "Which of both.")
      .def_property_readonly("support_plane", &support_plane,
                             "The near plane that was chosen where the polygon is not plane: (normal, point), or None.")
      .def("__repr__", &to_text);
}

}  // namespace occlude::python
