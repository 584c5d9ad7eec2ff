// SPDX-License-Identifier: MIT
// What scenes do, by the C interface.
#include <math.h>

#include "check.h"

static void objects_come_and_go(void) {
  occlude_scene* scene = NULL;
  occlude_view* view = NULL;
  CHECK_OK(occlude_scene_create(&scene));
  CHECK_OK(occlude_view_create(&view));
  occlude_mesh* wall = make_wall();
  occlude_occluder occluder = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  occlude_mesh_destroy(wall);  // the occluder keeps it

  const occlude_box boxes[] = {kBehind, kBefore, kBeside, kAway};
  const occlude_boxes array = {boxes, 4, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
  occlude_object ids[4];
  CHECK_OK(occlude_scene_add_objects(scene, &array, NULL, ids));
  CHECK(occlude_scene_objects(scene) == 4 && occlude_scene_occluders(scene) == 1);
  CHECK(occlude_scene_object_bytes(scene) > 0);
  for (uint32_t i = 0; i < 4; ++i) CHECK(ids[i] != OCCLUDE_NONE && OCCLUDE_SLOT(ids[i]) == i);

  CHECK(!draws(view, ids[1]));  // before the first frame
  cull(scene, view);
  CHECK(!draws(view, ids[0]) && draws(view, ids[1]) && draws(view, ids[2]) && !draws(view, ids[3]));
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(statistics.drawn == 2 && statistics.hidden == 1 && statistics.out_of_view == 1 && statistics.too_small == 0);
  CHECK(statistics.occluders == 1 && statistics.cover_triangles == 2 && statistics.cover_groups == 1);
  CHECK(statistics.nodes_visited > 0 && statistics.view_tests > 0 && statistics.cover_tests > 0);
  CHECK(statistics.cover_groups_left == 0);

  // A disabled wall hides nothing; nor does one in another layer, one that was moved away, or one that is gone.
  CHECK_OK(occlude_scene_enable_occluder(scene, occluder, 0));
  cull(scene, view);
  CHECK(draws(view, ids[0]));
  CHECK_OK(occlude_scene_enable_occluder(scene, occluder, 1));
  CHECK_OK(occlude_scene_mask_occluder(scene, occluder, 0));
  cull(scene, view);
  CHECK(draws(view, ids[0]));
  CHECK_OK(occlude_scene_mask_occluder(scene, occluder, 2));
  cull(scene, view);
  CHECK(!draws(view, ids[0]));
  occlude_placement up = OCCLUDE_PLACEMENT_INIT;
  up.origin[2] = 100;
  CHECK_OK(occlude_scene_move_occluder(scene, occluder, &up));
  cull(scene, view);
  CHECK(draws(view, ids[0]));
  CHECK_OK(occlude_scene_move_occluder(scene, occluder, NULL));
  cull(scene, view);
  CHECK(!draws(view, ids[0]));
  CHECK(occlude_scene_has_occluder(scene, occluder));
  CHECK_OK(occlude_scene_remove_occluder(scene, occluder));
  CHECK(!occlude_scene_has_occluder(scene, occluder));
  CHECK_REFUSED(OCCLUDE_UNKNOWN_ID, "the scene has no such occluder", occlude_scene_remove_occluder(scene, occluder));
  cull(scene, view);
  CHECK(draws(view, ids[0]));

  // Objects likewise.
  CHECK_OK(occlude_scene_enable_object(scene, ids[0], 0));
  CHECK_OK(occlude_scene_mask_object(scene, ids[1], 0));
  CHECK_OK(occlude_scene_move_object(scene, ids[2], &kAway));
  CHECK_OK(occlude_scene_move_object(scene, ids[3], &kBeside));
  cull(scene, view);
  CHECK(!draws(view, ids[0]) && !draws(view, ids[1]) && !draws(view, ids[2]) && draws(view, ids[3]));
  CHECK_OK(occlude_scene_enable_object(scene, ids[0], 7));
  CHECK_OK(occlude_scene_mask_object(scene, ids[1], 1));
  CHECK_OK(occlude_scene_move_objects(scene, ids, &array));
  cull(scene, view);
  CHECK(draws(view, ids[0]) && draws(view, ids[1]) && draws(view, ids[2]) && !draws(view, ids[3]));

  CHECK_OK(occlude_scene_remove_object(scene, ids[0]));
  CHECK(!occlude_scene_has_object(scene, ids[0]) && occlude_scene_has_object(scene, ids[1]));
  const occlude_object twice[] = {ids[1], ids[2], ids[1]};
  CHECK_OK(occlude_scene_remove_objects(scene, twice, 3));
  CHECK(occlude_scene_objects(scene) == 1);
  occlude_object next = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, NULL, &next));
  CHECK(OCCLUDE_SLOT(next) < 3);  // that of one of the three
  for (int i = 0; i < 4; ++i) CHECK(next != ids[i]);
  cull(scene, view);
  CHECK(draws(view, next) && !draws(view, ids[1]));
  occlude_scene_destroy(scene);
  CHECK(draws(view, next));  // a view outlives its scenes
  occlude_view_destroy(view);
}

