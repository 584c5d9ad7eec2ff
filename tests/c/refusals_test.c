// SPDX-License-Identifier: MIT
// What is refused, and how: nothing crashes, and nothing is changed.
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"

static void null_pointers(void) {
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  const occlude_matrix_camera matrix = OCCLUDE_MATRIX_CAMERA_INIT;
  occlude_fate fate = {OCCLUDE_DRAWN, 0, 0, NULL};
  const occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  const occlude_boxes boxes = boxes_of(&kBehind, 1);
  const occlude_placement placement = OCCLUDE_PLACEMENT_INIT;
  occlude_mesh* made = NULL;
  occlude_object object = OCCLUDE_NONE;
  occlude_occluder occluder = OCCLUDE_NONE;
  occlude_box box;
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  occlude_visibility visibility = OCCLUDE_VISIBLE;

  CHECK_REFUSED(refused, "scene is null", occlude_scene_create(NULL));
  CHECK_REFUSED(refused, "view is null", occlude_view_create(NULL));
  CHECK_REFUSED(refused, "mesh is null", occlude_mesh_create(&data, NULL));
  CHECK_REFUSED(refused, "data is null", occlude_mesh_create(NULL, &made));
  CHECK_REFUSED(refused, "mesh is null", occlude_mesh_box(NULL, &box));
  CHECK_REFUSED(refused, "box is null", occlude_mesh_box(wall, NULL));
  occlude_simplified* simplified = NULL;
  occlude_occluders occluders = OCCLUDE_OCCLUDERS_INIT;
  CHECK_REFUSED(refused, "simplified is null", occlude_simplified_create(&data, NULL, NULL));
  CHECK_REFUSED(refused, "data is null", occlude_simplified_create(NULL, NULL, &simplified));
  CHECK_REFUSED(refused, "simplified is null", occlude_simplified_occluders(NULL, &occluders));
  CHECK_OK(occlude_simplified_create(&data, NULL, &simplified));
  CHECK_REFUSED(refused, "occluders is null", occlude_simplified_occluders(simplified, NULL));
  occlude_simplified_destroy(simplified);
  occlude_simplified_destroy(NULL);
  occlude_mesh_destroy(NULL);
  occlude_scene_destroy(NULL);
  occlude_view_destroy(NULL);

  CHECK_REFUSED(refused, "scene is null", occlude_scene_add_object(NULL, &kBehind, NULL, &object));
  CHECK_REFUSED(refused, "box is null", occlude_scene_add_object(scene, NULL, NULL, &object));
  CHECK_REFUSED(refused, "object is null", occlude_scene_add_object(scene, &kBehind, NULL, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_add_objects(NULL, &boxes, NULL, &object));
  CHECK_REFUSED(refused, "boxes is null", occlude_scene_add_objects(scene, NULL, NULL, &object));
  CHECK_REFUSED(refused, "objects is null", occlude_scene_add_objects(scene, &boxes, NULL, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_remove_object(NULL, object));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_remove_objects(NULL, &object, 1));
  CHECK_REFUSED(refused, "objects is null", occlude_scene_remove_objects(scene, NULL, 1));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_move_object(NULL, object, &kBehind));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_move_objects(NULL, &object, &boxes));
  CHECK_REFUSED(refused, "boxes is null", occlude_scene_move_objects(scene, &object, NULL));
  CHECK_REFUSED(refused, "objects is null", occlude_scene_move_objects(scene, NULL, &boxes));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_enable_object(NULL, object, 1));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_mask_object(NULL, object, 1));
  CHECK(!occlude_scene_has_object(NULL, object) && !occlude_scene_has_occluder(NULL, occluder));

  CHECK_REFUSED(refused, "scene is null", occlude_scene_add_occluder(NULL, wall, NULL, NULL, &occluder));
  CHECK_REFUSED(refused, "mesh is null", occlude_scene_add_occluder(scene, NULL, NULL, NULL, &occluder));
  CHECK_REFUSED(refused, "occluder is null", occlude_scene_add_occluder(scene, wall, NULL, NULL, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_add_occluders(NULL, wall, &placement, 1, NULL, &occluder));
  CHECK_REFUSED(refused, "mesh is null", occlude_scene_add_occluders(scene, NULL, &placement, 1, NULL, &occluder));
  CHECK_REFUSED(refused, "placements is null", occlude_scene_add_occluders(scene, wall, NULL, 1, NULL, &occluder));
  CHECK_REFUSED(refused, "occluders is null", occlude_scene_add_occluders(scene, wall, &placement, 1, NULL, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_remove_occluder(NULL, occluder));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_move_occluder(NULL, occluder, &placement));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_replace_occluder(NULL, occluder, wall));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_enable_occluder(NULL, occluder, 1));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_mask_occluder(NULL, occluder, 1));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_update(NULL));
  CHECK(occlude_scene_objects(NULL) == 0 && occlude_scene_occluders(NULL) == 0 && occlude_scene_object_bytes(NULL) == 0);

  CHECK_REFUSED(refused, "scene is null", occlude_scene_cull(NULL, &matrix, NULL, view));
  CHECK_REFUSED(refused, "camera is null", occlude_scene_cull(scene, NULL, NULL, view));
  CHECK_REFUSED(refused, "view is null", occlude_scene_cull(scene, &matrix, NULL, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_why(NULL, view, &object, 1, &fate));
  CHECK_REFUSED(refused, "view is null", occlude_scene_why(scene, NULL, &object, 1, &fate));
  CHECK_REFUSED(refused, "objects is null", occlude_scene_why(scene, view, NULL, 1, &fate));
  CHECK_REFUSED(refused, "fates is null", occlude_scene_why(scene, view, &object, 1, NULL));
  CHECK_REFUSED(refused, "scene is null", occlude_scene_cull_look_at(NULL, &camera, NULL, view));
  CHECK_REFUSED(refused, "camera is null", occlude_scene_cull_look_at(scene, NULL, NULL, view));
  CHECK_REFUSED(refused, "view is null", occlude_scene_cull_look_at(scene, &camera, NULL, NULL));
  CHECK_REFUSED(refused, "view is null", occlude_view_frame(NULL, &frame));
  CHECK_REFUSED(refused, "frame is null", occlude_view_frame(view, NULL));
  CHECK_REFUSED(refused, "view is null", occlude_view_statistics(NULL, &statistics));
  CHECK_REFUSED(refused, "statistics is null", occlude_view_statistics(view, NULL));
  CHECK_REFUSED(refused, "view is null", occlude_view_visibility(NULL, &boxes, &visibility));
  CHECK_REFUSED(refused, "boxes is null", occlude_view_visibility(view, NULL, &visibility));
  CHECK_REFUSED(refused, "visibilities is null", occlude_view_visibility(view, &boxes, NULL));
}

