// SPDX-License-Identifier: MIT
// Threads of the caller: the same results as on one thread. Tasks on threads of the caller.
#include <pthread.h>
#include <stdlib.h>

#include "check.h"

enum { kThreads = 3, kObjects = 20000 };

/// What a thread of the pool does: each third part.
typedef struct share {
  size_t first, count;
  occlude_part part;
  void* work;
} share;

static void* do_share(void* given) {
  const share* of = given;
  for (size_t i = of->first; i < of->count; i += kThreads) of->part(of->work, i);
  return NULL;
}

static void on_threads(void* runs, size_t count, occlude_part part, void* work) {
  pthread_t threads[kThreads];
  share shares[kThreads];
  for (size_t i = 0; i < kThreads; ++i) {
    const share of = {i, count, part, work};
    shares[i] = of;
    if (pthread_create(&threads[i], NULL, do_share, &shares[i]) != 0) abort();
  }
  for (size_t i = 0; i < kThreads; ++i) pthread_join(threads[i], NULL);
  ++*(size_t*)runs;
}

static void backwards(void* runs, size_t count, occlude_part part, void* work) {
  ++*(size_t*)runs;
  while (count > 0) part(work, --count);
}

/// A frame of many boxes on both sides of the wall, in a scene that this executor updates; null: on one thread.
static void cull_many(const occlude_executor* executor) {
  occlude_scene_destroy(scene);
  CHECK_OK(occlude_scene_create(&scene));
  static occlude_box boxes[kObjects];
  static occlude_object ids[kObjects];
  for (int i = 0; i < kObjects; ++i) {
    const double x = i % 40, y = i / 40 % 25 - 12, z = i / 1000 - 10;
    const occlude_box box = {{x, y, z}, {x + 0.5, y + 0.5, z + 0.5}};
    boxes[i] = box;
  }
  const occlude_boxes all = boxes_of(boxes, kObjects);
  CHECK_OK(occlude_scene_add_objects(scene, &all, NULL, ids));
  occlude_occluder occluder = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  CHECK_OK(executor == NULL ? occlude_scene_update(scene) : occlude_scene_update_by(scene, executor));
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.executor = executor;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &options, view));
}

static void results_are_the_same(void) {
  cull_many(NULL);
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_view_frame(view, &frame));
  static uint32_t drawn[kObjects];  // slots: ids are those of one scene
  const size_t count = frame.count;
  for (size_t i = 0; i < count; ++i) drawn[i] = OCCLUDE_SLOT(frame.objects[i]);
  occlude_statistics expected = OCCLUDE_STATISTICS_INIT, statistics = OCCLUDE_STATISTICS_INIT;
  CHECK_OK(occlude_view_statistics(view, &expected));
  CHECK(expected.drawn > 1000 && expected.hidden > 1000 && expected.out_of_view > 1000);

  for (int way = 0; way < 2; ++way) {
    size_t runs = 0;
    occlude_executor executor = OCCLUDE_EXECUTOR_INIT;
    executor.threads = kThreads;
    executor.run = way == 0 ? on_threads : backwards;
    executor.context = &runs;
    cull_many(&executor);
    CHECK(runs == 2);  // the update, the cull
    CHECK_OK(occlude_view_frame(view, &frame));
    CHECK(frame.count == count);
    for (size_t i = 0; i < frame.count && i < count; ++i) CHECK(OCCLUDE_SLOT(frame.objects[i]) == drawn[i]);
    CHECK_OK(occlude_view_statistics(view, &statistics));
    CHECK(memcmp(&statistics, &expected, sizeof expected) == 0);
    // The frame keeps nothing of its executor.
    occlude_fate fate = {OCCLUDE_DRAWN, 0, 0, NULL};
    executor.run = NULL;
    CHECK_OK(occlude_scene_why(scene, view, frame.objects, 1, &fate));
    CHECK(fate.reason == OCCLUDE_DRAWN);
  }
}

/// A wall of many panels.
static void meshes(void) {
  enum { kSide = 150 };
  static double vertices[(kSide + 1) * (kSide + 1)][3];
  static uint32_t indices[kSide * kSide][4], sizes[kSide * kSide];
  for (uint32_t i = 0; i < (kSide + 1) * (kSide + 1); ++i) {
    vertices[i][0] = 10;
    vertices[i][1] = i % (kSide + 1);
    vertices[i][2] = i / (kSide + 1);
  }
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    const uint32_t at = i / kSide * (kSide + 1) + i % kSide;
    const uint32_t panel[] = {at, at + 1, at + kSide + 2, at + kSide + 1};
    memcpy(indices[i], panel, sizeof panel);
    sizes[i] = 4;
  }
  size_t runs = 0;
  const occlude_executor executor = {sizeof executor, kThreads, on_threads, &runs};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = vertices;
  data.vertices.count = (kSide + 1) * (kSide + 1);
  data.indices = indices[0];
  data.index_count = 4 * kSide * kSide;
  data.polygon_sizes = sizes;
  data.polygon_count = kSide * kSide;
  data.executor = &executor;
  occlude_mesh* mesh = NULL;
  CHECK_OK(occlude_mesh_create(&data, &mesh));
  CHECK(runs > 0 && occlude_mesh_polygons(mesh) == kSide * kSide);
  occlude_mesh_destroy(mesh);
}

