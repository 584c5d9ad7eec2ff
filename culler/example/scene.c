// SPDX-License-Identifier: MIT
// The street of scene.cpp by the C interface: two rows of houses, things in the courts behind them, and a bus that drives
// along behind one row. The example walks down the street and prints what must be drawn, then walks slowly, with culls that
// hold.
#include <occlude.h>
#include <stdio.h>
#include <stdlib.h>

/// Ends the program if a call failed.
static void check(occlude_status status) {
  if (status == OCCLUDE_OK) return;
  fprintf(stderr, "%s\n", occlude_last_error());
  exit(1);
}

/// A box as six polygons.
static occlude_mesh* solid(occlude_box box) {
  double corners[8][3];
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) corners[i][axis] = (i >> axis & 1) != 0 ? box.max[axis] : box.min[axis];
  }
  const uint32_t faces[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  const uint32_t sizes[] = {4, 4, 4, 4, 4, 4};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices = (occlude_points){corners, 8, 0, OCCLUDE_DOUBLE};
  data.indices = faces;
  data.index_count = 24;
  data.polygon_sizes = sizes;
  data.polygon_count = 6;
  occlude_mesh* mesh = NULL;
  check(occlude_mesh_create(&data, &mesh));
  return mesh;
}

int main(void) {
  occlude_scene* scene = NULL;
  check(occlude_scene_create(&scene));
  // Each house is an object with a box. Its walls, half a metre inside the box, are an occluder; all houses share one mesh.
  occlude_mesh* walls = solid((occlude_box){{0.5, 0.5, 0.5}, {17.5, 15.5, 9}});
  for (int row = 0; row < 20; ++row) {
    const double x = 20 * (row / 2), y = row % 2 == 0 ? -20 : 20;
    const occlude_box box = {{x, y - 8, 0}, {x + 18, y + 8, 12}};
    occlude_occluder_options options = OCCLUDE_OCCLUDER_OPTIONS_INIT;
    check(occlude_scene_add_object(scene, &box, NULL, &options.object));
    occlude_placement placement = OCCLUDE_PLACEMENT_INIT;
    placement.origin[0] = x;
    placement.origin[1] = y - 8;
    occlude_occluder house;
    check(occlude_scene_add_occluder(scene, walls, &placement, &options, &house));

    // Things in the court, in single precision, added together.
    float court[8][6];
    for (int i = 0; i < 8; ++i) {
      const float left = (float)x + 2 * (float)i, front = y < 0 ? (float)y - 15 : (float)y + 12;
      const float thing[] = {left, front, 0, left + 1, front + 3, 2};
      for (int k = 0; k < 6; ++k) court[i][k] = thing[k];
    }
    const occlude_boxes things = {court, 8, sizeof court[0], OCCLUDE_FLOAT, OCCLUDE_ALIGNED};
    occlude_object ids[8];
    check(occlude_scene_add_objects(scene, &things, NULL, ids));
  }
  occlude_mesh_destroy(walls);  // the occluders keep it

  // The bus moves, and hides what is behind it.
  occlude_object_options moves = OCCLUDE_OBJECT_OPTIONS_INIT;
  moves.moves = 1;
  occlude_object bus;
  check(occlude_scene_add_object(scene, &(occlude_box){{0, 0, 0}, {0, 0, 0}}, &moves, &bus));
  occlude_occluder_options body_moves = OCCLUDE_OCCLUDER_OPTIONS_INIT;
  body_moves.moves = 1;
  body_moves.object = bus;
  occlude_mesh* shape = solid((occlude_box){{0, 0, 0.3}, {12, 2.5, 3}});
  occlude_occluder body;
  check(occlude_scene_add_occluder(scene, shape, NULL, &body_moves, &body));
  occlude_mesh_destroy(shape);

  occlude_view* view = NULL;  // one for each camera; several may be culled at once, each on its own thread
  check(occlude_view_create(&view));
  occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;
  occlude_cull_options options = OCCLUDE_CULL_OPTIONS_INIT;
  options.is_front_to_back = 1;
  for (int step = 0; step < 10; ++step) {
    const double x = 18.0 * step;
    occlude_placement placement = OCCLUDE_PLACEMENT_INIT;
    placement.origin[0] = x;
    placement.origin[1] = 34;
    check(occlude_scene_move_object(scene, bus, &(occlude_box){{x, 34, 0}, {x + 12, 36.5, 3}}));
    check(occlude_scene_move_occluder(scene, body, &placement));
    check(occlude_scene_update(scene));

    camera.eye[0] = 15.0 * step - 10;
    camera.eye[2] = 2;
    camera.target[0] = camera.eye[0] + 1;
    camera.target[1] = 0.5;
    camera.target[2] = 2;
    check(occlude_scene_cull_look_at(scene, &camera, &options, view));
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    check(occlude_view_frame(view, &frame));
    int is_bus_drawn = 0;
    for (size_t i = 0; i < frame.count; ++i) is_bus_drawn = is_bus_drawn || frame.objects[i].number == bus.number;

    const occlude_box place = {{60, 40, 0}, {61, 41, 2}};  // any box, whether or not it is an object
    const occlude_boxes spawn_place = {&place, 1, 0, OCCLUDE_DOUBLE, OCCLUDE_ALIGNED};
    occlude_visibility spawn = OCCLUDE_VISIBLE;
    check(occlude_view_visibility(view, &spawn_place, &spawn));
    occlude_statistics statistics = OCCLUDE_STATISTICS_INIT;
    check(occlude_view_statistics(view, &statistics));
    printf("frame %d: %3zu of %zu objects, %3zu hidden; the bus is %s, the spawn point %s\n", step, statistics.drawn,
           occlude_scene_objects(scene), statistics.hidden, is_bus_drawn ? "drawn" : "not drawn",
           spawn == OCCLUDE_VISIBLE    ? "visible"
           : spawn == OCCLUDE_OCCLUDED ? "hidden"
                                       : "out of view");
  }
  // The same at 60 frames a second: what hides is found now and then, for all eyes near the way, and holds between.
  occlude_held_cull* held = NULL;
  check(occlude_held_cull_create(scene, NULL, &held));  // or with the function of a job system, occlude_held_options.later
  for (int i = 0; i < 120; ++i) {
    const double seconds = i / 60.0;
    camera.eye[0] = 1.5 * seconds;
    camera.target[0] = camera.eye[0] + 1;
    check(occlude_held_cull_next_look_at(held, &camera, seconds));
    occlude_frame frame = OCCLUDE_FRAME_INIT;
    check(occlude_held_cull_frame(held, &frame));  // draw frame.objects
  }
  occlude_held_counts counts = OCCLUDE_HELD_COUNTS_INIT;
  check(occlude_held_cull_counts(held, &counts));
  printf("walking: %zu frames, %zu culled for themselves, %zu regions\n", counts.frames, counts.of_point, counts.regions);
  occlude_held_cull_destroy(held);
  occlude_view_destroy(view);
  occlude_scene_destroy(scene);
  return 0;
}