/// All functions refuse an id of an object, or of an occluder, with this reason.
static void refused_object(occlude_object id, const char* reason) {
  const occlude_boxes boxes = boxes_of(&kBehind, 1);
  occlude_occluder_options options = OCCLUDE_OCCLUDER_OPTIONS_INIT;
  options.object = id;
  const occlude_placement placement = OCCLUDE_PLACEMENT_INIT;
  occlude_occluder occluder = OCCLUDE_NONE;
  occlude_fate fate;
  char text[200];
  CHECK(!occlude_scene_has_object(scene, id));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_remove_object(scene, id));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_move_object(scene, id, &kBehind));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_enable_object(scene, id, 1));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_mask_object(scene, id, 1));
  snprintf(text, sizeof text, "object 0: %s", reason);
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, text, occlude_scene_remove_objects(scene, &id, 1));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, text, occlude_scene_move_objects(scene, &id, &boxes));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, text, occlude_scene_why(scene, view, &id, 1, &fate));
  if (id.number == 0) return;  // an occluder needs no object
  snprintf(text, sizeof text, "object of the options: %s", reason);
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, text, occlude_scene_add_occluder(scene, wall, NULL, &options, &occluder));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, text, occlude_scene_add_occluders(scene, wall, &placement, 1, &options, &occluder));
}