/// A thread for each task.
enum { kMostTasks = 200 };
typedef struct started {
  pthread_t threads[kMostTasks];
  size_t count;
} started;

typedef struct job {
  occlude_task task;
  void* work;
} job;

static void* do_job(void* given) {
  const job of = *(job*)given;
  free(given);
  of.task(of.work);
  return NULL;
}

static void on_a_thread(void* context, occlude_task task, void* work) {
  started* all = context;
  job* of = malloc(sizeof *of);
  if (of == NULL || all->count == kMostTasks) abort();
  of->task = task;
  of->work = work;
  if (pthread_create(&all->threads[all->count++], NULL, do_job, of) != 0) abort();
}

/// Regions are culled beside frames, whose objects the executor tests, and beside updates. Those of a held cull that is gone
/// do nothing any more.
static void regions(void) {
  started all = {.count = 0};
  size_t runs = 0;
  const occlude_executor executor = {sizeof executor, kThreads, on_threads, &runs};
  cull_many(NULL);
  occlude_object bus = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, NULL, &bus));
  occlude_cull_options of_culls = OCCLUDE_CULL_OPTIONS_INIT;
  of_culls.executor = &executor;
  occlude_held_options options = OCCLUDE_HELD_OPTIONS_INIT;
  options.cull = &of_culls;
  options.later = on_a_thread;
  options.context = &all;
  occlude_held_cull* held = NULL;
  CHECK_OK(occlude_held_cull_create(scene, &options, &held));
  for (int i = 0; i < 60; ++i) {
    CHECK_OK(occlude_scene_move_object(scene, bus, i % 2 ? &kBefore : &kBeside));
    CHECK_OK(occlude_scene_update(scene));
    occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
    camera.eye[0] = 0.02 * i;
    camera.target[0] = camera.eye[0] + 1;
    CHECK_OK(occlude_held_cull_next_look_at(held, &camera, i / 60.0));
  }
  occlude_held_counts counts = OCCLUDE_HELD_COUNTS_INIT;
  CHECK_OK(occlude_held_cull_counts(held, &counts));
  CHECK(counts.frames == 60 && counts.regions == all.count && all.count > 0 && runs >= 60);
  occlude_held_cull_destroy(held);
  for (size_t i = 0; i < all.count; ++i) pthread_join(all.threads[i], NULL);
}

/// Checks that all that takes an executor refuses this one.
static void check_refused(const occlude_executor* executor, const char* text) {
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.executor = executor;
  CHECK_REFUSED(refused, text, occlude_scene_cull_look_at(scene, &camera, &options, view));
  CHECK_REFUSED(refused, text, occlude_scene_update_by(scene, executor));
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.executor = executor;
  occlude_mesh* mesh = NULL;
  CHECK_REFUSED(refused, text, occlude_mesh_create(&data, &mesh));
  CHECK(mesh == NULL);
  occlude_held_options held_options = OCCLUDE_HELD_OPTIONS_INIT;
  held_options.cull = &options;
  occlude_held_cull* held = NULL;
  CHECK_REFUSED(refused, text, occlude_held_cull_create(scene, &held_options, &held));
  CHECK(held == NULL);
}

static void refusals(void) {
  size_t runs = 0;
  occlude_executor executor = OCCLUDE_EXECUTOR_INIT;
  check_refused(&executor, "run of the executor is null");
  executor.run = backwards;
  executor.context = &runs;
  executor.threads = 0;
  check_refused(&executor, "threads of the executor is 0, must be 1 to 65536");
  executor.threads = 65537;
  check_refused(&executor, "threads of the executor is 65537, must be 1 to 65536");
  executor.threads = 1;
  executor.size = sizeof executor + sizeof(size_t);
  check_refused(&executor, "executor is of a newer version than the library");
  CHECK(runs == 0);
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "executor is null", occlude_scene_update_by(scene, NULL));
  executor.size = sizeof executor;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "scene is null", occlude_scene_update_by(NULL, &executor));
}

int main(void) {
  run_test(results_are_the_same);
  run_test(meshes);
  run_test(regions);
  run_test(refusals);
  return end_of_test();
}
