// SPDX-License-Identifier: MIT
// Frames that are held against culls of regions, and held culls with threads of the caller.
#include <math.h>
#include <stdlib.h>

#include "check.h"

static const double kForward[3] = {1, 0, 0};

/// The wall, what is behind it and what is before it.
static occlude_object behind, before;
static occlude_occluder standing;

static void build(void) {
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &behind));
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, NULL, &before));
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &standing));
  CHECK_OK(occlude_scene_update(scene));
}

static occlude_look_at_camera camera_at(double x) {
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  camera.eye[0] = x;
  camera.target[0] = x + 1;
  return camera;
}

/// The eyes of a camera of either kind count.
static void eyes_that_may_be_anywhere(void) {
  build();
  const occlude_box at_the_edge = {{30, 12, -1}, {31, 12.5, 1}};
  CHECK_OK(occlude_scene_move_object(scene, behind, &at_the_edge));
  CHECK_OK(occlude_scene_update(scene));
  occlude_look_at_camera camera = camera_at(0);
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(!draws(view, behind));
  camera.eyes.radius = 3;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(draws(view, behind));
  camera.eyes.radius = 0;
  camera.eyes.half_edges[1][1] = 3;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(draws(view, behind));
  camera.eyes.radius = -1;
  CHECK(occlude_scene_cull_look_at(scene, &camera, NULL, view) == OCCLUDE_INVALID_ARGUMENT);
}

static int32_t holds_for(double x) {
  const occlude_look_at_camera camera = camera_at(x);
  int32_t holds = 7, of_matrix = 7;
  CHECK_OK(occlude_view_holds_for_look_at(view, &camera, &holds));
  double numbers[16];
  CHECK_OK(occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_GREATER, numbers));
  occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
  matrix.matrix = numbers;
  matrix.depth = OCCLUDE_DEPTH_ZERO_TO_W;
  CHECK_OK(occlude_view_holds_for(view, &matrix, &of_matrix));
  CHECK(holds == of_matrix);
  return holds;
}

static void ways_ahead(void) {
  build();
  occlude_look_at_camera camera = camera_at(0), way = camera;
  CHECK(!holds_for(0));  // before the first frame
  CHECK_OK(occlude_ahead_look_at(&camera, kForward, 2, NULL, &way));
  CHECK(fabs(way.eye[0] - 1) < 1e-12 && way.target[0] == way.eye[0] + 1 && way.near_plane > camera.near_plane);
  CHECK(fabs(way.eyes.half_edges[0][0] - 1) < 1e-9 &&
        fabs(way.eyes.half_edges[1][1]) + fabs(way.eyes.half_edges[2][1]) > 0.09);
  CHECK_OK(occlude_scene_cull_look_at(scene, &way, NULL, view));
  CHECK(!draws(view, behind) && draws(view, before));
  CHECK(holds_for(0.01) && holds_for(1) && holds_for(1.99) && !holds_for(2.01) && !holds_for(-0.01));

  // A head that turns.
  occlude_look_at_camera turned = camera_at(1);
  turned.target[1] = 0.08;  // 4.6 degrees
  int32_t holds = 7;
  CHECK_OK(occlude_view_holds_for_look_at(view, &turned, &holds));
  CHECK(holds == 0);
  occlude_ahead_options options = OCCLUDE_AHEAD_OPTIONS_INIT;
  options.turn_degrees = 5;
  options.aside = 0.5;
  way = camera;
  CHECK_OK(occlude_ahead_look_at(&way, kForward, 2, &options, &way));  // in place
  CHECK(way.fov_y_deg > 65);
  CHECK_OK(occlude_scene_cull_look_at(scene, &way, NULL, view));
  turned.eye[1] = 0.45;
  turned.target[1] = 0.53;
  CHECK_OK(occlude_view_holds_for_look_at(view, &turned, &holds));
  CHECK(holds == 1);

  // Of a matrix.
  double numbers[16];
  CHECK_OK(occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_GREATER, numbers));
  occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
  matrix.matrix = numbers;
  matrix.depth = OCCLUDE_DEPTH_ZERO_TO_W;
  CHECK_OK(occlude_ahead(&matrix, kForward, 2, NULL, &way));
  CHECK_OK(occlude_scene_cull_look_at(scene, &way, NULL, view));
  CHECK(holds_for(0.01) && holds_for(1.99) && !holds_for(2.01));

  // What is refused.
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  CHECK_REFUSED(refused, "velocity is null", occlude_ahead(&matrix, NULL, 1, NULL, &way));
  CHECK_REFUSED(refused, "camera is null", occlude_ahead(NULL, kForward, 1, NULL, &way));
  CHECK_REFUSED(refused, "ahead is null", occlude_ahead_look_at(&camera, kForward, 1, NULL, NULL));
  options.turn_degrees = -1;
  CHECK_REFUSED(refused, "the way ahead: the camera must turn by 0 degrees or more",
                occlude_ahead_look_at(&camera, kForward, 1, &options, &way));
  CHECK(occlude_ahead_look_at(&camera, kForward, NAN, NULL, &way) == refused);
  CHECK_REFUSED(refused, "view is null", occlude_view_holds_for(NULL, &matrix, &holds));
  CHECK_REFUSED(refused, "camera is null", occlude_view_holds_for(view, NULL, &holds));
  CHECK_REFUSED(refused, "holds is null", occlude_view_holds_for_look_at(view, &camera, NULL));
}