static void refused_occluder(occlude_occluder id, const char* reason) {
  CHECK(!occlude_scene_has_occluder(scene, id));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_remove_occluder(scene, id));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_move_occluder(scene, id, NULL));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_replace_occluder(scene, id, wall));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_enable_occluder(scene, id, 1));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, reason, occlude_scene_mask_occluder(scene, id, 1));
}

/// Ids of the other kind and of another scene, which have the same slots as those of this scene.
static void ids_of_other_things(void) {
  occlude_object object = OCCLUDE_NONE, there = OCCLUDE_NONE;
  occlude_occluder occluder = OCCLUDE_NONE, standing = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &object));
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  occlude_scene* other = NULL;
  CHECK_OK(occlude_scene_create(&other));
  CHECK_OK(occlude_scene_add_object(other, &kBehind, NULL, &there));
  CHECK_OK(occlude_scene_add_occluder(other, wall, NULL, NULL, &standing));
  CHECK(OCCLUDE_SLOT(object) == 0 && OCCLUDE_SLOT(occluder) == 0 && OCCLUDE_SLOT(there) == 0 && OCCLUDE_SLOT(standing) == 0);

  // The compiler refuses them, unless their numbers are exchanged.
  const occlude_object an_occluder = {occluder.number};
  const occlude_occluder an_object = {object.number};
  refused_object(an_occluder, "the id is that of an occluder, not of an object");
  refused_occluder(an_object, "the id is that of an object, not of an occluder");
  refused_object(there, "the id is that of another scene");
  refused_occluder(standing, "the id is that of another scene");
  occlude_scene_destroy(other);
  refused_object(there, "the id is that of another scene");

  // Nor does a later scene take the ids of one that is gone.
  occlude_scene* later = NULL;
  CHECK_OK(occlude_scene_create(&later));
  occlude_object first = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(later, &kBehind, NULL, &first));
  CHECK(first.number != there.number && !occlude_scene_has_object(later, there));
  occlude_scene_destroy(later);
  cull(scene, view);
  CHECK(occlude_scene_objects(scene) == 1 && occlude_scene_occluders(scene) == 1 && !draws(view, object));
}

static void ids_of_nothing(void) {
  cull(scene, view);
  occlude_object gone = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &gone));
  CHECK_OK(occlude_scene_remove_object(scene, gone));
  const occlude_object none = OCCLUDE_NONE, strange = {UINT64_MAX}, beyond = {gone.number + 1000};
  const occlude_occluder no_occluder = OCCLUDE_NONE;
  refused_object(none, "the id is none");
  refused_object(gone, "the scene has no such object");
  refused_object(beyond, "the scene has no such object");
  refused_object(strange, "the id is that of an occluder, not of an object");
  refused_occluder(no_occluder, "the id is none");
  occlude_occluder occluder = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "mesh is null", occlude_scene_replace_occluder(scene, occluder, NULL));
  CHECK_OK(occlude_scene_remove_occluder(scene, occluder));
  refused_occluder(occluder, "the scene has no such occluder");

  // In arrays: nothing is changed.
  occlude_object living = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &living));
  const occlude_object both[] = {living, gone};
  const occlude_box boxes[] = {kBehind, kBefore};
  const occlude_boxes array = boxes_of(boxes, 2);
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, "object 1: the scene has no such object", occlude_scene_remove_objects(scene, both, 2));
  CHECK(occlude_scene_has_object(scene, living));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, "object 1: the scene has no such object",
                occlude_scene_move_objects(scene, both, &array));
}

