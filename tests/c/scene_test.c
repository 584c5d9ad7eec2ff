// SPDX-License-Identifier: MIT
// What scenes do, by the C interface.
#include <math.h>

#include "check.h"

static void objects_come_and_go(void) {
  occlude_occluder occluder = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  occlude_mesh_destroy(wall);  // the occluder keeps it
  wall = NULL;

  const occlude_box boxes[] = {kBehind, kBefore, kBeside, kAway};
  const occlude_boxes array = {boxes, 4, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
  occlude_object ids[4];
  CHECK_OK(occlude_scene_add_objects(scene, &array, NULL, ids));
  CHECK(occlude_scene_objects(scene) == 4 && occlude_scene_occluders(scene) == 1);
  CHECK(occlude_scene_object_bytes(scene) > 0);
  for (uint32_t i = 0; i < 4; ++i) CHECK(ids[i].number != 0 && OCCLUDE_SLOT(ids[i]) == i);

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
  for (int is_hidden = 0; is_hidden < 2; ++is_hidden) {
    occlude_view* first = NULL;
    CHECK_OK(occlude_view_create(&first));
    CHECK_OK(occlude_scene_enable_object(scene, ids[0], is_hidden));
    cull(scene, first);
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    CHECK_OK(occlude_view_frame(first, &frame));
    CHECK(is_hidden ? frame.idle_occluder_count == 0
                    : frame.idle_occluder_count == 1 && frame.idle_occluders[0].number == occluder.number);
    occlude_view_destroy(first);
  }
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
  for (int i = 0; i < 4; ++i) CHECK(next.number != ids[i].number);
  cull(scene, view);
  CHECK(draws(view, next) && !draws(view, ids[1]));
  occlude_scene_destroy(scene);
  scene = NULL;
  CHECK(draws(view, next));  // a view outlives its scenes
}

/// A polygon of so many corners, at most five.
static occlude_mesh_data polygon_of(const double* corners, const uint32_t* count) {
  static const uint32_t indices[] = {0, 1, 2, 3, 4};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = corners;
  data.vertices.count = *count;
  data.indices = indices;
  data.index_count = *count;
  data.polygon_sizes = count;
  data.polygon_count = 1;
  return data;
}

static void options_of_objects_and_occluders(void) {
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
  CHECK(frame.count == 2 && frame.objects[0].number == sky.number && frame.objects[1].number == bus.number);
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
  frame_options.cover_work = UINT64_MAX;
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

  // Welded: two halves that only touch hide without a seam. The wall of before is no part of the weld.
  CHECK_OK(occlude_scene_enable_occluder(scene, body, 0));
  const double half_corners[] = {10, -5, -5, 10, 0, -5, 10, 0, 5, 10, -5, 5};
  const uint32_t four = 4, five = 5;
  const occlude_mesh_data half_data = polygon_of(half_corners, &four);
  occlude_mesh* half = NULL;
  CHECK_OK(occlude_mesh_create(&half_data, &half));
  occlude_placement beside = OCCLUDE_PLACEMENT_INIT;
  beside.origin[1] = 5;
  for (uint32_t weld = 0; weld <= 1; ++weld) {
    occlude_occluder_options half_options = OCCLUDE_OCCLUDER_OPTIONS_INIT;
    half_options.weld = weld;
    occlude_occluder halves[2];
    CHECK_OK(occlude_scene_add_occluder(scene, half, NULL, &half_options, &halves[0]));
    CHECK_OK(occlude_scene_add_occluder(scene, half, &beside, &half_options, &halves[1]));
    cull(scene, view);
    CHECK(draws(view, behind) == (weld == 0));
    CHECK_OK(occlude_scene_remove_occluder(scene, halves[0]));
    CHECK_OK(occlude_scene_remove_occluder(scene, halves[1]));
  }
  occlude_mesh_destroy(half);
  CHECK_OK(occlude_scene_enable_occluder(scene, body, 1));

  // Another mesh: a pentagon that looks to the eye, with a corner in the middle of an edge.
  const double corners[] = {10, -5, -5, 10, -5, 5, 10, 5, 5, 10, 5, 0, 10, 5, -5};
  occlude_mesh_data data = polygon_of(corners, &five);
  occlude_mesh* pentagon = NULL;
  CHECK_OK(occlude_mesh_create(&data, &pentagon));
  CHECK(occlude_mesh_polygons(pentagon) == 1 && occlude_mesh_polygons(wall) == 2 && occlude_mesh_polygons(NULL) == 0);
  occlude_box box;
  CHECK_OK(occlude_mesh_box(pentagon, &box));
  CHECK(box.min[0] == 10 && box.min[1] == -5 && box.max[0] == 10 && box.max[2] == 5);
  CHECK_OK(occlude_scene_replace_occluder(scene, body, pentagon));
  cull(scene, view);
  CHECK(!draws(view, behind));

  // The same of glass.
  const uint8_t see_through[] = {1};
  data.see_through = see_through;
  occlude_mesh* pane = NULL;
  CHECK_OK(occlude_mesh_create(&data, &pane));
  CHECK_OK(occlude_scene_replace_occluder(scene, body, pane));
  cull(scene, view);
  CHECK(draws(view, behind));
  occlude_mesh_destroy(pane);
  occlude_mesh_destroy(pentagon);
}

/// A wall with a doorway: its fan fills the doorway.
static void faces(void) {
  const float vertices[] = {0, 0, 0, 4, 0, 0, 4, 8, 0, 6, 8, 0, 6, 0, 0, 10, 0, 0, 10, 10, 1e-40f, 0, 10, 0};
  const occlude_points points = {vertices, 8, 0, OCCLUDE_FLOAT};
  const uint32_t wall_loop[] = {7, 0, 1, 2, 3, 4, 5, 6}, square[] = {0, 5, 6, 7}, tie[] = {0, 6, 5, 7};
  int32_t is_fan = 2;
  CHECK_OK(occlude_face_is_fan(&points, wall_loop, 8, &is_fan));
  CHECK(is_fan == 0);
  CHECK_OK(occlude_face_is_fan(&points, square, 4, &is_fan));
  CHECK(is_fan == 1);
  uint32_t triangles[18];
  size_t count = 0;
  CHECK_OK(occlude_face_triangles(&points, wall_loop, 8, triangles, &count));
  CHECK(count == 6);
  float area = 0;
  for (size_t i = 0; i < count; ++i) {
    const float *a = vertices + 3 * triangles[3 * i], *b = vertices + 3 * triangles[3 * i + 1],
                *c = vertices + 3 * triangles[3 * i + 2];
    const float doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    CHECK(doubled > 0);
    area += doubled / 2;
  }
  CHECK(area == 100 - 16);
  CHECK(occlude_face_triangles(&points, tie, 4, triangles, &count) == OCCLUDE_INVALID_ARGUMENT);
  CHECK(strcmp(occlude_last_error(), "the face crosses itself") == 0);
  CHECK(count == 6);
  const uint32_t beyond[] = {0, 1, 8};
  CHECK(occlude_face_is_fan(&points, beyond, 3, &is_fan) == OCCLUDE_INVALID_ARGUMENT);
  CHECK(strcmp(occlude_last_error(), "corner 2 is vertex 8 of 8") == 0);
  CHECK(occlude_face_is_fan(&points, square, 2, &is_fan) == OCCLUDE_INVALID_ARGUMENT);
  CHECK(occlude_face_is_fan(NULL, square, 4, &is_fan) == OCCLUDE_INVALID_ARGUMENT);
  CHECK(occlude_face_triangles(&points, square, 4, NULL, &count) == OCCLUDE_INVALID_ARGUMENT);
}

static void occluders_in_arrays(void) {
  // A wall and its mirror image beside it.
  occlude_placement placements[] = {OCCLUDE_PLACEMENT_INIT, OCCLUDE_PLACEMENT_INIT};
  placements[1].y[1] = -1;
  placements[1].origin[1] = 10;
  occlude_occluder ids[2];
  CHECK_OK(occlude_scene_add_occluders(scene, wall, placements, 2, NULL, ids));
  CHECK(ids[0].number != ids[1].number && occlude_scene_occluders(scene) == 2);
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
  ids[0].number = 123;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "placement 1: an occluder's placement is not finite, or takes it beyond 2^100",
                occlude_scene_add_occluders(scene, wall, placements, 2, NULL, ids));
  CHECK(ids[0].number == 0 && ids[1].number == 0 && occlude_scene_occluders(scene) == 1);
  CHECK_OK(occlude_scene_add_occluders(scene, wall, NULL, 0, NULL, NULL));
}

