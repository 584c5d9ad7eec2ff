// SPDX-License-Identifier: MIT
// Does by the C interface what replay.mjs does by the package, and writes the same numbers. Usage: js_replay STEPS ANSWERS
// Both files are doubles: of steps, a number of the step, how many numbers follow, and these.
#include <occlude.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { most = 1 << 20 };

static occlude_scene* scene;
static occlude_view *view, *region;
static occlude_mesh* meshes[most];
static occlude_object objects[most];
static occlude_occluder occluders[most];
static size_t mesh_count, object_count, occluder_count;
static double milliseconds;
static size_t frames;

static void check(occlude_status status) {
  if (status == OCCLUDE_OK) return;
  fprintf(stderr, "%s\n", occlude_last_error());
  exit(1);
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e3 * (double)time.tv_sec + 1e-6 * (double)time.tv_nsec;
}

static occlude_placement placement_of(const double* p) {
  occlude_placement placement;
  memcpy(&placement, p, sizeof placement);
  return placement;
}

static occlude_look_at_camera camera_of(const double* p) {
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  memcpy(camera.eye, p, sizeof camera.eye);
  memcpy(camera.target, p + 3, sizeof camera.target);
  return camera;
}

static void put(double number, FILE* out) { fwrite(&number, sizeof number, 1, out); }

static void put_frame(FILE* out) {
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  check(occlude_view_frame(view, &frame));
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  check(occlude_view_statistics(view, &statistics));
  put((double)frame.count, out);
  for (size_t i = 0; i < frame.count; ++i) {
    put((double)OCCLUDE_SLOT(frame.objects[i]), out);
    put((double)frame.sizes[i], out);
    put((double)frame.distances[i], out);
  }
  put((double)statistics.hidden, out);
  put((double)statistics.out_of_view, out);
  put((double)statistics.cover_triangles, out);
}

static void step(int what, size_t count, const double* p, FILE* out) {
  const double start = now();
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.is_adaptive = 0;
  switch (what) {
    case 0: {  // boxes of objects: how, and the boxes
      occlude_object_options how = OCCLUDE_OBJECT_OPTIONS_INIT;
      how.moves = (int)p[0];
      how.mask = (uint32_t)p[1];
      const occlude_boxes boxes = {p + 2, (count - 2) / 6, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
      check(occlude_scene_add_objects(scene, &boxes, &how, objects + object_count));
      object_count += boxes.count;
      break;
    }
    case 1: {  // an object to its box
      const occlude_boxes box = {p + 1, 1, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
      check(occlude_scene_move_objects(scene, objects + (size_t)p[0], &box));
      break;
    }
    case 2:
      check(occlude_scene_remove_object(scene, objects[(size_t)p[0]]));
      break;
    case 3:
      check(occlude_scene_enable_object(scene, objects[(size_t)p[0]], (int)p[1]));
      break;
    case 4:
      check(occlude_scene_mask_object(scene, objects[(size_t)p[0]], (uint32_t)p[1]));
      break;
    case 5: {  // triangles: three corners each
      occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
      data.vertices = (occlude_points){p, count / 3, 0, OCCLUDE_DOUBLE};
      uint32_t* indices = malloc(count / 3 * sizeof *indices);
      for (uint32_t i = 0; i < count / 3; ++i) indices[i] = i;
      data.indices = indices;
      data.index_count = count / 3;
      check(occlude_mesh_create(&data, meshes + mesh_count++));
      free(indices);
      break;
    }
    case 6: {  // an occluder: its mesh, its placement, how
      const occlude_placement placement = placement_of(p + 1);
      occlude_occluder_options how = OCCLUDE_OCCLUDER_OPTIONS_INIT;
      how.moves = (int)p[13];
      how.is_one_sided = (int)p[14];
      how.mask = (uint32_t)p[15];
      how.weld = (uint32_t)p[16];
      if (p[17] >= 0) how.object = objects[(size_t)p[17]];
      check(occlude_scene_add_occluder(scene, meshes[(size_t)p[0]], &placement, &how, occluders + occluder_count++));
      break;
    }
    case 7: {
      const occlude_placement placement = placement_of(p + 1);
      check(occlude_scene_move_occluder(scene, occluders[(size_t)p[0]], &placement));
      break;
    }
    case 8:
      check(occlude_scene_remove_occluder(scene, occluders[(size_t)p[0]]));
      break;
    case 9:
      check(occlude_scene_enable_occluder(scene, occluders[(size_t)p[0]], (int)p[1]));
      break;
    case 10:
      check(occlude_scene_replace_occluder(scene, occluders[(size_t)p[0]], meshes[(size_t)p[1]]));
      break;
    case 11:
      check(occlude_scene_update(scene));
      break;
    case 12: {  // a frame: eye, target, mask, least size, margin
      const occlude_look_at_camera camera = camera_of(p);
      options.mask = (uint32_t)p[6];
      options.least_size = (float)p[7];
      options.margin = p[8];
      check(occlude_scene_cull_look_at(scene, &camera, &options, view));
      ++frames;
      milliseconds += now() - start;
      put_frame(out);
      break;
    }
    case 13: {  // a frame ahead, and one that is held against it, if it holds: eye, target, velocity
      occlude_look_at_camera camera = camera_of(p), ahead = camera;
      check(occlude_ahead_look_at(&camera, p + 6, 1, NULL, &ahead));
      options.is_to_be_held = 1;
      check(occlude_scene_cull_look_at(scene, &ahead, &options, region));
      options.is_to_be_held = 0;
      int32_t holds = 0;
      check(occlude_scene_holds_look_at(scene, region, &camera, &options, &holds));
      put((double)holds, out);
      if (holds == 0) break;
      check(occlude_scene_cull_held_look_at(scene, &camera, &options, region, view));
      put_frame(out);
      break;
    }
    default:
      fprintf(stderr, "no step %d\n", what);
      exit(1);
  }
}

int main(int argc, char** argv) {
  FILE* steps = argc == 3 ? fopen(argv[1], "rb") : NULL;
  FILE* answers = argc == 3 ? fopen(argv[2], "wb") : NULL;
  if (steps == NULL || answers == NULL) return 2;
  check(occlude_scene_create(&scene));
  check(occlude_view_create(&view));
  check(occlude_view_create(&region));
  double head[2];
  while (fread(head, sizeof *head, 2, steps) == 2) {
    const size_t count = (size_t)head[1];
    double* numbers = malloc((count + 1) * sizeof *numbers);
    if (fread(numbers, sizeof *numbers, count, steps) != count) return 2;
    step((int)head[0], count, numbers, answers);
    free(numbers);
  }
  fclose(steps);
  if (fclose(answers) != 0) return 2;
  printf("%.4f\n", milliseconds / (double)frames);
}
