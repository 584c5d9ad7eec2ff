// SPDX-License-Identifier: MIT
// Checks of the tests in C, and a street for them: a wall across the x axis, and boxes on both sides of it.
#ifndef CHECK_H
#define CHECK_H

#include <occlude.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static inline void check_at(int is_true, const char* what, const char* file, int line) {
  if (is_true) return;
  printf("%s:%d: not so: %s\n", file, line, what);
  ++failures;
}

#define CHECK(condition) check_at((condition) ? 1 : 0, #condition, __FILE__, __LINE__)
#define CHECK_OK(call) check_at((call) == OCCLUDE_OK, #call, __FILE__, __LINE__)

static inline void check_refused_at(occlude_status status, occlude_status expected, const char* text, const char* what,
                                    const char* file, int line) {
  if (status == expected && strcmp(occlude_last_error(), text) == 0) return;
  printf("%s:%d: %s is \"%s\", %s\n", file, line, what, occlude_last_error(), occlude_status_text(status));
  ++failures;
}

/// Checks the status and the message of a call that fails.
#define CHECK_REFUSED(expected, text, call) check_refused_at((call), (expected), (text), #call, __FILE__, __LINE__)

static inline int end_of_test(void) {
  printf(failures == 0 ? "All checks passed\n" : "%d checks failed\n", failures);
  return failures == 0 ? 0 : 1;
}

/// The wall {10} x [-5, 5] x [-5, 5], a square, as two triangles in floats.
static inline occlude_mesh* make_wall(void) {
  static const float vertices[] = {10, -5, -5, 10, 5, -5, 10, 5, 5, 10, -5, 5};
  static const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = vertices;
  data.vertices.count = 4;
  data.vertices.type = OCCLUDE_FLOAT;
  data.indices = indices;
  data.index_count = 6;
  occlude_mesh* mesh = NULL;
  CHECK_OK(occlude_mesh_create(&data, &mesh));
  return mesh;
}

/// Boxes as arrays of doubles.
static inline occlude_boxes boxes_of(const occlude_box* boxes, size_t count) {
  occlude_boxes result = {boxes, count, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
  return result;
}

static const occlude_box kBehind = {{20, -1, -1}, {21, 1, 1}}, kBefore = {{5, -1, -1}, {6, 1, 1}},
                         kBeside = {{20, 8, -1}, {21, 10, 1}}, kAway = {{-20, -1, -1}, {-19, 1, 1}};

/// Whether the last frame of the view draws the object.
static inline int draws(const occlude_view* view, occlude_object object) {
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_view_frame(view, &frame));
  for (size_t i = 0; i < frame.count; ++i) {
    if (frame.objects[i].number == object.number) return 1;
  }
  return 0;
}

/// Culls with the default camera, from the origin along x.
static inline void cull(occlude_scene* scene, occlude_view* view) {
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
}

/// What each test begins with: an empty scene, a view without a frame, and the wall, which is not in the scene yet.
static occlude_scene* scene = NULL;
static occlude_view* view = NULL;
static occlude_mesh* wall = NULL;

/// Runs a test, which may destroy any of the three if it sets it to null.
static inline void run_test(void (*test)(void)) {
  CHECK_OK(occlude_scene_create(&scene));
  CHECK_OK(occlude_view_create(&view));
  wall = make_wall();
  test();
  occlude_mesh_destroy(wall);
  occlude_view_destroy(view);
  occlude_scene_destroy(scene);
}

#endif