/// Boxes in records of the caller, in floats or doubles, of either kind and at odd places of memory.
static void arrays_with_strides(void) {
  occlude_occluder occluder;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));

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

/// The default look-at camera as a matrix for column vectors, row after row: clip x is to the right, -y; clip y is up, z.
static const double kMatrix[16] = {0, -1, 0, 0, 0, 0, 1, 0, 1, 0, 0, -0.2, 1, 0, 0, 0};

static void matrix_cameras(void) {
  occlude_occluder occluder;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  const occlude_box boxes[] = {kBehind, kBefore, kAway, {{11, 5.1, -1}, {12, 5.5, 1}}};
  const occlude_boxes array = boxes_of(boxes, 4);
  occlude_object ids[5];
  CHECK_OK(occlude_scene_add_objects(scene, &array, NULL, ids));
  CHECK_OK(occlude_scene_update(scene));

  double columns[16];
  float in_floats[16];
  for (int i = 0; i < 16; ++i) {
    columns[i % 4 * 4 + i / 4] = kMatrix[i];
    in_floats[i] = (float)kMatrix[i];
  }
  unsigned char odd[sizeof kMatrix + 1];
  memcpy(odd + 1, columns, sizeof columns);
  occlude_matrix_camera camera = OCCLUDE_MATRIX_CAMERA_INIT;
  camera.depth = OCCLUDE_DEPTH_MINUS_W_TO_W;
  for (int way = 0; way < 4; ++way) {
    camera.matrix = way == 0 ? (const void*)columns : way == 1 ? kMatrix : way == 2 ? (const void*)in_floats : odd + 1;
    camera.type = way == 2 ? OCCLUDE_FLOAT : OCCLUDE_DOUBLE;
    camera.order = way == 1 || way == 2 ? OCCLUDE_ROWS : OCCLUDE_COLUMNS;
    camera.nearer = way == 3 ? OCCLUDE_NEARER_LESS : OCCLUDE_NEARER_UNSAID;
    CHECK_OK(occlude_scene_cull(scene, &camera, NULL, view));
    CHECK(!draws(view, ids[0]) && draws(view, ids[1]) && !draws(view, ids[2]));
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    CHECK_OK(occlude_view_frame(view, &frame));
    CHECK(frame.plane_count == 5);
  }

  // The depth of the near plane follows from what is said of the depth: w = x, z = x - 0.2, so z >= 0 from x = 0.2, z >= -w
  // from 0.1.
  for (int is_zero = 0; is_zero < 2; ++is_zero) {
    camera.depth = is_zero ? OCCLUDE_DEPTH_ZERO_TO_W : OCCLUDE_DEPTH_MINUS_W_TO_W;
    CHECK_OK(occlude_scene_cull(scene, &camera, NULL, view));
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    CHECK_OK(occlude_view_frame(view, &frame));
    const occlude_half_space* near_plane = &frame.planes[4];
    CHECK(fabs(near_plane->offset / near_plane->normal[0] + (is_zero ? 0.2 : 0.1)) < 1e-3);
  }

  // What is seen past the edge of the wall by an eye that may move.
  camera.depth = OCCLUDE_DEPTH_MINUS_W_TO_W;
  const occlude_box at_the_edge = {{30, 12, -1}, {31, 12.5, 1}};
  CHECK_OK(occlude_scene_move_object(scene, ids[3], &at_the_edge));
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull(scene, &camera, NULL, view));
  CHECK(!draws(view, ids[3]));
  camera.eyes.radius = 3;
  CHECK_OK(occlude_scene_cull(scene, &camera, NULL, view));
  CHECK(draws(view, ids[3]));
  camera.eyes.radius = 0;

  // What is refused.
  const occlude_status refused = OCCLUDE_INVALID_ARGUMENT;
  camera.depth = OCCLUDE_DEPTH_UNSAID;
  CHECK_REFUSED(refused, "depth of the camera is not said", occlude_scene_cull(scene, &camera, NULL, view));
  camera.depth = 3;
  CHECK_REFUSED(refused, "depth of the camera is 3, which is none of its enumerators",
                occlude_scene_cull(scene, &camera, NULL, view));
  camera.depth = OCCLUDE_DEPTH_MINUS_W_TO_W;
  camera.nearer = 3;
  CHECK_REFUSED(refused, "nearer is 3, which is none of its enumerators", occlude_scene_cull(scene, &camera, NULL, view));
  camera.nearer = OCCLUDE_NEARER_GREATER;
  CHECK(occlude_scene_cull(scene, &camera, NULL, view) == refused);  // the matrix says otherwise
  camera.nearer = OCCLUDE_NEARER_LESS;
  camera.order = 2;
  CHECK_REFUSED(refused, "matrix order is 2, which is none of its enumerators",
                occlude_scene_cull(scene, &camera, NULL, view));
  camera.order = OCCLUDE_COLUMNS;
  camera.type = -1;
  CHECK_REFUSED(refused, "number type is -1, which is none of its enumerators",
                occlude_scene_cull(scene, &camera, NULL, view));
  camera.type = OCCLUDE_DOUBLE;
  camera.matrix = NULL;
  CHECK_REFUSED(refused, "matrix is null", occlude_scene_cull(scene, &camera, NULL, view));
  CHECK(draws(view, ids[3]));  // the last frame is kept

  // Why: by both kinds of cameras.
  occlude_fate fates[5];
  camera.matrix = columns;
  CHECK_OK(occlude_scene_add_object(scene, &kAway, NULL, &ids[4]));  // not yet in the scene that was culled
  const occlude_look_at_camera look_at = OCCLUDE_LOOK_AT_CAMERA_INIT;
  for (int way = 0; way < 2; ++way) {
    if (way == 0) CHECK_OK(occlude_scene_cull(scene, &camera, NULL, view));
    if (way == 1) CHECK_OK(occlude_scene_cull_look_at(scene, &look_at, NULL, view));
    CHECK_OK(occlude_scene_why(scene, view, ids, 5, fates));
    CHECK(fates[1].reason == OCCLUDE_DRAWN && fates[1].by_count == 0);
    CHECK(fates[4].reason == OCCLUDE_NOT_IN_SCENE);
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    CHECK_OK(occlude_view_frame(view, &frame));
    CHECK(fates[2].reason == OCCLUDE_OUT_OF_PLANE && fates[2].plane < frame.plane_count);
    CHECK(fates[0].reason == OCCLUDE_HIDDEN && fates[0].by_count == 2 && fates[3].reason == OCCLUDE_HIDDEN);
    for (size_t i = 0; i < fates[0].by_count; ++i) {
      const occlude_hiding* by = &fates[0].by[i];
      CHECK(by->occluder.number == occluder.number && by->polygon < 2 && by->corner_count == 3);
      for (size_t k = 0; k < by->corner_count; ++k) CHECK(by->corners[3 * k] == 10 && fabs(by->corners[3 * k + 1]) == 5);
    }
    CHECK(fates[0].by_count != 2 || fates[0].by[0].polygon != fates[0].by[1].polygon);
  }
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.least_size = 0.2F;
  options.mask = 1;
  CHECK_OK(occlude_scene_mask_object(scene, ids[1], 2));
  occlude_object_options always = OCCLUDE_OBJECT_OPTIONS_INIT;
  always.is_always_drawn = 1;
  CHECK_OK(occlude_scene_add_object(scene, &kAway, &always, &ids[4]));
  CHECK_OK(occlude_scene_enable_occluder(scene, occluder, 0));
  CHECK_OK(occlude_scene_update(scene));
  CHECK_OK(occlude_scene_cull_look_at(scene, &look_at, &options, view));
  CHECK_OK(occlude_scene_why(scene, view, ids, 5, fates));
  CHECK(fates[0].reason == OCCLUDE_TOO_SMALL && fates[1].reason == OCCLUDE_IN_NO_LAYER);
  CHECK(fates[4].reason == OCCLUDE_ALWAYS_DRAWN);
  CHECK_OK(occlude_scene_why(scene, view, NULL, 0, NULL));
  occlude_view* unused = NULL;
  CHECK_OK(occlude_view_create(&unused));
  CHECK_REFUSED(refused, "the view has no frame", occlude_scene_why(scene, unused, ids, 4, fates));
  occlude_view_destroy(unused);
}

