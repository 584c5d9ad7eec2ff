// SPDX-License-Identifier: MIT
#include "scene.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <variant>

#include "view.h"

namespace occlude::python {
namespace {

using culler::ObjectId;
using culler::OccluderId;
using culler::OccluderMesh;

constexpr std::uint64_t kMostId = std::numeric_limits<std::uint64_t>::max();

template <class Id>
std::vector<Id> to_ids(const py::object& numbers) {
  std::vector<Id> ids;
  for (const std::uint64_t number : to_whole(numbers, "ids", kMostId)) ids.push_back(Id::from_number(number));
  return ids;
}

/// An id of Python, as a scalar of NumPy: a list of these, and of elements of arrays, becomes an array of ids.
template <class Id>
py::object from_id(const Id& id) {
  return py::module_::import("numpy").attr("uint64")(id.number());
}

template <class Id>
py::array_t<std::uint64_t> from_ids(const std::vector<Id>& ids) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(ids.size());
  for (const Id& id : ids) numbers.push_back(id.number());
  return to_array(std::move(numbers));
}

/// Does `work` with each id, or with none if one of them names nothing.
template <class Id, class Work>
void for_each_id(SharedScene& scene, const py::object& numbers, const Work& work) {
  const auto ids = to_ids<Id>(numbers);
  scene.change([&](culler::Scene& s) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (const std::string reason = s.fault(ids[i]); !reason.empty()) {
        throw std::invalid_argument("id " + std::to_string(i) + ": " + reason);
      }
    }
    for (const Id& id : ids) work(s, id);
  });
}

py::array_t<std::uint64_t> add_objects(SharedScene& scene, const Doubles& given, const culler::ObjectOptions& options) {
  const std::vector<culler::Box> boxes = to_boxes(given);
  std::vector<ObjectId> ids(boxes.size());
  scene.change([&](culler::Scene& s) { s.add(boxes, options, ids); });
  return from_ids(ids);
}

void move_objects(SharedScene& scene, const py::object& numbers, const Doubles& given) {
  const std::vector<culler::Box> boxes = to_boxes(given);
  const auto ids = to_ids<ObjectId>(numbers);
  if (ids.size() != boxes.size()) throw std::invalid_argument("as many ids as boxes are needed");
  scene.change([&](culler::Scene& s) { s.move(ids, boxes); });
}

template <class Id>
void remove_all(SharedScene& scene, const py::object& numbers) {
  const auto ids = to_ids<Id>(numbers);
  scene.change([&](culler::Scene& s) { s.remove(ids); });
}

template <class Id>
void enable_all(SharedScene& scene, const py::object& numbers, bool is_enabled) {
  for_each_id<Id>(scene, numbers, [&](culler::Scene& s, const Id& id) { s.set_enabled(id, is_enabled); });
}

template <class Id>
void mask_all(SharedScene& scene, const py::object& numbers, std::uint32_t mask) {
  for_each_id<Id>(scene, numbers, [&](culler::Scene& s, const Id& id) { s.set_mask(id, mask); });
}

template <class Id>
bool has(const SharedScene& scene, std::uint64_t number) {
  return scene.look([&](const culler::Scene& s) { return s.contains(Id::from_number(number)); });
}

/// Whether the last two axes are matrices of 3 or 4 rows and 4 columns.
bool are_placements(const Doubles& m, py::ssize_t axes) {
  return m.ndim() == axes && (m.shape(axes - 2) == 3 || m.shape(axes - 2) == 4) && m.shape(axes - 1) == 4;
}