static void options_of_objects_and_occluders(void) {
  occlude_scene* scene = NULL;
  occlude_view* view = NULL;
  CHECK_OK(occlude_scene_create(&scene));
  CHECK_OK(occlude_view_create(&view));
  occlude_mesh* wall = make_wall();

  occlude_object_options options = OCCLUDE_OBJECT_OPTIONS_INIT;
  options.is_always_drawn = 1;
  occlude_object sky, bus, layered, behind;
  CHECK_OK(occlude_scene_add_object(scene, &kAway, &options, &sky));
  options.is_always_drawn = 0;
  options.moves = 1;
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, &options, &bus));
  options.moves = 0;
  options.mask = 4;
  CHECK_OK(occlude_scene_add_object(scene, &kBefore, &options, &layered));
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &behind));

  // The wall hides only while the bus is there.
  occlude_occluder_options wall_options = OCCLUDE_OCCLUDER_OPTIONS_INIT;
  wall_options.object = bus;
  wall_options.moves = 1;
  occlude_occluder body;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, &wall_options, &body));
  cull(scene, view);
  CHECK(draws(view, sky) && draws(view, bus) && draws(view, layered) && !draws(view, behind));
  CHECK_OK(occlude_scene_enable_object(scene, bus, 0));
  cull(scene, view);
  CHECK(draws(view, behind));
  CHECK_OK(occlude_scene_enable_object(scene, bus, 1));

  // A frame in one layer; sizes and distances; from front to back.
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options frame_options = OCCLUDE_CULL_OPTIONS_INIT;
  frame_options.mask = 8;
  frame_options.is_front_to_back = 1;
  frame_options.cover_width = 256;
  frame_options.cover_height = 128;
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &frame_options, view));
  CHECK(draws(view, sky) && draws(view, bus) && !draws(view, layered) && !draws(view, behind));
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_view_frame(view, &frame));
  CHECK(frame.count == 2 && frame.objects[0] == sky && frame.objects[1] == bus);
  CHECK(isinf(frame.sizes[0]) && isinf(frame.distances[0]) && frame.distances[0] < 0);
  CHECK(fabs((double)frame.distances[1] - 25) < 1);
  CHECK(frame.sizes[1] > 0.3F && frame.sizes[1] < 0.5F);  // 2 of 5.8 at a distance of 5
  CHECK(frame.plane_count == 5);
  const occlude_half_space* plane = &frame.planes[4];  // near
  CHECK(fabs(plane->normal[0] * 0.1 + plane->offset) < 1e-3 && plane->normal[0] > 0);
  frame_options.least_size = 0.6F;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &frame_options, view));
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(draws(view, sky) && !draws(view, bus) && statistics.drawn == 1 && statistics.too_small == 2);

  // Limits of the picture: without triangles nothing is hidden. Nor is it with a margin that is not a number.
  frame_options.least_size = 0;
  frame_options.cover_ms = 1e-9;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &frame_options, view));
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(draws(view, behind) && statistics.cover_triangles == 0);
  frame_options.cover_ms = 0;
  frame_options.cover_triangles = UINT64_MAX;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &frame_options, view));
  CHECK(!draws(view, behind));
  frame_options.margin = NAN;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &frame_options, view));
  CHECK(draws(view, behind));

  // One-sided: the wall of make_wall() turns its back to the eye.
  CHECK_OK(occlude_scene_remove_occluder(scene, body));
  wall_options.is_one_sided = 1;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, &wall_options, &body));
  cull(scene, view);
  CHECK(draws(view, behind));

  // Another mesh: a pentagon that looks to the eye, with a corner in the middle of an edge.
  const double vertices[] = {10, -5, -5, 10, -5, 5, 10, 5, 5, 10, 5, 0, 10, 5, -5};
  const uint32_t indices[] = {0, 1, 2, 3, 4}, sizes[] = {5};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = vertices;
  data.vertices.count = 5;
  data.indices = indices;
  data.index_count = 5;
  data.polygon_sizes = sizes;
  data.polygon_count = 1;
  occlude_mesh* pentagon = NULL;
  CHECK_OK(occlude_mesh_create(&data, &pentagon));
  CHECK(occlude_mesh_polygons(pentagon) == 1 && occlude_mesh_polygons(wall) == 2 && occlude_mesh_polygons(NULL) == 0);
  occlude_box box;
  CHECK_OK(occlude_mesh_box(pentagon, &box));
  CHECK(box.min[0] == 10 && box.min[1] == -5 && box.max[0] == 10 && box.max[2] == 5);
  CHECK_OK(occlude_scene_replace_occluder(scene, body, pentagon));
  cull(scene, view);
  CHECK(!draws(view, behind));
  occlude_mesh_destroy(pentagon);
  occlude_mesh_destroy(wall);
  occlude_view_destroy(view);
  occlude_scene_destroy(scene);
}

