// SPDX-License-Identifier: MIT
#include "model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "cameras.h"
#include "mesh_data.h"
#include "occlude/culler/culler.h"
#include "status.h"
#include "structs.h"

struct occlude_model {
  occlude::culler::Culler culler;
};

struct occlude_model_view {
  occlude::culler::View view;
  // The last frame.
  std::vector<occlude_range> drawn;
  std::vector<occlude_culled_range> culled;
  std::vector<occlude_half_space> planes;
};

namespace occlude::c {
namespace {

culler::Method to_method(occlude_method method) {
  switch (method) {
    case OCCLUDE_AUTOMATIC:
      return culler::Method::automatic;
    case OCCLUDE_FRUSTA:
      return culler::Method::frusta;
    case OCCLUDE_COVER:
      return culler::Method::cover;
    default:
      refuse_enumerator("method", method);
  }
}

culler::CullOptions to_options(const occlude_model_options& given) {
  if (!(given.margin >= 0)) throw std::invalid_argument("margin is below 0 or not a number");
  culler::CullOptions options{.method = to_method(given.method),
                              .occluders = given.occluders,
                              .probes = given.probes,
                              .margin = given.margin,
                              .unions = given.is_with_unions != 0};
  options.cover.width = given.cover_width;
  options.cover.height = given.cover_height;
  if (given.cover_work != 0) {
    options.cover.work =
        static_cast<std::size_t>(std::min<std::uint64_t>(given.cover_work, std::numeric_limits<std::size_t>::max()));
  }
  if (given.cover_ms != 0) options.cover.ms = given.cover_ms;
  return options;
}

void keep(const culler::Culler& culler, const culler::CullResult& result, occlude_model_view& view) {
  view.drawn.clear();
  view.culled.clear();
  view.planes.clear();
  for (const auto& [first, count] : result.drawn) view.drawn.push_back({first, count});
  for (const culler::Culled& culled : result.culled) {
    const culler::HierarchyNode& node = culler.hierarchy().nodes()[culled.node];
    view.culled.push_back({node.first, node.count, static_cast<std::uint32_t>(culled.by), culled.index});
  }
  for (const auto& [normal, offset] : result.view) view.planes.push_back({{normal.x, normal.y, normal.z}, offset});
}

template <class Camera>
occlude_status cull(const occlude_model* model, const Camera* camera, const occlude_model_options* options,
                    occlude_model_view* view) {
  return guarded([&] {
    require(model, "model");
    require(options, "options");
    require(view, "view");
    keep(model->culler, model->culler.cull(to_camera(camera), to_options(*options), view->view), *view);
  });
}

template <class Camera>
occlude_status holds_for(const occlude_model_view* view, const Camera* camera, std::int32_t* holds) {
  return guarded([&] {
    require(view, "view");
    require(holds, "holds");
    *holds = view->view.holds_for(to_camera(camera)) ? 1 : 0;
  });
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_model_create(const occlude_mesh_data* given, std::uint32_t leaf_size,
                                    std::int32_t is_of_oriented_boxes, occlude_model** model) noexcept {
  return guarded([&] {
    require(model, "model");
    const auto data = read(given, occlude_mesh_data OCCLUDE_MESH_DATA_INIT, "mesh data");
    occlude::culler::BuildConfig config;
    config.hierarchy.leaf_size = leaf_size;
    config.hierarchy.bounds = is_of_oriented_boxes != 0 ? occlude::culler::Bounds::obb : occlude::culler::Bounds::aabb;
    *model = new occlude_model{occlude::culler::Culler(soup_of(data), config, checkpoint_of(data))};
  });
}

void occlude_model_destroy(occlude_model* model) noexcept { delete model; }

std::size_t occlude_model_polygons(const occlude_model* model) noexcept {
  return model == nullptr ? 0 : model->culler.hierarchy().soup().size();
}

occlude_status occlude_model_order(const occlude_model* model, std::uint32_t* order) noexcept {
  return guarded([&] {
    require(model, "model");
    require(order, "order");
    const auto& hierarchy = model->culler.hierarchy();
    for (std::uint32_t p = 0; p < hierarchy.soup().size(); ++p) order[p] = hierarchy.original(p);
  });
}

occlude_status occlude_model_prepare(const occlude_model* model, occlude_method method) noexcept {
  return guarded([&] {
    require(model, "model");
    model->culler.prepare(to_method(method));
  });
}

occlude_status occlude_model_view_create(occlude_model_view** view) noexcept {
  return guarded([&] {
    require(view, "view");
    *view = new occlude_model_view;
  });
}

void occlude_model_view_destroy(occlude_model_view* view) noexcept { delete view; }

occlude_status occlude_model_cull(const occlude_model* model, const occlude_matrix_camera* camera,
                                  const occlude_model_options* options, occlude_model_view* view) noexcept {
  return cull(model, camera, options, view);
}

occlude_status occlude_model_cull_look_at(const occlude_model* model, const occlude_look_at_camera* camera,
                                          const occlude_model_options* options, occlude_model_view* view) noexcept {
  return cull(model, camera, options, view);
}

occlude_status occlude_model_view_frame(const occlude_model_view* view, occlude_model_frame* frame) noexcept {
  return guarded([&] {
    require(view, "view");
    require(frame, "frame");
    const occlude::culler::CullStats& stats = view->view.result().stats;
    *frame = {.drawn = view->drawn.data(),
              .drawn_count = view->drawn.size(),
              .culled = view->culled.data(),
              .culled_count = view->culled.size(),
              .planes = view->planes.data(),
              .plane_count = view->planes.size(),
              .drawn_polygons = stats.drawn_polygons,
              .view_culled_polygons = stats.view_culled_polygons,
              .shadow_culled_polygons = stats.shadow_culled_polygons,
              .nodes_visited = stats.nodes_visited,
              .view_tests = stats.view_tests,
              .shadow_tests = stats.shadow_tests,
              .cover_tests = stats.cover_tests,
              .cover_triangles = stats.cover_triangles,
              .unasked_polygons = stats.unasked_polygons};
  });
}

occlude_status occlude_model_view_holds_for(const occlude_model_view* view, const occlude_matrix_camera* camera,
                                            std::int32_t* holds) noexcept {
  return holds_for(view, camera, holds);
}

occlude_status occlude_model_view_holds_for_look_at(const occlude_model_view* view, const occlude_look_at_camera* camera,
                                                    std::int32_t* holds) noexcept {
  return holds_for(view, camera, holds);
}