static void numbers(void) {
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  const size_t before = occlude_scene_objects(scene);
  occlude_object ids[2] = {{7}, {7}};
  occlude_box boxes[] = {kBehind, kBehind};
  occlude_boxes array = boxes_of(boxes, 2);
  boxes[1].max[2] = NAN;
  CHECK_REFUSED(refused, "box 1: box has a number that is NaN", occlude_scene_add_objects(scene, &array, NULL, ids));
  CHECK_REFUSED(refused, "box has a number that is NaN", occlude_scene_add_object(scene, &boxes[1], NULL, ids));
  boxes[1].max[2] = -2;
  CHECK_REFUSED(refused, "box 1: box has min > max", occlude_scene_add_objects(scene, &array, NULL, ids));
  CHECK_REFUSED(refused, "box has min > max", occlude_scene_add_object(scene, &boxes[1], NULL, ids));
  CHECK(ids[0].number == 7 && occlude_scene_objects(scene) == before);
  const float oriented[] = {0, 0, 0, 1, 0, 0, 0, NAN, 0, 0, 0, 1};
  const occlude_boxes turned = {oriented, 1, 0, OCCLUDE_FLOAT, OCCLUDE_ORIENTED};
  CHECK_REFUSED(refused, "box 0: box has a number that is NaN", occlude_scene_add_objects(scene, &turned, NULL, ids));

  // Moves likewise. Boxes without end are legal.
  const occlude_box everywhere = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  CHECK_OK(occlude_scene_add_object(scene, &everywhere, NULL, &ids[0]));
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &ids[1]));
  CHECK_REFUSED(refused, "box 1: box has min > max", occlude_scene_move_objects(scene, ids, &array));
  CHECK_REFUSED(refused, "box has min > max", occlude_scene_move_object(scene, ids[0], &boxes[1]));
  CHECK_REFUSED(refused, "box is null", occlude_scene_move_object(scene, ids[0], NULL));
  cull(scene, view);
  CHECK(draws(view, ids[0]));

  occlude_visibility seen[] = {9, 9};
  CHECK_REFUSED(refused, "box 1: box has min > max", occlude_view_visibility(view, &array, seen));
  CHECK(seen[0] != 9 && seen[1] == 9);

  // Enumerators.
  array.type = 2;
  CHECK_REFUSED(refused, "number type is 2, which is none of its enumerators", occlude_view_visibility(view, &array, seen));
  array.type = OCCLUDE_DOUBLE;
  array.kind = -1;
  CHECK_REFUSED(refused, "kind of boxes is -1, which is none of its enumerators",
                occlude_scene_add_objects(scene, &array, NULL, ids));
  array.kind = OCCLUDE_ALIGNED;
  array.data = NULL;
  CHECK_REFUSED(refused, "data of boxes is null", occlude_view_visibility(view, &array, seen));

  // Cameras. The view keeps its last frame.
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  camera.projection = 5;
  CHECK_REFUSED(refused, "projection is 5, which is none of its enumerators",
                occlude_scene_cull_look_at(scene, &camera, NULL, view));
  camera.projection = OCCLUDE_PERSPECTIVE;
  camera.target[0] = 0;
  CHECK(occlude_scene_cull_look_at(scene, &camera, NULL, view) == refused);
  CHECK(strlen(occlude_last_error()) > 0);
  camera.target[0] = 1;
  camera.near_plane = 0;
  CHECK(occlude_scene_cull_look_at(scene, &camera, NULL, view) == refused);
  camera.near_plane = NAN;
  CHECK(occlude_scene_cull_look_at(scene, &camera, NULL, view) == refused);
  CHECK(draws(view, ids[0]));
}

static int stop_now(void* context) {
  ++*(int*)context;
  return 1;
}