/// From matrices that take column vectors.
std::vector<culler::Placement> to_placements(const Doubles& matrices) {
  if (!are_placements(matrices, 3)) refuse_shape("placements", matrices, "(n, 3, 4) or (n, 4, 4)");
  std::vector<culler::Placement> placements;
  placements.reserve(static_cast<std::size_t>(matrices.shape(0)));
  for (py::ssize_t i = 0; i < matrices.shape(0); ++i) {
    std::array<double, 16> rows{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    for (py::ssize_t k = 0; k < 4 * matrices.shape(1); ++k) {
      rows[static_cast<std::size_t>(k)] = matrices.at(i, k / 4, k % 4);
    }
    placements.push_back(culler::Placement::from_rows(rows.data()));
  }
  return placements;
}

/// The same of one; None is the identity.
culler::Placement to_placement(const std::optional<Doubles>& matrix) {
  if (!matrix) return {};
  if (!are_placements(*matrix, 2)) refuse_shape("placement", *matrix, "(3, 4) or (4, 4)");
  return to_placements(Doubles(matrix->attr("__getitem__")(py::none())))[0];
}

py::array_t<std::uint64_t> add_occluders(SharedScene& scene, const std::shared_ptr<OccluderMesh>& mesh,
                                         const Doubles& matrices, const culler::OccluderOptions& options) {
  const std::vector<culler::Placement> placements = to_placements(matrices);
  std::vector<OccluderId> ids(placements.size());
  scene.change([&](culler::Scene& s) { s.add(mesh, placements, options, ids); });
  return from_ids(ids);
}

void move_occluders(SharedScene& scene, const py::object& numbers, const Doubles& matrices) {
  const std::vector<culler::Placement> placements = to_placements(matrices);
  const auto ids = to_ids<OccluderId>(numbers);
  if (ids.size() != placements.size()) throw std::invalid_argument("as many ids as placements are needed");
  scene.change([&](culler::Scene& s) { s.move(ids, placements); });
}

py::dict to_dict(const culler::SceneStats& stats) {
  using py::literals::operator""_a;
  return py::dict("drawn"_a = stats.drawn, "out_of_view"_a = stats.out_of_view, "hidden"_a = stats.hidden,
                  "too_small"_a = stats.too_small, "occluders"_a = stats.occluders,
                  "nodes_visited"_a = stats.work.nodes_visited, "view_tests"_a = stats.work.view_tests,
                  "cover_tests"_a = stats.work.cover_tests, "cover_groups"_a = stats.work.cover_groups,
                  "cover_groups_left"_a = stats.work.cover_groups_left, "cover_triangles"_a = stats.work.cover_triangles,
                  "cover_work"_a = stats.work.cover_work.drawing);
}

/// A view against which a frame of a scene is held.
const culler::SceneView& scene_view_of(const AnyView& held) {
  if (!held.is_of_scene) throw std::invalid_argument("the held frame is of a model");
  return held.scene;
}

template <class Camera>
SceneFrame cull_scene(const SharedScene& scene, const Camera& camera, AnyView* given, const std::pair<int, int>& cover_size,
                      const py::object& cover_work, const py::object& cover_ms, double margin, std::uint32_t mask,
                      float least_size, bool front_to_back, bool adaptive, bool to_be_held, const AnyView* held,
                      std::size_t threads) {
  const culler::Executor executor = on_threads(threads);
  culler::SceneOptions options = to_scene_options(cover_size, cover_work, cover_ms, margin, mask, least_size, front_to_back);
  options.is_adaptive = adaptive;
  options.is_to_be_held = to_be_held;
  options.executor = &executor;
  AnyView own;
  AnyView& view = given == nullptr ? own : *given;
  if (held == &view) throw std::invalid_argument("a frame cannot be held against its own view");
  SceneRows rows = scene.look([&](const culler::Scene& s) {
    std::unique_lock lock(view.mutex, std::defer_lock);
    if (held == nullptr) {
      lock.lock();
      s.cull(camera, options, view.scene);
    } else {
      std::shared_lock beside(held->mutex, std::defer_lock);
      std::lock(lock, beside);
      s.cull(camera, options, scene_view_of(*held), view.scene);
    }
    view.is_of_scene = true;
    view.camera = camera;
    options.executor = nullptr;  // it is of this frame alone
    view.options = options;
    return SceneRows(view.scene.result());
  });
  return to_frame(std::move(rows));
}

template <class Camera>
bool holds(const SharedScene& scene, const AnyView& held, const Camera& camera, std::uint32_t mask, float least_size) {
  return scene.look([&](const culler::Scene& s) {
    const std::shared_lock lock(held.mutex);
    return held.is_of_scene && s.holds(held.scene, camera, {.mask = mask, .least_size = least_size});
  });
}

void define_meshes(py::module_& module) {
  using py::literals::operator""_a;
  py::class_<OccluderMesh, std::shared_ptr<OccluderMesh>>(
      module, "OccluderMesh", "Geometry that hides, shared by occluders: polygons drawn as fans.")
      .def(py::init([](const Doubles& vertices, const py::object& polygons, const py::object& sizes,
                       const py::object& see_through) {
             culler::PolygonSoup soup = to_soup(vertices, polygons, sizes, see_through);
             const py::gil_scoped_release others_run;
             return std::make_shared<OccluderMesh>(std::move(soup));
           }),
           "vertices"_a, "polygons"_a, "sizes"_a = py::none(), "see_through"_a = py::none())
      .def("__len__", &OccluderMesh::size, "The number of polygons.")
      .def("__repr__", [](const OccluderMesh& mesh) { return described("OccluderMesh", count_of(mesh.size(), "polygon")); });
}

using Class = py::class_<SharedScene>;

constexpr std::uint32_t kAllLayers = ~std::uint32_t{0};

/// The object that draws an occluder, or none.
ObjectId to_object(const std::optional<std::uint64_t>& number) {
  return number ? ObjectId::from_number(*number) : ObjectId();
}

std::vector<culler::ObjectFate> fates(const SharedScene& scene, const py::object& numbers, AnyView& view) {
  const auto ids = to_ids<ObjectId>(numbers);
  return scene.look([&](const culler::Scene& s) {
    const std::scoped_lock lock(view.mutex);
    if (const auto* camera = std::get_if<culler::Camera>(&view.camera)) return s.why(*camera, view.options, view.scene, ids);
    if (const auto* camera = std::get_if<culler::MatrixCamera>(&view.camera)) {
      return s.why(*camera, view.options, view.scene, ids);
    }
    throw std::invalid_argument("the view has no frame of a scene");
  });
}

std::string to_text(const culler::ObjectFate& fate) {
  using Reason = culler::ObjectFate::Reason;
  switch (fate.reason) {
    case Reason::drawn:
      return described("Fate", "drawn");
    case Reason::always_drawn:
      return described("Fate", "always drawn");
    case Reason::out_of_view:
      return described("Fate", "out of view by plane " + std::to_string(fate.plane));
    case Reason::hidden:
      return described("Fate", "hidden by " + count_of(fate.by.size(), "polygon"));
    case Reason::too_small:
      return described("Fate", "too small");
    case Reason::in_no_layer:
      return described("Fate", "in no layer");
    case Reason::not_in_scene:
      break;
  }
  return described("Fate", "not in the scene");
}

std::string to_text(const SharedScene& scene) {
  return scene.look([](const culler::Scene& s) {
    return described("Scene", count_of(s.objects(), "object") + ", " + count_of(s.occluders(), "occluder"));
  });
}

std::string to_text(const SceneFrame& frame) {
  const auto number = [&](const char* name) { return frame.statistics[name].cast<std::size_t>(); };
  return described("SceneFrame", count_of(number("drawn"), "object") + " drawn, " + std::to_string(number("hidden")) +
                                     " hidden, " + std::to_string(number("out_of_view")) + " out of view, " +
                                     std::to_string(number("too_small")) + " too small");
}

/// What hides, as tuples (occluder, polygon, corners).
py::list hiding(const culler::ObjectFate& fate) {
  py::list result;
  for (const auto& [occluder, polygon, corners] : fate.by) {
    std::vector<double> numbers;
    for (const kernel::Vec3& v : corners) numbers.insert(numbers.end(), {v.x, v.y, v.z});
    const auto rows = static_cast<py::ssize_t>(corners.size());
    result.append(py::make_tuple(from_id(occluder), polygon, to_array(std::move(numbers), {rows, 3})));
  }
  return result;
}

void define_why(py::module_& module, Class& scene) {
  using py::literals::operator""_a;
  using culler::ObjectFate;
  py::class_<ObjectFate>(module, "Fate", "What became of an object in a frame, and why.")
      .def_property_readonly(
          "reason", [](const ObjectFate& fate) { return static_cast<int>(fate.reason); }, "A Reason.")
      .def_readonly("plane", &ObjectFate::plane, "Of SceneFrame.planes, where the object is out of view.")
      .def_property_readonly("by", &hiding, "The polygons that hide it: (occluder, polygon, corners).")
      .def("__repr__", [](const ObjectFate& fate) { return to_text(fate); });
  scene.def("why", &fates, "ids"_a, "view"_a,
            "What became of these objects in the last frame of the view, after which the scene was not updated: a list of "
            "Fate.");
}

void define_objects(Class& scene) {
  using py::literals::operator""_a;
  scene
      .def(
          "add_object",
          [](SharedScene& s, const Doubles& given, bool moves, bool is_always_drawn, std::uint32_t mask) {
            const culler::Box box = to_box(given);
            return from_id(s.change([&](culler::Scene& in) { return in.add(box, {moves, is_always_drawn, mask}); }));
          },
          "box"_a, py::kw_only(), "moves"_a = false, "is_always_drawn"_a = false, "mask"_a = kAllLayers,
          "Adds an object; its id.")
      .def(
          "add_objects",
          [](SharedScene& s, const Doubles& boxes, bool moves, bool is_always_drawn, std::uint32_t mask) {
            return add_objects(s, boxes, {moves, is_always_drawn, mask});
          },
          "boxes"_a, py::kw_only(), "moves"_a = false, "is_always_drawn"_a = false, "mask"_a = kAllLayers,
          "Adds an object for each box; an array of their ids.")
      .def("move_objects", &move_objects, "ids"_a, "boxes"_a, "A box for each.")
      .def("remove_objects", &remove_all<ObjectId>, "ids"_a, "All of them, or raises and removes none.")
      .def("enable_objects", &enable_all<ObjectId>, "ids"_a, "is_enabled"_a, "Those that are not are in no frame.")
      .def("mask_objects", &mask_all<ObjectId>, "ids"_a, "mask"_a,
           "Gives them these layers: frames have those whose mask has a bit in common with theirs.")
      .def("has_object", &has<ObjectId>, "id"_a, "Whether the id is that of an object of this scene.");
}

void define_occluders(Class& scene) {
  using py::literals::operator""_a;
  using Mesh = std::shared_ptr<OccluderMesh>;
  scene
      .def(
          "add_occluder",
          [](SharedScene& s, const Mesh& mesh, const std::optional<Doubles>& placement, bool moves, bool is_one_sided,
             std::uint32_t mask, std::optional<std::uint64_t> object, std::uint32_t weld) {
            const culler::Placement at = to_placement(placement);
            const culler::OccluderOptions options{moves, is_one_sided, mask, to_object(object), weld};
            return from_id(s.change([&](culler::Scene& in) { return in.add(mesh, at, options); }));
          },
          "mesh"_a.none(false), "placement"_a = py::none(), py::kw_only(), "moves"_a = false, "is_one_sided"_a = false,
          "mask"_a = kAllLayers, "object"_a = py::none(), "weld"_a = 0,
          "Adds an occluder; its id. Those with the same weld, if that is not 0, and all other options the same hide as "
          "one\n"
          "mesh does: where corners of theirs are at the same place, to the bit, no seam is left between them.")
      .def(
          "add_occluders",
          [](SharedScene& s, const Mesh& mesh, const Doubles& placements, bool moves, bool is_one_sided, std::uint32_t mask,
             std::optional<std::uint64_t> object, std::uint32_t weld) {
            return add_occluders(s, mesh, placements, {moves, is_one_sided, mask, to_object(object), weld});
          },
          "mesh"_a.none(false), "placements"_a, py::kw_only(), "moves"_a = false, "is_one_sided"_a = false,
          "mask"_a = kAllLayers, "object"_a = py::none(), "weld"_a = 0,
          "Adds an occluder for each placement; an array of their ids.")
      .def(
          "move_occluder",
          [](SharedScene& s, std::uint64_t id, const std::optional<Doubles>& placement) {
            const culler::Placement at = to_placement(placement);
            s.change([&](culler::Scene& in) { in.move(OccluderId::from_number(id), at); });
          },
          "id"_a, "placement"_a, "By a matrix; None: where the vertices of its mesh are.")
      .def(
          "replace_occluder",
          [](SharedScene& s, std::uint64_t id, const Mesh& mesh) {
            s.change([&](culler::Scene& in) { in.replace(OccluderId::from_number(id), mesh); });
          },
          "id"_a, "mesh"_a.none(false), "Gives it another mesh.")
      .def("move_occluders", &move_occluders, "ids"_a, "placements"_a, "A matrix for each.")
      .def("remove_occluders", &remove_all<OccluderId>, "ids"_a, "As remove_objects().")
      .def("enable_occluders", &enable_all<OccluderId>, "ids"_a, "is_enabled"_a, "Those that are not hide nothing.")
      .def("mask_occluders", &mask_all<OccluderId>, "ids"_a, "mask"_a, "As mask_objects().")
      .def("has_occluder", &has<OccluderId>, "id"_a, "Whether the id is that of an occluder of this scene.");
}

template <class Camera>
void define_cull(Class& scene) {
  using py::literals::operator""_a;
  scene.def(
      "cull", &cull_scene<Camera>, "camera"_a, "view"_a = py::none(), py::kw_only(),
      "cover_size"_a = std::pair{culler::CoverOptions{}.width, culler::CoverOptions{}.height}, "cover_work"_a = py::none(),
      "cover_ms"_a = py::none(), "margin"_a = 0.0, "mask"_a = kAllLayers, "least_size"_a = 0.0F, "front_to_back"_a = false,
      "adaptive"_a = true, "to_be_held"_a = false, "held"_a = py::none(), "threads"_a = 1,
      "What to draw: a SceneFrame. It does not depend on the number of threads, which are started for this call. If it "
      "is `adaptive`, it looks less where frames of the view have hidden less than a quarter of what is in view. With "
      "`held`, a view, what hid in its last frame hides, and each object is asked where it is now. That frame was "
      "to_be_held, in which occluders that move hide nothing, and holds().");
  scene.def("holds", &holds<Camera>, "held"_a, "camera"_a, py::kw_only(), "mask"_a = kAllLayers, "least_size"_a = 0.0F,
            "Whether frames of this camera, with these options, can be held against the last frame of the view `held`: it "
            "holds for the camera, and no update has since removed or changed an occluder that stands still.");
}

}  // namespace

