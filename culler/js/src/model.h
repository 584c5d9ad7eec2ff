// SPDX-License-Identifier: MIT
// Models as the C interface would have them, culled by cover: `Culler` for JavaScript, which reaches functions of C alone.
// As in occlude.h, no function throws; those that can fail return an occlude_status.
#pragma once

#include <cstddef>
#include <cstdint>

#include "occlude.h"

extern "C" {

/// A model that stands still, with all that frames need, and one camera of it with its last frame.
typedef struct occlude_model occlude_model;
typedef struct occlude_model_view occlude_model_view;

/// As occlude_cull_options.
typedef struct occlude_model_options {
  std::int32_t cover_width, cover_height;
  std::uint64_t cover_work;
  double cover_ms, margin;
  std::int32_t is_adaptive, reserved;
} occlude_model_options;

#define OCCLUDE_MODEL_OPTIONS_INIT \
  { 576, 360, 0, 0, 0, 1, 0 }

/// Polygons of the model's order.
typedef struct occlude_range {
  std::uint32_t first, count;
} occlude_range;

/// Polygons that are not drawn: beyond planes[plane], or hidden.
typedef struct occlude_culled_range {
  std::uint32_t first, count, plane;
} occlude_culled_range;

#define OCCLUDE_HIDDEN_RANGE 0xffffffffu

/// The last frame of a view. The arrays belong to the view.
typedef struct occlude_model_frame {
  const occlude_range* drawn;
  std::size_t drawn_count;
  const occlude_culled_range* culled;
  std::size_t culled_count;
  const occlude_half_space* planes;
  std::size_t plane_count;
  std::size_t drawn_polygons, out_of_view_polygons, hidden_polygons;
  std::size_t unasked_polygons;  ///< drawn: the budget was spent, or they were idle
  std::size_t nodes_visited, view_tests, cover_tests, cover_triangles;
  std::uint64_t cover_work;  ///< as occlude_cull_options.cover_work counts it
} occlude_model_frame;

OCCLUDE_API occlude_status occlude_model_create(const occlude_mesh_data* data, std::uint32_t leaf_size,
                                                std::int32_t is_of_oriented_boxes, occlude_model** model) noexcept;
OCCLUDE_API void occlude_model_destroy(occlude_model* model) noexcept;
OCCLUDE_API std::size_t occlude_model_polygons(const occlude_model* model) noexcept;
/// Writes the number that each polygon of the model's order had when given.
OCCLUDE_API occlude_status occlude_model_order(const occlude_model* model, std::uint32_t* order) noexcept;

OCCLUDE_API occlude_status occlude_model_view_create(occlude_model_view** view) noexcept;
OCCLUDE_API void occlude_model_view_destroy(occlude_model_view* view) noexcept;
/// The next frame of the view, which starts anew if the frame before was of another model.
OCCLUDE_API occlude_status occlude_model_cull(const occlude_model* model, const occlude_matrix_camera* camera,
                                              const occlude_model_options* options, occlude_model_view* view) noexcept;
OCCLUDE_API occlude_status occlude_model_cull_look_at(const occlude_model* model, const occlude_look_at_camera* camera,
                                                      const occlude_model_options* options,
                                                      occlude_model_view* view) noexcept;
OCCLUDE_API occlude_status occlude_model_view_frame(const occlude_model_view* view, occlude_model_frame* frame) noexcept;
OCCLUDE_API occlude_status occlude_model_view_holds_for(const occlude_model_view* view, const occlude_matrix_camera* camera,
                                                        std::int32_t* holds) noexcept;
OCCLUDE_API occlude_status occlude_model_view_holds_for_look_at(const occlude_model_view* view,
                                                                const occlude_look_at_camera* camera,
                                                                std::int32_t* holds) noexcept;

}  // extern "C"
