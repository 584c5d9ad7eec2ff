// SPDX-License-Identifier: MIT
// Uses the steps of a frame by cover: `Culler` would bring the frames by frusta, which take as much room again.
#include "model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "camera/holds_for.h"
#include "cameras.h"
#include "cover/cover_triangles.h"
#include "frame/begin_frame.h"
#include "frame/next_by_cover.h"
#include "mesh_data.h"
#include "model/hierarchy_blocks.h"
#include "model/legal_soup.h"
#include "occlude/culler/hierarchy.h"
#include "status.h"
#include "structs.h"

struct occlude_model {
  occlude_model(occlude::culler::PolygonSoup soup, const occlude::culler::Hierarchy::Config& config,
                const occlude::culler::Checkpoint& checkpoint)
      : hierarchy(occlude::culler::Hierarchy::build(std::move(soup), config, checkpoint)),
        triangles(occlude::culler::CoverTriangles::find(hierarchy.soup(), checkpoint)),
        blocks(hierarchy, checkpoint) {}

  occlude::culler::Hierarchy hierarchy;
  occlude::culler::CoverTriangles triangles;
  occlude::culler::HierarchyBlocks blocks;
  std::shared_ptr<const int> owner = std::make_shared<const int>();  ///< of the views' memory
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

culler::CullOptions to_options(const occlude_model_options& given) {
  if (!(given.margin >= 0)) throw std::invalid_argument("margin is below 0 or not a number");
  culler::CullOptions options{.method = given.is_adaptive != 0 ? culler::Method::automatic : culler::Method::cover,
                              .margin = given.margin};
  options.cover.width = given.cover_width;
  options.cover.height = given.cover_height;
  if (given.cover_work != 0) {
    options.cover.work =
        static_cast<std::size_t>(std::min<std::uint64_t>(given.cover_work, std::numeric_limits<std::size_t>::max()));
  }
  if (given.cover_ms != 0) options.cover.ms = given.cover_ms;
  return options;
}

void keep(const culler::Hierarchy& hierarchy, const culler::CullResult& result, occlude_model_view& view) {
  view.drawn.clear();
  view.culled.clear();
  view.planes.clear();
  for (const auto& [first, count] : result.drawn) view.drawn.push_back({first, count});
  for (const culler::Culled& culled : result.culled) {
    const culler::HierarchyNode& node = hierarchy.nodes()[culled.node];
    const bool is_hidden = culled.by == culler::Culled::By::cover;
    view.culled.push_back({node.first, node.count, is_hidden ? OCCLUDE_HIDDEN_RANGE : culled.index});
  }
  for (const auto& [normal, offset] : result.view) view.planes.push_back({{normal.x, normal.y, normal.z}, offset});
}

template <class Camera>
occlude_status cull(const occlude_model* model, const Camera* given, const occlude_model_options* options,
                    occlude_model_view* view) {
  return guarded([&] {
    require(model, "model");
    require(options, "options");
    require(view, "view");
    const auto camera = to_camera(given);
    culler::require_sound(camera);
    const culler::CullOptions how = to_options(*options);
    culler::View::Memory& memory = memory_for(view->view, model->owner);
    culler::begin_frame(model->hierarchy, camera, how, memory);
    next_by_cover(model->hierarchy, model->blocks.tree(), model->triangles, how, memory);
    keep(model->hierarchy, memory.frame.result, *view);
  });
}

template <class Camera>
occlude_status holds_for(const occlude_model_view* view, const Camera* camera, std::int32_t* holds) {
  return guarded([&] {
    require(view, "view");
    require(holds, "holds");
    const auto& frame = memory_of(view->view).frame;
    *holds = !frame.result.view.empty() && culler::holds_for(frame.view, to_camera(camera)) ? 1 : 0;
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
    occlude::culler::PolygonSoup soup = soup_of(data);
    require_legal(soup);
    if (soup.empty()) throw std::invalid_argument("the model has no polygon");
    using occlude::culler::Bounds;
    *model = new occlude_model(std::move(soup), {leaf_size, is_of_oriented_boxes != 0 ? Bounds::obb : Bounds::aabb},
                               checkpoint_of(data));
  });
}

void occlude_model_destroy(occlude_model* model) noexcept { delete model; }

std::size_t occlude_model_polygons(const occlude_model* model) noexcept {
  return model == nullptr ? 0 : model->hierarchy.soup().size();
}

occlude_status occlude_model_order(const occlude_model* model, std::uint32_t* order) noexcept {
  return guarded([&] {
    require(model, "model");
    require(order, "order");
    const auto& hierarchy = model->hierarchy;
    for (std::uint32_t p = 0; p < hierarchy.soup().size(); ++p) order[p] = hierarchy.original(p);
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
    const occlude::culler::CullStats& stats = memory_of(view->view).frame.result.stats;
    *frame = {.drawn = view->drawn.data(),
              .drawn_count = view->drawn.size(),
              .culled = view->culled.data(),
              .culled_count = view->culled.size(),
              .planes = view->planes.data(),
              .plane_count = view->planes.size(),
              .drawn_polygons = stats.drawn_polygons,
              .out_of_view_polygons = stats.view_culled_polygons,
              .hidden_polygons = stats.shadow_culled_polygons,
              .unasked_polygons = stats.unasked_polygons,
              .nodes_visited = stats.nodes_visited,
              .view_tests = stats.view_tests,
              .cover_tests = stats.cover_tests,
              .cover_triangles = stats.cover_triangles,
              .cover_work = stats.cover_work.drawing};
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