static void occluders_in_arrays(void) {
  occlude_scene* scene = NULL;
  occlude_view* view = NULL;
  CHECK_OK(occlude_scene_create(&scene));
  CHECK_OK(occlude_view_create(&view));
  occlude_mesh* wall = make_wall();
  // A wall and its mirror image beside it.
  occlude_placement placements[] = {OCCLUDE_PLACEMENT_INIT, OCCLUDE_PLACEMENT_INIT};
  placements[1].y[1] = -1;
  placements[1].origin[1] = 10;
  occlude_occluder ids[2];
  CHECK_OK(occlude_scene_add_occluders(scene, wall, placements, 2, NULL, ids));
  CHECK(ids[0] != ids[1] && occlude_scene_occluders(scene) == 2);
  occlude_object behind, beside;
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &behind));
  CHECK_OK(occlude_scene_add_object(scene, &kBeside, NULL, &beside));
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  camera.aspect = 3;
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(!draws(view, behind));
  occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
  CHECK_OK(occlude_view_statistics(view, &statistics));
  CHECK(statistics.occluders == 2);

  // Parallel rays, and a far plane.
  camera.projection = OCCLUDE_ORTHOGRAPHIC;
  camera.height = 30;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(!draws(view, behind) && !draws(view, beside));
  CHECK_OK(occlude_scene_remove_occluder(scene, ids[1]));
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(draws(view, beside));
  camera.far_plane = 15;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  CHECK(!draws(view, beside));

  // All or none.
  placements[1].x[0] = NAN;
  ids[0] = 123;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "placement 1: an occluder's placement is not finite, or takes it beyond 2^100",
                occlude_scene_add_occluders(scene, wall, placements, 2, NULL, ids));
  CHECK(ids[0] == OCCLUDE_NONE && ids[1] == OCCLUDE_NONE && occlude_scene_occluders(scene) == 1);
  CHECK_OK(occlude_scene_add_occluders(scene, wall, NULL, 0, NULL, NULL));
  occlude_mesh_destroy(wall);
  occlude_view_destroy(view);
  occlude_scene_destroy(scene);
}