/// Asks with cameras of either kind, and culls where the answer is yes.
static int32_t cull_held(const occlude_view* held, double x, const occlude_cull_options* options) {
  const occlude_look_at_camera camera = camera_at(x);
  double numbers[16];
  CHECK_OK(occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_GREATER, numbers));
  occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
  matrix.matrix = numbers;
  matrix.depth = OCCLUDE_DEPTH_ZERO_TO_W;
  int32_t holds = 7, of_matrix = 7;
  CHECK_OK(occlude_scene_holds_look_at(scene, held, &camera, options, &holds));
  CHECK_OK(occlude_scene_holds(scene, held, &matrix, options, &of_matrix));
  CHECK(holds == of_matrix);
  const occlude_status expected = holds ? OCCLUDE_OK : OCCLUDE_INVALID_ARGUMENT;
  CHECK(occlude_scene_cull_held(scene, &matrix, options, held, view) == expected);
  CHECK(occlude_scene_cull_held_look_at(scene, &camera, options, held, view) == expected);
  if (!holds) CHECK(strcmp(occlude_last_error(), "the held frame does not hold") == 0);
  return holds;
}

static void frames_that_are_held(void) {
  build();
  occlude_view* held = NULL;
  CHECK_OK(occlude_view_create(&held));
  occlude_look_at_camera way = camera_at(0);
  CHECK_OK(occlude_ahead_look_at(&way, kForward, 2, NULL, &way));
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  CHECK_OK(occlude_scene_cull_look_at(scene, &way, &options, held));
  CHECK(!cull_held(held, 1, NULL));  // it was not said that it is to be held
  options.is_to_be_held = 1;
  CHECK_OK(occlude_scene_cull_look_at(scene, &way, &options, held));
  CHECK(cull_held(held, 1, NULL) && !cull_held(held, 3, NULL));
  CHECK(!draws(view, behind) && draws(view, before));
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(statistics.hidden == 1 && statistics.drawn == 1 && statistics.cover_triangles == 0);
  options.mask = 1;
  CHECK(!cull_held(held, 1, &options));

  // Nothing is known of why, and a view is not held against itself.
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  occlude_fate fate;
  CHECK_REFUSED(refused, "the view's last frame is not of this scene as the last update() left it",
                occlude_scene_why(scene, view, &behind, 1, &fate));
  const occlude_look_at_camera camera = camera_at(1);
  CHECK_REFUSED(refused, "a frame cannot be held against its own view",
                occlude_scene_cull_held_look_at(scene, &camera, NULL, held, held));

  // Objects are where they are now. Occluders that are gone hide nothing.
  CHECK_OK(occlude_scene_move_object(scene, before, &kBehind));
  CHECK_OK(occlude_scene_move_object(scene, behind, &kBeside));
  CHECK_OK(occlude_scene_update(scene));
  CHECK(cull_held(held, 1, NULL));
  CHECK(draws(view, behind) && !draws(view, before));
  CHECK_OK(occlude_scene_remove_occluder(scene, standing));
  CHECK_OK(occlude_scene_update(scene));
  CHECK(!cull_held(held, 1, NULL));

  int32_t holds = 7;
  CHECK_REFUSED(refused, "scene is null", occlude_scene_holds_look_at(NULL, held, &camera, NULL, &holds));
  CHECK_REFUSED(refused, "held is null", occlude_scene_holds_look_at(scene, NULL, &camera, NULL, &holds));
  CHECK_REFUSED(refused, "holds is null", occlude_scene_holds_look_at(scene, held, &camera, NULL, NULL));
  CHECK_REFUSED(refused, "camera is null", occlude_scene_holds(scene, held, NULL, NULL, &holds));
  CHECK_REFUSED(refused, "held is null", occlude_scene_cull_held_look_at(scene, &camera, NULL, NULL, view));
  CHECK_REFUSED(refused, "view is null", occlude_scene_cull_held_look_at(scene, &camera, NULL, held, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_cull_held_look_at(NULL, &camera, NULL, held, view));
  CHECK_REFUSED(refused, "camera is null", occlude_scene_cull_held(scene, NULL, NULL, held, view));
  occlude_view_destroy(held);
}

/// Tasks that wait for their time.
enum { kMostTasks = 64 };
typedef struct queue {
  struct {
    occlude_task task;
    void* work;
  } tasks[kMostTasks];
  size_t count, run;
} queue;

static void put(void* context, occlude_task task, void* work) {
  queue* q = context;
  if (q->count == kMostTasks) abort();
  q->tasks[q->count].task = task;
  q->tasks[q->count++].work = work;
}

static void run_all(queue* q) {
  for (; q->run < q->count; ++q->run) q->tasks[q->run].task(q->tasks[q->run].work);
}

static void at_once(void* context, occlude_task task, void* work) {
  ++*(size_t*)context;
  task(work);
}

/// Whether the last frame draws the object.
static int held_draws(const occlude_held_cull* held, occlude_object object) {
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_held_cull_frame(held, &frame));
  for (size_t i = 0; i < frame.count; ++i) {
    if (frame.objects[i].number == object.number) return 1;
  }
  return 0;
}