culler::Executor on_threads(std::size_t threads) {
  if (threads == 0 || threads > culler::Executor::kMostThreads) throw std::invalid_argument("threads must be 1 to 65536");
  return culler::Executor::own_threads(threads);
}

culler::SceneOptions to_scene_options(const std::pair<int, int>& cover_size, const py::object& cover_work,
                                      const py::object& cover_ms, double margin, std::uint32_t mask, float least_size,
                                      bool front_to_back) {
  return {.cover = to_cover_options(cover_size, cover_work, cover_ms),
          .margin = margin,
          .mask = mask,
          .least_size = least_size,
          .is_front_to_back = front_to_back};
}

SceneRows::SceneRows(const culler::SceneResult& result) : planes(result.view), stats(result.stats) {
  drawn.reserve(result.drawn.size());
  for (const auto& [id, size, distance] : result.drawn) drawn.push_back({id.number(), size, distance});
  for (const OccluderId id : result.idle_occluders) idle_occluders.push_back(id.number());
}

SceneFrame to_frame(SceneRows rows) {
  return {to_array(std::move(rows.drawn)), to_array(rows.planes), to_dict(rows.stats),
          to_array(std::move(rows.idle_occluders))};
}

void define_scenes(py::module_& module) {
  using py::literals::operator""_a;
  PYBIND11_NUMPY_DTYPE(DrawnRow, id, size, distance);
  define_meshes(module);
  py::class_<SceneFrame>(module, "SceneFrame", "The objects to draw in one frame.")
      .def_readonly("drawn", &SceneFrame::drawn, "Rows (id, size, distance).")
      .def_readonly("planes", &SceneFrame::planes, "Rows (a, b, c, d); in view: a x + b y + c z + d >= 0.")
      .def_readonly("statistics", &SceneFrame::statistics, "What was counted, by names.")
      .def_readonly(
          "idle_occluders", &SceneFrame::idle_occluders,
          "Ids of occluders that hid nothing when a frame of the view last looked at everything: they cost more than "
          "they hide.")
      .def("__repr__", [](const SceneFrame& frame) { return to_text(frame); });
  Class scene(module, "Scene", "A world of objects and occluders that changes. Changes show at the next update().");
  scene.def(py::init<>()).def("__repr__", [](const SharedScene& s) { return to_text(s); });
  define_objects(scene);
  define_occluders(scene);
  define_cull<culler::Camera>(scene);
  define_cull<culler::MatrixCamera>(scene);
  define_why(module, scene);
  scene
      .def(
          "update", [](SharedScene& s, std::size_t threads) { s.update(on_threads(threads)); }, py::kw_only(),
          "threads"_a = 1, "Makes all changes since the last update; large tiles are built on so many threads.")
      .def_property_readonly(
          "objects", [](const SharedScene& s) { return s.look([](const auto& in) { return in.objects(); }); },
          "How many are in the scene, disabled ones included.")
      .def_property_readonly(
          "occluders", [](const SharedScene& s) { return s.look([](const auto& in) { return in.occluders(); }); },
          "As objects.");
}

}  // namespace occlude::python
