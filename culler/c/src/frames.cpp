// SPDX-License-Identifier: MIT
// Views and frames of the C interface.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "arrays.h"
#include "executors.h"
#include "handles.h"
#include "ids.h"
#include "status.h"
#include "structs.h"

namespace occlude::c {
namespace {

glm::dvec3 dvec3(const double* v) { return {v[0], v[1], v[2]}; }

culler::EyeRegion to_region(const occlude_eye_region& eyes) {
  const auto half_edge = [&](std::size_t i) {
    return glm::dvec3(eyes.half_edges[i][0], eyes.half_edges[i][1], eyes.half_edges[i][2]);
  };
  return {eyes.radius, {half_edge(0), half_edge(1), half_edge(2)}};
}

culler::Camera to_camera(const occlude_look_at_camera* given) {
  require(given, "camera");
  const auto camera = read_options(given, occlude_look_at_camera OCCLUDE_LOOK_AT_CAMERA_INIT, "camera");
  if (camera.projection != OCCLUDE_PERSPECTIVE && camera.projection != OCCLUDE_ORTHOGRAPHIC) {
    refuse_enumerator("projection", camera.projection);
  }
  const bool is_orthographic = camera.projection == OCCLUDE_ORTHOGRAPHIC;
  return {.eye = dvec3(camera.eye),
          .target = dvec3(camera.target),
          .up = dvec3(camera.up),
          .projection = is_orthographic ? culler::Projection::orthographic : culler::Projection::perspective,
          .fov_y_deg = camera.fov_y_deg,
          .height = camera.height,
          .aspect = camera.aspect,
          .near_plane = camera.near_plane,
          .far_plane = camera.far_plane == 0 ? std::numeric_limits<double>::infinity() : camera.far_plane};
}

template <class Number>
culler::MatrixCamera from_matrix(const occlude_matrix_camera& camera, culler::ClipDepth depth, culler::Nearer nearer) {
  std::array<Number, 16> numbers{};
  std::memcpy(numbers.data(), camera.matrix, sizeof numbers);
  if (camera.order == OCCLUDE_ROWS) return culler::MatrixCamera::from_rows(numbers.data(), depth, nearer);
  return culler::MatrixCamera::from_columns(numbers.data(), depth, nearer);
}

culler::ClipDepth to_depth(occlude_clip_depth depth) {
  switch (depth) {
    case OCCLUDE_DEPTH_MINUS_W_TO_W:
      return culler::ClipDepth::minus_w_to_w;
    case OCCLUDE_DEPTH_ZERO_TO_W:
      return culler::ClipDepth::zero_to_w;
    case OCCLUDE_DEPTH_UNSAID:
      throw std::invalid_argument("depth of the camera is not said");
    default:
      refuse_enumerator("depth of the camera", depth);
  }
}

culler::Nearer to_nearer(occlude_nearer nearer) {
  switch (nearer) {
    case OCCLUDE_NEARER_UNSAID:
      return culler::Nearer::unsaid;
    case OCCLUDE_NEARER_LESS:
      return culler::Nearer::less;
    case OCCLUDE_NEARER_GREATER:
      return culler::Nearer::greater;
    default:
      refuse_enumerator("nearer", nearer);
  }
}

culler::MatrixCamera to_camera(const occlude_matrix_camera* given) {
  const auto camera = read(given, occlude_matrix_camera OCCLUDE_MATRIX_CAMERA_INIT, "camera");
  require(camera.matrix, "matrix");
  if (camera.order != OCCLUDE_COLUMNS && camera.order != OCCLUDE_ROWS) refuse_enumerator("matrix order", camera.order);
  if (camera.type != OCCLUDE_DOUBLE && camera.type != OCCLUDE_FLOAT) refuse_enumerator("number type", camera.type);
  const culler::ClipDepth depth = to_depth(camera.depth);
  const culler::Nearer nearer = to_nearer(camera.nearer);
  culler::MatrixCamera result =
      camera.type == OCCLUDE_FLOAT ? from_matrix<float>(camera, depth, nearer) : from_matrix<double>(camera, depth, nearer);
  result.eyes = to_region(camera.eyes);
  return result;
}

/// A limit of the caller, of which 0 is none.
template <class To, class From>
To limit(From given, To none) {
  if (given == From{0}) return none;
  return static_cast<To>(std::min<From>(given, static_cast<From>(std::numeric_limits<To>::max())));
}

culler::SceneOptions to_options(const occlude_cull_options& options) {
  const culler::CoverOptions none;
  return {.cover = {.width = options.cover_width,
                    .height = options.cover_height,
                    .triangles = limit<std::size_t>(options.cover_triangles, none.triangles),
                    .ms = options.cover_ms == 0 ? none.ms : options.cover_ms},
          .margin = options.margin,
          .mask = options.mask,
          .least_size = options.least_size,
          .is_front_to_back = options.is_front_to_back != 0};
}

/// The library's frame as arrays. Their memory grows as that of the frame does.
void copy_frame(occlude_view& view) {
  const culler::SceneResult& result = view.view.result();
  view.objects.clear();
  view.sizes.clear();
  view.distances.clear();
  view.planes.clear();
  const std::size_t room = result.drawn.capacity();
  view.objects.reserve(room);
  view.sizes.reserve(room);
  view.distances.reserve(room);
  for (const culler::DrawnObject& drawn : result.drawn) {
    view.objects.push_back(from_id(drawn.id));
    view.sizes.push_back(drawn.size);
    view.distances.push_back(drawn.distance);
  }
  for (const auto& [normal, offset] : result.view) view.planes.push_back({{normal.x, normal.y, normal.z}, offset});
}

/// The next frame of the view, by a camera of either kind.
template <class Camera>
occlude_status cull(const occlude_scene* scene, const Camera* given, const occlude_cull_options* given_options,
                    occlude_view* view) {
  return guarded([&] {
    require(scene, "scene");
    require(view, "view");
    const auto camera = to_camera(given);
    const auto options = read_options(given_options, occlude_cull_options OCCLUDE_CULL_OPTIONS_INIT, "options");
    const culler::Executor executor = options.executor == nullptr ? culler::Executor() : to_executor(options.executor);
    culler::SceneOptions asked = to_options(options);
    asked.executor = &executor;
    static_cast<void>(scene->scene.cull(camera, asked, view->view));
    copy_frame(*view);
    view->camera = camera;
    asked.executor = nullptr;  // it is of this frame alone
    view->options = asked;
  });
}

std::vector<culler::ObjectFate> fates_of(const occlude_scene& scene, const occlude_view& view,
                                         std::span<const culler::ObjectId> objects) {
  if (const auto* camera = std::get_if<culler::Camera>(&view.camera)) {
    return scene.scene.why(*camera, view.options, view.view, objects);
  }
  if (const auto* camera = std::get_if<culler::MatrixCamera>(&view.camera)) {
    return scene.scene.why(*camera, view.options, view.view, objects);
  }
  throw std::invalid_argument("the view has no frame");
}

occlude_reason to_reason(culler::ObjectFate::Reason reason) {
  using Reason = culler::ObjectFate::Reason;
  switch (reason) {
    case Reason::drawn:
      return OCCLUDE_DRAWN;
    case Reason::always_drawn:
      return OCCLUDE_ALWAYS_DRAWN;
    case Reason::out_of_view:
      return OCCLUDE_OUT_OF_PLANE;
    case Reason::hidden:
      return OCCLUDE_HIDDEN;
    case Reason::too_small:
      return OCCLUDE_TOO_SMALL;
    case Reason::in_no_layer:
      return OCCLUDE_IN_NO_LAYER;
    case Reason::not_in_scene:
      break;
  }
  return OCCLUDE_NOT_IN_SCENE;
}

/// Writes the fates. Their arrays are memory of the view, which is taken first, so that it stays where it is.
void copy_fates(const std::vector<culler::ObjectFate>& from, occlude_view& view, occlude_fate* to) {
  std::size_t hiding = 0, corners = 0;
  for (const culler::ObjectFate& fate : from) {
    hiding += fate.by.size();
    for (const auto& by : fate.by) corners += 3 * by.corners.size();
  }
  view.hiding.clear();
  view.hiding.reserve(hiding);
  view.corners.clear();
  view.corners.reserve(corners);
  for (const culler::ObjectFate& fate : from) {
    *to++ = {to_reason(fate.reason), fate.plane, fate.by.size(), view.hiding.data() + view.hiding.size()};
    for (const auto& by : fate.by) {
      view.hiding.push_back({from_id(by.occluder), by.polygon, static_cast<std::uint32_t>(by.corners.size()),
                             view.corners.data() + view.corners.size()});
      for (const kernel::Vec3& v : by.corners) view.corners.insert(view.corners.end(), {v.x, v.y, v.z});
    }
  }
}

occlude_visibility to_visibility(culler::Visibility visibility) {
  switch (visibility) {
    case culler::Visibility::occluded:
      return OCCLUDE_OCCLUDED;
    case culler::Visibility::out_of_view:
      return OCCLUDE_OUT_OF_VIEW;
    case culler::Visibility::visible:
      break;
  }
  return OCCLUDE_VISIBLE;
}

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_look_at_matrix(const occlude_look_at_camera* camera, occlude_clip_depth depth, occlude_nearer nearer,
                                      double* matrix) noexcept {
  return guarded([&] {
    require(matrix, "matrix");
    const auto made = occlude::culler::MatrixCamera::from_camera(to_camera(camera), to_depth(depth), to_nearer(nearer));
    for (int i = 0; i < 16; ++i) matrix[i] = made.matrix[i / 4][i % 4];
  });
}

double occlude_margin_for(uint32_t rows) noexcept { return occlude::culler::margin_for(rows); }

occlude_status occlude_view_create(occlude_view** view) noexcept {
  return guarded([&] {
    require(view, "view");
    *view = new occlude_view;
  });
}

void occlude_view_destroy(occlude_view* view) noexcept { delete view; }

occlude_status occlude_scene_cull(const occlude_scene* scene, const occlude_matrix_camera* camera,
                                  const occlude_cull_options* options, occlude_view* view) noexcept {
  return cull(scene, camera, options, view);
}

occlude_status occlude_scene_cull_look_at(const occlude_scene* scene, const occlude_look_at_camera* camera,
                                          const occlude_cull_options* options, occlude_view* view) noexcept {
  return cull(scene, camera, options, view);
}

occlude_status occlude_view_frame(const occlude_view* view, occlude_frame* frame) noexcept {
  return guarded([&] {
    require(view, "view");
    const occlude_frame values{.size = 0,
                               .count = view->distances.size(),
                               .objects = view->objects.data(),
                               .sizes = view->sizes.data(),
                               .distances = view->distances.data(),
                               .planes = view->planes.data(),
                               .plane_count = view->planes.size()};
    write(values, frame, "frame");
  });
}

occlude_status occlude_view_statistics(const occlude_view* view, occlude_statistics* statistics) noexcept {
  return guarded([&] {
    require(view, "view");
    const occlude::culler::SceneStats& stats = view->view.result().stats;
    const occlude_statistics values{.size = 0,
                                    .drawn = stats.drawn,
                                    .out_of_view = stats.out_of_view,
                                    .hidden = stats.hidden,
                                    .too_small = stats.too_small,
                                    .occluders = stats.occluders,
                                    .nodes_visited = stats.work.nodes_visited,
                                    .view_tests = stats.work.view_tests,
                                    .cover_tests = stats.work.cover_tests,
                                    .cover_groups = stats.work.cover_groups,
                                    .cover_groups_left = stats.work.cover_groups_left,
                                    .cover_triangles = stats.work.cover_triangles};
    write(values, statistics, "statistics");
  });
}

occlude_status occlude_view_visibility(const occlude_view* view, const occlude_boxes* boxes,
                                       occlude_visibility* visibilities) noexcept {
  return guarded([&] {
    require(view, "view");
    const Boxes all(boxes);
    if (all.size() != 0) require(visibilities, "visibilities");
    for (std::size_t i = 0; i < all.size(); ++i) {
      try {
        visibilities[i] = to_visibility(view->view.visibility(all[i]));
      } catch (const std::invalid_argument& e) {
        throw std::invalid_argument("box " + std::to_string(i) + ": " + e.what());
      }
    }
  });
}

occlude_status occlude_scene_why(const occlude_scene* scene, occlude_view* view, const occlude_object* objects, size_t count,
                                 occlude_fate* fates) noexcept {
  return guarded([&] {
    require(scene, "scene");
    require(view, "view");
    if (count != 0) require(objects, "objects");
    if (count != 0) require(fates, "fates");
    copy_fates(fates_of(*scene, *view, known(*scene, {objects, count})), *view, fates);
  });
}