/// Whether the frame lists what is nearer first.
static int is_front_to_back(int32_t wanted) {
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.is_front_to_back = wanted;
  CHECK_OK(occlude_scene_cull_look_at(scene, &camera, &options, view));
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  CHECK_OK(occlude_view_frame(view, &frame));
  CHECK(frame.count == 100);
  int is_sorted = 1;
  for (size_t i = 1; i < frame.count; ++i) is_sorted = is_sorted && frame.distances[i - 1] <= frame.distances[i];
  return is_sorted;
}

static void order(void) {
  for (int i = 0; i < 100; ++i) {
    const double y = i * 37 % 100 - 50;
    const occlude_box box = {{100, y, 0}, {101, y + 0.5, 1}};
    occlude_object object = OCCLUDE_NONE;
    CHECK_OK(occlude_scene_add_object(scene, &box, NULL, &object));
  }
  CHECK_OK(occlude_scene_update(scene));
  CHECK(is_front_to_back(1) && !is_front_to_back(0));
}

/// The matrix of a camera culls as the camera does, and may be the renderer's: reversed and infinite.
static void matrices_of_cameras(void) {
  occlude_object behind = OCCLUDE_NONE, beside = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_object(scene, &kBehind, NULL, &behind));
  CHECK_OK(occlude_scene_add_object(scene, &kBeside, NULL, &beside));
  occlude_occluder occluder = OCCLUDE_NONE;
  CHECK_OK(occlude_scene_add_occluder(scene, wall, NULL, NULL, &occluder));
  CHECK_OK(occlude_scene_update(scene));

  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  camera.fov_y_deg = 90;
  camera.aspect = 2;
  double matrix[16];
  CHECK_OK(occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_GREATER, matrix));
  const double expected[16] = {0, 0, 0, 1, -0.5, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.1, 0};
  for (int i = 0; i < 16; ++i) CHECK(fabs(matrix[i] - expected[i]) < 1e-15);
  occlude_matrix_camera same = OCCLUDE_MATRIX_CAMERA_INIT;
  same.matrix = matrix;
  same.depth = OCCLUDE_DEPTH_ZERO_TO_W;
  same.nearer = OCCLUDE_NEARER_GREATER;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.margin = occlude_margin_for(1080);
  CHECK(options.margin == 1.0 / 128 / 1080);
  CHECK_OK(occlude_scene_cull(scene, &same, &options, view));
  CHECK(!draws(view, behind) && draws(view, beside));

  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "which depths are nearer is not said",
                occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_UNSAID, matrix));
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "depth of the camera is not said",
                occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_UNSAID, OCCLUDE_NEARER_LESS, matrix));
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "matrix is null",
                occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_LESS, NULL));
  camera.projection = OCCLUDE_ORTHOGRAPHIC;
  CHECK_REFUSED(OCCLUDE_INVALID_ARGUMENT, "parallel rays without a far plane have no matrix",
                occlude_look_at_matrix(&camera, OCCLUDE_DEPTH_ZERO_TO_W, OCCLUDE_NEARER_LESS, matrix));
  options.margin = occlude_margin_for(0);
  CHECK_OK(occlude_scene_cull(scene, &same, &options, view));
  CHECK(draws(view, behind));
}

