// SPDX-License-Identifier: MIT
#include "model.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "occlude/culler/culler.h"
#include "occlude/culler/hierarchy.h"
#include "view.h"

namespace occlude::python {
namespace {

using culler::Culler;

struct CulledRow {
  std::uint32_t first, count, by, index;
};

/// A frame that Python keeps.
struct ModelFrame {
  py::array_t<RangeRow> drawn;
  py::array_t<std::uint32_t> polygons;
  py::array_t<CulledRow> culled;
  py::array_t<double> planes;
  py::dict statistics;
};

/// The same before it is Python's: made while other threads run.
struct FrameRows {
  std::vector<RangeRow> drawn;
  std::vector<std::uint32_t> polygons;
  std::vector<CulledRow> culled;
  std::vector<culler::HalfSpace> planes;
  culler::CullStats stats;
};

FrameRows to_rows(const Culler& culler, const culler::CullResult& result) {
  FrameRows rows;
  rows.planes = result.view;
  rows.stats = result.stats;
  append_drawn(culler, result.drawn, rows.drawn, rows.polygons);
  for (const culler::Culled& culled : result.culled) {
    const culler::HierarchyNode& node = culler.hierarchy().nodes()[culled.node];
    rows.culled.push_back({node.first, node.count, static_cast<std::uint32_t>(culled.by), culled.index});
  }
  return rows;
}

py::dict to_dict(const culler::CullStats& stats) {
  using py::literals::operator""_a;
  return py::dict("drawn_polygons"_a = stats.drawn_polygons, "view_culled_polygons"_a = stats.view_culled_polygons,
                  "shadow_culled_polygons"_a = stats.shadow_culled_polygons, "nodes_visited"_a = stats.nodes_visited,
                  "view_tests"_a = stats.view_tests, "shadow_tests"_a = stats.shadow_tests,
                  "exact_shadow_tests"_a = stats.exact_shadow_tests, "cover_tests"_a = stats.cover_tests,
                  "cover_triangles"_a = stats.cover_triangles,
                  "cover_work"_a = stats.cover_work.drawing + stats.cover_work.asking,
                  "unasked_polygons"_a = stats.unasked_polygons);
}

template <class Camera>
ModelFrame cull_model(const Culler& culler, const Camera& camera, AnyView* view, const std::string& method,
                      std::size_t occluders, std::size_t probes, const std::string& near, const std::string& arithmetic,
                      const std::string& test, double margin, bool unions, const std::pair<int, int>& cover_size,
                      const py::object& cover_work, const py::object& cover_ms) {
  const culler::CullOptions options =
      to_cull_options(method, occluders, probes, near, arithmetic, test, margin, unions, cover_size, cover_work, cover_ms);
  FrameRows rows;
  {
    const py::gil_scoped_release others_run;
    if (view == nullptr) {
      rows = to_rows(culler, culler.cull(camera, options));
    } else {
      const std::scoped_lock lock(view->mutex);
      rows = to_rows(culler, culler.cull(camera, options, view->model));
      view->is_of_scene = false;
    }
  }
  return {to_array(std::move(rows.drawn)), to_array(std::move(rows.polygons)), to_array(std::move(rows.culled)),
          to_array(rows.planes), to_dict(rows.stats)};
}

std::unique_ptr<Culler> make_culler(const Doubles& vertices, const py::object& polygons, const py::object& sizes,
                                    const py::object& see_through, std::uint32_t leaf_size, const std::string& bounds) {
  culler::BuildConfig config;
  config.hierarchy.leaf_size = leaf_size;
  config.hierarchy.bounds =
      to_choice(bounds, "bounds", {std::pair{"aabb", culler::Bounds::aabb}, {"obb", culler::Bounds::obb}});
  culler::PolygonSoup soup = to_soup(vertices, polygons, sizes, see_through);
  const py::gil_scoped_release others_run;
  return std::make_unique<Culler>(std::move(soup), config);
}

culler::DrawOrder make_draw_order(const Culler& culler, const py::object& materials) {
  const std::vector<std::uint64_t> numbers = to_whole(materials, "materials", std::numeric_limits<std::uint32_t>::max());
  const std::vector<std::uint32_t> narrow(numbers.begin(), numbers.end());
  const py::gil_scoped_release others_run;
  return culler::DrawOrder(culler.hierarchy(), narrow);
}

py::object ranges_of(const culler::DrawOrder& order, const py::array_t<RangeRow>& rows) {
  std::vector<culler::PolygonRange> drawn;
  for (py::ssize_t i = 0; i < rows.size(); ++i) {
    const auto [first, count] = rows.at(i);
    if (std::uint64_t{first} + count > order.polygons().size()) {
      throw std::invalid_argument("the frame is of another model");
    }
    drawn.push_back({first, count});
  }
  std::vector<culler::MaterialRange> ranges;
  order.find_ranges(drawn, ranges);
  return to_array(std::move(ranges));
}

void define_draw_orders(py::module_& module) {
  using py::literals::operator""_a;
  using culler::DrawOrder, culler::MaterialRange;
  PYBIND11_NUMPY_DTYPE(MaterialRange, material, first, count);
  py::class_<DrawOrder>(module, "DrawOrder",
                        "Polygons of a Culler by materials, whole numbers, one for each: an order for index buffers.")
      .def(py::init(&make_draw_order), "culler"_a, "materials"_a)
      .def_property_readonly(
          "polygons",
          [](const DrawOrder& order) {
            return to_array(std::vector<std::uint32_t>(order.polygons().begin(), order.polygons().end()));
          },
          "The polygons in this order, as they were numbered when given.")
      .def_property_readonly(
          "materials",
          [](const DrawOrder& order) {
            return to_array(std::vector<MaterialRange>(order.materials().begin(), order.materials().end()));
          },
          "Rows (material, first, count): the range of each material that there is.")
      .def(
          "ranges", [](const DrawOrder& order, const ModelFrame& frame) { return ranges_of(order, frame.drawn); }, "frame"_a,
          "Rows (material, first, count): ranges of `polygons` that draw what the frame draws.")
      .def(
          "ranges", [](const DrawOrder& order, const HeldFrame& frame) { return ranges_of(order, frame.drawn); }, "frame"_a,
          "The same for a frame of a HeldCull.")
      .def("__repr__", [](const DrawOrder& order) {
        return described("DrawOrder", count_of(order.polygons().size(), "polygon") + " of " +
                                          count_of(order.materials().size(), "material"));
      });
}

template <class Camera>
void define_cull(py::class_<Culler>& culler) {
  using py::literals::operator""_a;
  const culler::CullOptions defaults;
  culler.def("cull", &cull_model<Camera>, "camera"_a, "view"_a = py::none(), py::kw_only(), "method"_a = "automatic",
             "occluders"_a = defaults.occluders, "probes"_a = defaults.probes, "near"_a = "surface",
             "arithmetic"_a = "certified", "test"_a = "conservative", "margin"_a = defaults.margin,
             "unions"_a = defaults.unions, "cover_size"_a = std::pair{defaults.cover.width, defaults.cover.height},
             "cover_work"_a = py::none(), "cover_ms"_a = py::none(), "What to draw: a ModelFrame.");
}

}  // namespace

void append_drawn(const Culler& culler, const std::vector<culler::PolygonRange>& ranges, std::vector<RangeRow>& drawn,
                  std::vector<std::uint32_t>& polygons) {
  for (const auto [first, count] : ranges) {
    drawn.push_back({first, count});
    for (std::uint32_t p = first; p < first + count; ++p) polygons.push_back(culler.hierarchy().original(p));
  }
}

culler::Method to_method(const std::string& name) {
  return to_choice(name, "method",
                   {std::pair{"automatic", culler::Method::automatic},
                    {"frusta", culler::Method::frusta},
                    {"cover", culler::Method::cover}});
}

culler::CullOptions to_cull_options(const std::string& method, std::size_t occluders, std::size_t probes,
                                    const std::string& near, const std::string& arithmetic, const std::string& test,
                                    double margin, bool unions, const std::pair<int, int>& cover_size,
                                    const py::object& cover_work, const py::object& cover_ms) {
  if (!(margin >= 0)) throw std::invalid_argument("margin is below 0 or not a number");
  return {
      .method = to_method(method),
      .cover = to_cover_options(cover_size, cover_work, cover_ms),
      .occluders = occluders,
      .probes = probes,
      .shadow_near =
          to_choice(near, "near", {std::pair{"surface", kernel::Near::surface}, {"farthest", kernel::Near::farthest}}),
      .arithmetic = to_choice(arithmetic, "arithmetic",
                              {std::pair{"certified", kernel::Arithmetic::certified}, {"plain", kernel::Arithmetic::plain}}),
      .test = to_choice(test, "test",
                        {std::pair{"conservative", kernel::Test::conservative}, {"overlap", kernel::Test::overlap}}),
      .margin = margin,
      .unions = unions};
}

void define_models(py::module_& module) {
  using py::literals::operator""_a;
  PYBIND11_NUMPY_DTYPE(RangeRow, first, count);
  PYBIND11_NUMPY_DTYPE(CulledRow, first, count, by, index);
  py::class_<ModelFrame>(module, "ModelFrame", "The polygons to draw in one frame.")
      .def_readonly("drawn", &ModelFrame::drawn, "Rows (first, count): ranges of Culler.order.")
      .def_readonly("polygons", &ModelFrame::polygons, "The polygons to draw, as they were numbered when given.")
      .def_readonly("culled", &ModelFrame::culled, "Rows (first, count, by, index): what is not drawn, and why (CulledBy).")
      .def_readonly("planes", &ModelFrame::planes, "Rows (a, b, c, d); in view: a x + b y + c z + d >= 0.")
      .def_readonly("statistics", &ModelFrame::statistics, "What was counted, by names.")
      .def("__repr__", [](const ModelFrame& frame) {
        return described("ModelFrame", count_of(static_cast<std::size_t>(frame.polygons.size()), "polygon") + " drawn");
      });
  py::class_<HeldFrame>(module, "HeldFrame", "The polygons to draw in one frame of a HeldCull.")
      .def_readonly("drawn", &HeldFrame::drawn, "Rows (first, count): ranges of Culler.order.")
      .def_readonly("polygons", &HeldFrame::polygons, "The polygons to draw, as they were numbered when given.")
      .def_readonly("is_of_point", &HeldFrame::is_of_point, "Whether it was culled for itself alone.")
      .def("__repr__", [](const HeldFrame& frame) {
        return described("HeldFrame", count_of(static_cast<std::size_t>(frame.polygons.size()), "polygon") + " drawn");
      });
  py::class_<Culler> culler(module, "Culler", "A model that stands still. prepare() makes what frames by a method need.");
  culler
      .def(py::init(&make_culler), "vertices"_a, "polygons"_a, "sizes"_a = py::none(), py::kw_only(),
           "see_through"_a = py::none(), "leaf_size"_a = culler::Hierarchy::Config{}.leaf_size, "bounds"_a = "aabb")
      .def(
          "prepare",
          [](const Culler& c, const std::string& method) {
            const culler::Method chosen = to_method(method);
            const py::gil_scoped_release others_run;
            c.prepare(chosen);
          },
          "method"_a = "automatic", "Makes what frames by this method need; else the first of them does.")
      .def(
          "__len__", [](const Culler& c) { return c.hierarchy().soup().size(); }, "The number of polygons.")
      .def("__repr__", [](const Culler& c) { return described("Culler", count_of(c.hierarchy().soup().size(), "polygon")); })
      .def_property_readonly(
          "order",
          [](const Culler& c) {
            std::vector<std::uint32_t> order(c.hierarchy().soup().size());
            for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = c.hierarchy().original(p);
            return to_array(std::move(order));
          },
          "The number that each polygon of the culler's order had when given.");
  define_cull<culler::Camera>(culler);
  define_cull<culler::MatrixCamera>(culler);
  define_draw_orders(module);
}

}  // namespace occlude::python