/// A second's walk with 60 frames; every other one is a matrix. Returns the counts. Tasks of a queue run after each fifth.
static occlude_held_counts walk(occlude_held_cull* held, double from, queue* q) {
  for (int i = 0; i < 60; ++i) {
    const occlude_look_at_camera camera = camera_at(from + i / 60.0);
    double numbers[16];
    CHECK_OK(occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_GREATER, numbers));
    occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
    matrix.matrix = numbers;
    matrix.depth = OCCLUDE_DEPTH_ZERO_TO_W;
    const double seconds = from + i / 60.0;
    CHECK_OK(i % 2 == 0 ? occlude_held_cull_next_look_at(held, &camera, seconds)
                        : occlude_held_cull_next(held, &matrix, seconds));
    CHECK(!held_draws(held, behind) && held_draws(held, before));
    occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
    CHECK_OK(occlude_held_cull_statistics(held, &statistics));
    CHECK(statistics.hidden == 1 && statistics.drawn == 1);
    CHECK((statistics.cover_triangles > 0) == occlude_held_cull_is_of_point(held));
    if (q != NULL && i % 5 == 4) run_all(q);
  }
  occlude_held_counts counts = OCCLUDE_HELD_COUNTS_INIT;
  CHECK_OK(occlude_held_cull_counts(held, &counts));
  return counts;
}

static void held_culls(void) {
  build();
  occlude_held_cull* held = NULL;
  CHECK_OK(occlude_held_cull_create(scene, NULL, &held));
  CHECK(!held_draws(held, before) && !occlude_held_cull_is_of_point(held));
  occlude_held_counts counts = walk(held, 0, NULL);
  CHECK(counts.frames == 60 && counts.of_point < 60 && counts.regions > 0);  // on the calling thread
  occlude_held_cull_destroy(held);

  // A job system. What it is given once the held cull is gone does nothing, or is never called by it.
  queue q = {.count = 0};
  size_t tasks = 0;
  occlude_held_options options = OCCLUDE_HELD_OPTIONS_INIT;
  options.later = put;
  options.context = &q;
  options.is_repeatable = 1;
  CHECK_OK(occlude_held_cull_create(scene, &options, &held));
  counts = walk(held, 0, &q);
  CHECK(counts.of_point > 0 && counts.of_point < 60 && counts.regions == q.count);
  options.later = at_once;
  options.context = &tasks;
  occlude_held_cull* other = NULL;
  CHECK_OK(occlude_held_cull_create(scene, &options, &other));
  const occlude_held_counts same = walk(other, 0, NULL);
  CHECK(same.of_point == counts.of_point && same.regions == counts.regions && same.late == counts.late);
  CHECK(tasks == counts.regions);
  occlude_held_cull_destroy(other);
  const occlude_look_at_camera far = camera_at(-50);
  CHECK_OK(occlude_held_cull_next_look_at(held, &far, 2));
  run_all(&q);
  const size_t asked = q.count;
  for (int i = 0; i < 20 && q.count == asked; ++i) {
    const occlude_look_at_camera camera = camera_at(-50 - 10 * i);
    CHECK_OK(occlude_held_cull_next_look_at(held, &camera, 2 + 0.1 * i));
  }
  CHECK(q.count > q.run);
  occlude_held_cull_destroy(held);
  run_all(&q);
}

