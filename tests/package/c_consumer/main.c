// SPDX-License-Identifier: MIT
// A program in C that links the C interface. A wall hides a thing: exit code 0 only when the thing is not drawn and the wall
// is.
#include <occlude.h>
#include <stdio.h>

#define TRY(call)                                               \
  do {                                                          \
    if ((call) != OCCLUDE_OK) {                                 \
      fprintf(stderr, "%s: %s\n", #call, occlude_last_error()); \
      return 1;                                                 \
    }                                                           \
  } while (0)

int main(void) {
  const double square[] = {2, -1, -1, 2, 1, -1, 2, 1, 1, 2, -1, 1};
  const uint32_t loop[] = {0, 1, 2, 3}, sizes[] = {4};
  occlude_mesh_data data = OCCLUDE_MESH_DATA_INIT;
  data.vertices.data = square;
  data.vertices.count = 4;
  data.indices = loop;
  data.index_count = 4;
  data.polygon_sizes = sizes;
  data.polygon_count = 1;
  occlude_mesh* mesh = NULL;
  TRY(occlude_mesh_create(&data, &mesh));

  occlude_scene* scene = NULL;
  TRY(occlude_scene_create(&scene));
  const occlude_box wall_box = {{2, -1, -1}, {2, 1, 1}}, thing_box = {{4, -0.5, -0.5}, {5, 0.5, 0.5}};
  occlude_object wall, thing;
  TRY(occlude_scene_add_object(scene, &wall_box, NULL, &wall));
  TRY(occlude_scene_add_object(scene, &thing_box, NULL, &thing));
  occlude_occluder occluder;
  TRY(occlude_scene_add_occluder(scene, mesh, NULL, NULL, &occluder));
  TRY(occlude_scene_update(scene));

  occlude_view* view = NULL;
  TRY(occlude_view_create(&view));
  const occlude_look_at_camera camera = OCCLUDE_LOOK_AT_CAMERA_INIT;  // from the origin along x
  TRY(occlude_scene_cull_look_at(scene, &camera, NULL, view));
  occlude_frame frame = OCCLUDE_FRAME_INIT;
  TRY(occlude_view_frame(view, &frame));
  const int is_right = frame.count == 1 && frame.objects[0].number == wall.number && occlude_version() == OCCLUDE_VERSION;

  occlude_view_destroy(view);
  occlude_scene_destroy(scene);
  occlude_mesh_destroy(mesh);
  printf("%s\n", is_right ? "culled" : "not culled");
  return is_right ? 0 : 1;
}
