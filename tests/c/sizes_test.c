// SPDX-License-Identifier: MIT
// Structs of older headers, which are shorter, and of newer ones, which are longer.
#include <stdlib.h>

#include "check.h"

/// A copy of the first `size` bytes, in memory that ends there: a read beyond shows under a sanitizer.
static void* shortened(const void* whole, size_t size) {
  void* copy = malloc(size);
  if (copy == NULL) abort();
  memcpy(copy, whole, size);
  memcpy(copy, &size, sizeof size);
  return copy;
}

/// Every length of a struct is taken that ends with a whole word; `works` uses it.
static void every_length(const void* whole, size_t full, occlude_status (*works)(const void* options)) {
  for (size_t size = sizeof(size_t); size <= full; ++size) {
    void* options = shortened(whole, size);
    const occlude_status expected = size % sizeof(size_t) == 0 ? OCCLUDE_OK : OCCLUDE_INVALID_ARGUMENT;
    check_at(works(options) == expected, "the struct is taken as its size says", __FILE__, (int)size);
    free(options);
  }
  unsigned char longer[512] = {0};
  memcpy(longer, whole, full);
  size_t size = full + sizeof(size_t);
  memcpy(longer, &size, sizeof size);
  CHECK(works(longer) == OCCLUDE_INVALID_ARGUMENT && strstr(occlude_last_error(), "is of a newer version than the library"));
  size = 0;
  memcpy(longer, &size, sizeof size);
  CHECK(works(longer) == OCCLUDE_INVALID_ARGUMENT && strstr(occlude_last_error(), "its size is 0, which is of no version"));
}

static occlude_object behind = OCCLUDE_NONE;

static occlude_status add_object(const void* options) {
  occlude_object object = OCCLUDE_NONE;
  const occlude_status status = occlude_scene_add_object(scene, &kBefore, options, &object);
  if (status == OCCLUDE_OK) {
    cull(scene, view);
    CHECK(draws(view, object));  // by the default mask, whatever the struct has of it
    CHECK_OK(occlude_scene_remove_object(scene, object));
  }
  return status;
}

static occlude_status add_occluder(const void* options) {
  occlude_occluder occluder = OCCLUDE_NONE;
  const occlude_status status = occlude_scene_add_occluder(scene, wall, NULL, options, &occluder);
  if (status == OCCLUDE_OK) {
    cull(scene, view);
    CHECK(!draws(view, behind));
    CHECK_OK(occlude_scene_remove_occluder(scene, occluder));
  }
  return status;
}

static occlude_status cull_by_camera(const void* camera) {
  const occlude_status status = occlude_scene_cull_look_at(scene, camera, NULL, view);
  if (status == OCCLUDE_OK) CHECK(draws(view, behind));
  return status;
}

static occlude_status cull_by_options(const void* options) {
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  const occlude_status status = occlude_scene_cull_look_at(scene, &camera, options, view);
  if (status == OCCLUDE_OK) CHECK(draws(view, behind));
  return status;
}

static occlude_status make_mesh(const void* data) {
  occlude_mesh* mesh = NULL;
  const occlude_status status = occlude_mesh_create(data, &mesh);
  occlude_mesh_destroy(mesh);
  return status;
}

static occlude_status simplify(const void* options) {
  const occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  occlude_simplified* simplified = NULL;
  const occlude_status status = occlude_simplified_create(&data, options, &simplified);
  occlude_simplified_destroy(simplified);
  return status;
}

static occlude_status go_ahead(const void* options) {
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  const double velocity[3] = {1, 0, 0};
  const occlude_status status = occlude_ahead_look_at(&camera, velocity, 1, options, &camera);
  // The box of the eyes, by the defaults of what the struct does not have.
  if (status == OCCLUDE_OK) CHECK(camera.eyes.half_edges[0][0] > 0.49 && camera.eyes.half_edges[2][2] > 0.049);
  return status;
}

static occlude_status hold(const void* options) {
  occlude_held_cull* held = NULL;
  const occlude_status status = occlude_held_cull_create(scene, options, &held);
  occlude_held_cull_destroy(held);
  return status;
}