/// Boxes in records of the caller, in floats or doubles, of either kind and at odd places of memory.
static void arrays_with_strides(void) {
  occlude_scene* scene = NULL;
  occlude_view* view = NULL;
  CHECK_OK(occlude_scene_create(&scene));
  CHECK_OK(occlude_view_create(&view));
  occlude_mesh* wall = make_wall();
  occlude_occluder occluder;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  occlude_mesh_destroy(wall);

  struct record {
    int name;
    float box[6];
    char text[5];
  } records[] = {{1, {20, -1, -1, 21, 1, 1}, "one"}, {2, {5, -1, -1, 6, 1, 1}, "two"}, {3, {20, 8, -1, 21, 10, 1}, "3"}};
  occlude_boxes boxes = {records[0].box, 3, sizeof records[0], OCCLUDE_FLOAT, OCCLUDE_ALIGNED};
  occlude_object ids[3];
  CHECK_OK(occlude_scene_add_objects(scene, &boxes, NULL, ids));
  cull(scene, view);
  CHECK(!draws(view, ids[0]) && draws(view, ids[1]) && draws(view, ids[2]));
  occlude_visibility seen[4];
  CHECK_OK(occlude_view_visibility(view, &boxes, seen));
  CHECK(seen[0] == OCCLUDE_OCCLUDED && seen[1] == OCCLUDE_VISIBLE && seen[2] == OCCLUDE_VISIBLE);

  // One after another in doubles, not aligned.
  const occlude_box away[] = {kAway, kBehind, kBefore};
  unsigned char bytes[sizeof away + 1];
  memcpy(bytes + 1, away, sizeof away);
  const occlude_boxes odd = {bytes + 1, 3, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
  CHECK_OK(occlude_view_visibility(view, &odd, seen));
  CHECK(seen[0] == OCCLUDE_OUT_OF_VIEW && seen[1] == OCCLUDE_OCCLUDED && seen[2] == OCCLUDE_VISIBLE);
  CHECK_OK(occlude_scene_move_objects(scene, ids, &odd));
  cull(scene, view);
  CHECK(!draws(view, ids[0]) && !draws(view, ids[1]) && draws(view, ids[2]));

  // Oriented boxes. A diagonal one looks past the edge of the wall with its box only.
  const occlude_oriented_box oriented[] = {{{20, 0, 0}, {{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}},
                                           {{20, 11.5, 0}, {{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}};
  const occlude_boxes turned = {oriented, 2, 0, OCCLUDE_DOUBLE, OCCLUDE_ORIENTED};
  CHECK_OK(occlude_view_visibility(view, &turned, seen));
  CHECK(seen[0] == OCCLUDE_OCCLUDED && seen[1] == OCCLUDE_VISIBLE);
  const float in_floats[] = {20, 0, 0, 1, 1, 0, -1, 1, 0, 0, 0, 1};
  const occlude_boxes single = {in_floats, 1, 0, OCCLUDE_FLOAT, OCCLUDE_ORIENTED};
  CHECK_OK(occlude_view_visibility(view, &single, seen));
  CHECK(seen[0] == OCCLUDE_OCCLUDED);
  CHECK_OK(occlude_scene_add_objects(scene, &turned, NULL, ids));
  cull(scene, view);
  CHECK(!draws(view, ids[0]) && draws(view, ids[1]));
  const occlude_boxes none = {NULL, 0, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
  CHECK_OK(occlude_scene_add_objects(scene, &none, NULL, NULL));
  CHECK_OK(occlude_view_visibility(view, &none, NULL));
  CHECK_OK(occlude_scene_remove_objects(scene, NULL, 0));
  occlude_view_destroy(view);
  occlude_scene_destroy(scene);

  // Vertices in records.
  const double vertices[] = {10, -5, -5, 77, 10, 5, -5, 77, 10, 5, 5, 77};
  const uint32_t indices[] = {0, 1, 2};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = vertices;
  data.vertices.count = 3;
  data.vertices.stride = 4 * sizeof(double);
  data.indices = indices;
  data.index_count = 3;
  occlude_mesh* mesh = NULL;
  CHECK_OK(occlude_mesh_create(&data, &mesh));
  occlude_box box;
  CHECK_OK(occlude_mesh_box(mesh, &box));
  CHECK(box.min[0] == 10 && box.max[0] == 10 && box.min[1] == -5 && box.max[1] == 5 && box.max[2] == 5);
  occlude_mesh_destroy(mesh);
}

/// Whether the frame lists what is nearer first.
static int is_front_to_back(const occlude_scene* scene, int32_t wanted) {
  occlude_view* view = NULL;
  CHECK_OK(occlude_view_create(&view));
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.is_front_to_back = wanted;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &options, view));
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_view_frame(view, &frame));
  CHECK(frame.count == 100);
  int is_sorted = 1;
  for (size_t i = 1; i < frame.count; ++i) is_sorted = is_sorted && frame.distances[i - 1] <= frame.distances[i];
  occlude_view_destroy(view);
  return is_sorted;
}

static void order(void) {
  occlude_scene* scene = NULL;
  CHECK_OK(occlude_scene_create(&scene));
  for (int i = 0; i < 100; ++i) {
    const double y = i * 37 % 100 - 50;
    const occlude_box box = {{100, y, 0}, {101, y + 0.5, 1}};
    occlude_object object = OCCLUDE_NONE;
    CHECK_OK(occlude_scene_add_object(scene, &box, NULL, &object));
  }
  CHECK_OK(occlude_scene_update(scene));
  CHECK(is_front_to_back(scene, 1) && !is_front_to_back(scene, 0));
  occlude_scene_destroy(scene);
}

int main(void) {
  CHECK(occlude_version() == OCCLUDE_VERSION);
  objects_come_and_go();
  options_of_objects_and_occluders();
  occluders_in_arrays();
  arrays_with_strides();
  order();
  return end_of_test();
}