/// Options reach the culls: the layers, and the executor on the calling thread alone.
static void options_of_held_culls(void) {
  build();
  occlude_object layered = OCCLUDE_NONE;
  occlude_object_options of_object = OCCLUDE_OBJECT_OPTIONS_INIT;
  of_object.mask = 2;
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, &of_object, &layered));
  CHECK_OK(occlude_scene_update(scene));
  occlude_cull_options cull_options = OCCLUDE_CULL_OPTIONS_INIT;
  cull_options.mask = ~2u;
  occlude_held_options options = OCCLUDE_HELD_OPTIONS_INIT;
  options.cull = &cull_options;
  occlude_held_cull* held = NULL;
  CHECK_OK(occlude_held_cull_create(scene, &options, &held));
  cull_options.mask = ~0u;  // it was read
  CHECK(walk(held, 0, NULL).of_point < 60);
  CHECK(!held_draws(held, layered));
  occlude_held_cull_destroy(held);

  // A wider way holds for eyes that a narrower one leaves out.
  size_t tasks[2] = {0, 0};
  for (int is_wide = 0; is_wide < 2; ++is_wide) {
    occlude_ahead_options way = OCCLUDE_AHEAD_OPTIONS_INIT;
    way.aside = is_wide ? 2 : 0.01;
    options.cull = NULL;
    options.way = &way;
    options.later = at_once;
    options.context = &tasks[is_wide];
    options.is_repeatable = 1;
    CHECK_OK(occlude_held_cull_create(scene, &options, &held));
    for (int i = 0; i < 60; ++i) {
      occlude_look_at_camera camera = camera_at(0);
      camera.eye[1] = camera.target[1] = i % 2 ? 0.5 : -0.5;
      CHECK_OK(occlude_held_cull_next_look_at(held, &camera, i / 60.0));
    }
    occlude_held_cull_destroy(held);
  }
  CHECK(tasks[1] > 0 && tasks[0] > tasks[1]);
}

static void refusals(void) {
  build();
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  occlude_held_cull* held = NULL;
  occlude_held_options options = OCCLUDE_HELD_OPTIONS_INIT;
  const occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
  occlude_look_at_camera camera = camera_at(0);
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  occlude_held_counts counts = OCCLUDE_HELD_COUNTS_INIT;
  CHECK_REFUSED(refused, "scene is null", occlude_held_cull_create(NULL, &options, &held));
  CHECK_REFUSED(refused, "held is null", occlude_held_cull_create(scene, &options, NULL));
  options.reserved = 1;
  CHECK_REFUSED(refused, "options: reserved is not 0", occlude_held_cull_create(scene, &options, &held));
  options.reserved = 0;
  occlude_cull_options cull_options = OCCLUDE_CULL_OPTIONS_INIT;
  cull_options.size = 3;
  options.cull = &cull_options;
  CHECK_REFUSED(refused, "cull of the options: its size is 3, which is of no version",
                occlude_held_cull_create(scene, &options, &held));
  options.cull = NULL;
  occlude_ahead_options way = OCCLUDE_AHEAD_OPTIONS_INIT;
  options.way = &way;
  way.aside = NAN;
  CHECK(occlude_held_cull_create(scene, &options, &held) == refused && held == NULL);
  way.aside = 0.1;
  CHECK_OK(occlude_held_cull_create(scene, &options, &held));

  CHECK_REFUSED(refused, "held is null", occlude_held_cull_next(NULL, &matrix, 0));
  CHECK_REFUSED(refused, "held is null", occlude_held_cull_next_look_at(NULL, &camera, 0));
  CHECK_REFUSED(refused, "camera is null", occlude_held_cull_next(held, NULL, 0));
  CHECK_REFUSED(refused, "matrix is null", occlude_held_cull_next(held, &matrix, 0));
  CHECK_OK(occlude_held_cull_next_look_at(held, &camera, 0));
  CHECK_REFUSED(refused, "the time of the frame is not finite", occlude_held_cull_next_look_at(held, &camera, INFINITY));
  camera.near_plane = -1;
  CHECK(occlude_held_cull_next_look_at(held, &camera, 1) == refused);
  CHECK(held_draws(held, before));  // it keeps its last frame
  CHECK_REFUSED(refused, "held is null", occlude_held_cull_frame(NULL, &frame));
  CHECK_REFUSED(refused, "frame is null", occlude_held_cull_frame(held, NULL));
  CHECK_REFUSED(refused, "held is null", occlude_held_cull_statistics(NULL, &statistics));
  CHECK_REFUSED(refused, "statistics is null", occlude_held_cull_statistics(held, NULL));
  CHECK_REFUSED(refused, "held is null", occlude_held_cull_counts(NULL, &counts));
  CHECK_REFUSED(refused, "counts is null", occlude_held_cull_counts(held, NULL));
  CHECK(!occlude_held_cull_is_of_point(NULL));
  occlude_held_cull_destroy(held);
  occlude_held_cull_destroy(NULL);
}

int main(void) {
  run_test(eyes_that_may_be_anywhere);
  run_test(ways_ahead);
  run_test(frames_that_are_held);
  run_test(held_culls);
  run_test(options_of_held_culls);
  run_test(refusals);
  return end_of_test();
}