/// What is written ends where the struct does.
static void outputs(void) {
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  statistics.size = 2 * sizeof(size_t);
  statistics.out_of_view = 77;
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(statistics.size == 2 * sizeof(size_t) && statistics.drawn == 1 && statistics.out_of_view == 77);
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  frame.size = offsetof(occlude_frame, sizes);
  CHECK_OK(occlude_view_frame(view, &frame));
  CHECK(frame.count == 1 && frame.objects[0].number == behind.number && frame.sizes == NULL && frame.plane_count == 0);
  frame.size = sizeof frame + sizeof(size_t);
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "frame is of a newer version than the library", occlude_view_frame(view, &frame));
  frame.size = 3;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "frame: its size is 3, which is of no version", occlude_view_frame(view, &frame));
  const occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  occlude_simplified* simplified = NULL;
  CHECK_OK(occlude_simplified_create(&data, NULL, &simplified));
  occlude_occluders occluders = OCCLUDE_OCCLUDERS_INIT;
  occluders.size = offsetof(occlude_occluders, flat_triangles);
  occluders.drawn_triangles = occluders.flat_triangles = 77;
  CHECK_OK(occlude_simplified_occluders(simplified, &occluders));
  CHECK(occluders.drawn_triangles == 0 && occluders.flat_triangles == 77);
  occlude_simplified_destroy(simplified);
  occlude_held_cull* held = NULL;
  CHECK_OK(occlude_held_cull_create(scene, NULL, &held));
  occlude_held_counts counts = OCCLUDE_HELD_COUNTS_INIT;
  counts.size = 2 * sizeof(size_t);
  counts.regions = 77;
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  CHECK_OK(occlude_held_cull_next_look_at(held, &camera, 0));
  CHECK_OK(occlude_held_cull_counts(held, &counts));
  CHECK(counts.frames == 1 && counts.of_point == 0 && counts.regions == 77);
  occlude_held_cull_destroy(held);
}

/// The first version's matrix, depth and order are needed; the eyes are not.
static void matrix_camera(void) {
  const float matrix[] = {0, -1, 0, 0, 0, 0, 1, 0, 1, 0, 0, -0.2F, 1, 0, 0, 0};
  occlude_matrix_camera camera = OCCLUDE_MATRIX_CAMERA_INIT;
  camera.matrix = matrix;
  camera.type = OCCLUDE_FLOAT;
  camera.order = OCCLUDE_ROWS;
  camera.depth = OCCLUDE_DEPTH_ZERO_TO_W;
  camera.eyes.radius = -1;
  CHECK(occlude_scene_cull(scene, &camera, NULL, view) == OCCLUDE_INVALID_ARGUMENT);
  occlude_matrix_camera* shorter = shortened(&camera, offsetof(occlude_matrix_camera, eyes));
  CHECK_OK(occlude_scene_cull(scene, shorter, NULL, view));
  free(shorter);
  camera.size = sizeof camera + sizeof(size_t);
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "camera is of a newer version than the library",
                occlude_scene_cull(scene, &camera, NULL, view));
}

static void reserved(void) {
  occlude_object_options object = OCCLUDE_OBJECT_OPTIONS_INIT;
  object.reserved = 1;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "options: reserved is not 0", add_object(&object));
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  camera.reserved = 1;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "camera: reserved is not 0", cull_by_camera(&camera));
  occlude_held_options held = OCCLUDE_HELD_OPTIONS_INIT;
  held.reserved = 1;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "options: reserved is not 0", hold(&held));
}

static void sizes(void) {
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &behind));
  const occlude_object_options object = OCCLUDE_OBJECT_OPTIONS_INIT;
  const occlude_occluder_options occluder = OCCLUDE_OCCLUDER_OPTIONS_INIT;
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  const occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  const occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  const occlude_simplify_options simple = OCCLUDE_SIMPLIFY_OPTIONS_INIT;
  const occlude_ahead_options ahead = OCCLUDE_AHEAD_OPTIONS_INIT;
  const occlude_held_options held = OCCLUDE_HELD_OPTIONS_INIT;
  every_length(&object, sizeof object, add_object);
  every_length(&occluder, sizeof occluder, add_occluder);
  CHECK_OK(occlude_scene_update(scene));
  every_length(&camera, sizeof camera, cull_by_camera);
  every_length(&options, sizeof options, cull_by_options);
  every_length(&data, sizeof data, make_mesh);
  every_length(&simple, sizeof simple, simplify);
  every_length(&ahead, sizeof ahead, go_ahead);
  every_length(&held, sizeof held, hold);
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &options, view));
  outputs();
  reserved();
  matrix_camera();
}

int main(void) {
  run_test(sizes);
  return end_of_test();
}