/// A cube of which each face is divided around its middle.
static void simplified_occluders(void) {
  float vertices[14][3] = {{0}};
  uint32_t indices[72], *next = indices;
  for (uint32_t i = 0; i < 8; ++i) {
    for (uint32_t axis = 0; axis < 3; ++axis) vertices[i][axis] = i >> axis & 1 ? 4.0F : 0;
  }
  for (uint32_t axis = 0; axis < 3; ++axis) {
    for (uint32_t far = 0; far < 2; ++far) {
      const uint32_t u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, at = far << axis, middle = 8 + 2 * axis + far;
      const uint32_t loop[] = {at, at | u, at | u | v, at | v};
      for (uint32_t k = 0; k < 3; ++k) vertices[middle][k] = k == axis ? 4 * (float)far : 2;
      for (uint32_t k = 0; k < 4; ++k) {
        *next++ = middle;
        *next++ = loop[far ? k : (k + 1) % 4];
        *next++ = loop[far ? (k + 1) % 4 : k];
      }
    }
  }
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = vertices;
  data.vertices.count = 14;
  data.vertices.type = OCCLUDE_FLOAT;
  data.indices = indices;
  data.index_count = 72;
  occlude_simplified* simplified = NULL;
  occlude_occluders few = OCCLUDE_OCCLUDERS_INIT;
  CHECK_OK(occlude_simplified_create(&data, NULL, &simplified));
  CHECK_OK(occlude_simplified_occluders(simplified, &few));
  CHECK(few.triangle_count == 12 && few.vertices.count == 8 && few.drawn_triangles == 24 && few.flat_triangles == 12);
  CHECK(few.inner_box_count == 0);
  for (uint32_t t = 0; t < 12; ++t) CHECK(few.polygons[t] < 24 && few.boxes[t] == 0xffffffffU);
  // They make a mesh, and are given back as they are.
  occlude_mesh_data again = OCCLUDE_MESH_DATA_INIT;
  again.vertices = few.vertices;
  again.indices = few.indices;
  again.index_count = 3 * few.triangle_count;
  occlude_mesh* mesh = NULL;
  CHECK_OK(occlude_mesh_create(&again, &mesh));
  CHECK(occlude_mesh_polygons(mesh) == 12);
  occlude_mesh_destroy(mesh);
  occlude_simplified_destroy(simplified);

  // Seen from beyond one face, that one hides the others. With boxes there are twice as many.
  occlude_look_at_camera views[] = {OCCLUDE_LOOK_AT_CAMERA_INIT, OCCLUDE_LOOK_AT_CAMERA_INIT};
  for (int i = 0; i < 2; ++i) {
    views[i].eye[0] = 9 + i;
    views[i].eye[1] = views[i].eye[2] = views[i].target[1] = views[i].target[2] = 2;
    views[i].target[0] = 0;
  }
  occlude_simplify_options options = OCCLUDE_SIMPLIFY_OPTIONS_INIT;
  options.views = views;
  options.view_count = 2;
  options.triangles = 2;
  CHECK_OK(occlude_simplified_create(&data, &options, &simplified));
  CHECK_OK(occlude_simplified_occluders(simplified, &few));
  CHECK(few.triangle_count == 2 && few.vertices.count == 4 && few.polygons[0] / 4 == 1 && few.polygons[1] / 4 == 1);
  for (size_t i = 0; i < 4; ++i) CHECK(((const double*)few.vertices.data)[3 * i] == 4);
  occlude_simplified_destroy(simplified);
  options.triangles = 100;
  options.boxes = 1;
  options.cells = 4;
  CHECK_OK(occlude_simplified_create(&data, &options, &simplified));
  CHECK_OK(occlude_simplified_occluders(simplified, &few));
  CHECK(few.triangle_count == 24 && few.inner_box_count == 1 && few.inner_boxes[0].max[0] == 4);
  size_t of_box = 0;
  for (size_t t = 0; t < 24; ++t) of_box += few.boxes[t] == 0 ? 1 : 0;
  CHECK(of_box == 12);
  occlude_simplified_destroy(simplified);
  // With bent faces it is flat inside alone.
  for (uint32_t i = 8; i < 14; ++i) vertices[i][(i - 8) / 2] += 0.001F;
  options.boxes = 0;
  CHECK_OK(occlude_simplified_create(&data, &options, &simplified));
  CHECK_OK(occlude_simplified_occluders(simplified, &few));
  CHECK(few.triangle_count == 24);
  occlude_simplified_destroy(simplified);
  options.inset = 0.01;
  CHECK_OK(occlude_simplified_create(&data, &options, &simplified));
  CHECK_OK(occlude_simplified_occluders(simplified, &few));
  CHECK(few.triangle_count == 12);
  occlude_simplified_destroy(simplified);
}

int main(void) {
  CHECK(occlude_version() == OCCLUDE_VERSION);
  run_test(objects_come_and_go);
  run_test(options_of_objects_and_occluders);
  run_test(faces);
  run_test(occluders_in_arrays);
  run_test(arrays_with_strides);
  run_test(matrix_cameras);
  run_test(matrices_of_cameras);
  run_test(order);
  run_test(simplified_occluders);
  return end_of_test();
}