static void meshes(void) {
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  uint32_t indices[] = {0, 1, 2, 3};
  uint32_t sizes[] = {3, 2};
  occlude_mesh* mesh = NULL;
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  CHECK_OK(occlude_mesh_create(&data, &mesh));  // nothing
  CHECK(occlude_mesh_polygons(mesh) == 0);
  occlude_mesh_destroy(mesh);
  mesh = NULL;
  data.vertices.count = 3;
  CHECK_REFUSED(refused, "data of vertices is null", occlude_mesh_create(&data, &mesh));
  data.vertices.data = vertices;
  data.index_count = 4;
  CHECK_REFUSED(refused, "indices is null", occlude_mesh_create(&data, &mesh));
  data.indices = indices;
  CHECK_REFUSED(refused, "triangles: index_count is not a multiple of 3", occlude_mesh_create(&data, &mesh));
  data.polygon_count = 1;
  CHECK_REFUSED(refused, "polygon_sizes is null", occlude_mesh_create(&data, &mesh));
  data.polygon_sizes = sizes;
  CHECK_REFUSED(refused, "the mesh has indices after its last polygon", occlude_mesh_create(&data, &mesh));
  data.polygon_count = 2;
  CHECK_REFUSED(refused, "polygon 1: its corners are not among the indices", occlude_mesh_create(&data, &mesh));
  sizes[1] = 1;
  CHECK_REFUSED(refused, "polygon 1: fewer than 3 corners", occlude_mesh_create(&data, &mesh));
  data.polygon_count = 1;
  data.index_count = 3;
  indices[2] = 3;
  CHECK_REFUSED(refused, "polygon 0: corner 2 is vertex 3 of 3", occlude_mesh_create(&data, &mesh));
  indices[2] = 2;
  vertices[4] = INFINITY;
  CHECK_REFUSED(refused, "vertex 1: number is not finite", occlude_mesh_create(&data, &mesh));
  occlude_simplified* simplified = NULL;
  CHECK_REFUSED(refused, "vertex 1: number is not finite", occlude_simplified_create(&data, NULL, &simplified));
  data.vertices.type = 9;
  CHECK_REFUSED(refused, "number type is 9, which is none of its enumerators", occlude_mesh_create(&data, &mesh));
  data.vertices.type = OCCLUDE_DOUBLE;
  vertices[4] = 0;
  occlude_simplify_options options = OCCLUDE_SIMPLIFY_OPTIONS_INIT;
  options.view_count = 2;
  CHECK_REFUSED(refused, "views is null", occlude_simplified_create(&data, &options, &simplified));
  occlude_look_at_camera views[] = {OCCLUDE_LOOK_AT_CAMERA_INIT, OCCLUDE_LOOK_AT_CAMERA_INIT};
  views[1].near_plane = -1;
  options.views = views;
  CHECK(occlude_simplified_create(&data, &options, &simplified) == refused && strstr(occlude_last_error(), "view 1: "));
  views[1].near_plane = 1;
  views[1].projection = 7;
  CHECK_REFUSED(refused, "projection is 7, which is none of its enumerators",
                occlude_simplified_create(&data, &options, &simplified));
  int asked = 0;
  data.should_stop = stop_now;
  data.context = &asked;
  CHECK_REFUSED(OCCLUDE_STOPPED, "stopped by the caller", occlude_mesh_create(&data, &mesh));
  CHECK(asked > 0 && mesh == NULL);
  asked = 0;
  CHECK_REFUSED(OCCLUDE_STOPPED, "stopped by the caller", occlude_simplified_create(&data, NULL, &simplified));
  CHECK(asked > 0 && simplified == NULL);
}

static void rounding(void) {
#if defined(FE_UPWARD) && !defined(__wasm__)  // which has no other mode, and does not say so
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  const occlude_boxes boxes = boxes_of(&kBehind, 1);
  occlude_visibility visibility;
  const char* text = "processor does not round to nearest";
  fesetround(FE_UPWARD);
  CHECK_REFUSED(OCCLUDE_ROUNDING_MODE, text, occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK_REFUSED(OCCLUDE_ROUNDING_MODE, text, occlude_view_visibility(view, &boxes, &visibility));
  fesetround(FE_TONEAREST);
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
#endif
}

static void statuses(void) {
  for (occlude_status status = OCCLUDE_OK; status <= OCCLUDE_FAILED; ++status) {
    CHECK(strcmp(occlude_status_text(status), "unknown status") != 0);
  }
  CHECK(strcmp(occlude_status_text(-1), "unknown status") == 0);
}

int main(void) {
  CHECK(strcmp(occlude_last_error(), "") == 0);
  run_test(null_pointers);
  run_test(ids_of_nothing);
  run_test(ids_of_other_things);
  run_test(numbers);
  run_test(meshes);
  run_test(rounding);
  run_test(statuses);
  return end_of_test();
}
