// SPDX-License-Identifier: MIT
// The C interface of occlude: a world of objects and occluders that changes, culled from any number of cameras. It is the
// interface for programs in C, for other languages, and for C++ without exceptions. docs/c.md has an introduction; what
// culling promises is written at `class Scene` in occlude/culler/scene.h.
//
// 1. **No exceptions.** No function throws, ends the program or prints. Each that can fail returns an occlude_status;
//    occlude_last_error() then says why. What fails changes nothing, unless it is said.
// 2. **Arguments** are checked. Null pointers, ids of nothing, numbers that are not legal and unknown enumerators are
//    refused. Not checked: that a handle is one of this library and was not destroyed, that memory has the size that was
//    said, and that an executor runs each part once.
// 3. **Structs** of options, cameras, data, frames and statistics begin with their size, which the OCCLUDE_..._INIT macros
//    fill in. A newer library takes the shorter struct of an older header, and uses defaults for what that does not have. A
//    longer one is refused. Options may be null: all defaults.
// 4. **Truth values** are of type int32_t: 0 is false, everything else true.
// 5. **Threads.** Functions that take a pointer to a const scene may run on several threads at once, each with a view of
//    its own. Changes may be made while others cull, one change at a time; but different objects that have
//    occlude_object_options.moves may be moved on several threads at once. occlude_scene_update() must run alone. A view
//    belongs to one thread while it is culled with; between frames any number of threads may ask it. Meshes may be made on
//    any thread, and used on all. An occlude_executor spreads one call over threads of the caller. An occlude_held_cull
//    belongs to one thread at a time.
// 6. **Coordinates** are right-handed and in any unit. Those of meshes are at most 2^100; boxes may have any numbers but NaN
//    (`class Scene`, Boxes).
#ifndef OCCLUDE_H
#define OCCLUDE_H

#include <stddef.h>
#include <stdint.h>

// To use the shared library on Windows, define OCCLUDE_SHARED, as CMake does.
#if defined(_WIN32) && defined(OCCLUDE_BUILDS_SHARED)
#define OCCLUDE_API __declspec(dllexport)
#elif defined(_WIN32) && defined(OCCLUDE_SHARED)
#define OCCLUDE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define OCCLUDE_API __attribute__((visibility("default")))
#else
#define OCCLUDE_API
#endif

// A function that never throws.
#ifdef __cplusplus
#define OCCLUDE_NO_THROW noexcept
extern "C" {
#else
#define OCCLUDE_NO_THROW
#endif

// ---- Version and errors ----

/// The version of this header: 10000 major + 100 minor + patch.
#define OCCLUDE_VERSION 100

/// The version of the library, as OCCLUDE_VERSION. While major is 0, another minor version is another interface.
OCCLUDE_API uint32_t occlude_version(void) OCCLUDE_NO_THROW;

typedef int32_t occlude_status;
enum {
  OCCLUDE_OK = 0,
  OCCLUDE_INVALID_ARGUMENT = 1,  ///< a null pointer, a number that is not legal, an unknown enumerator
  OCCLUDE_UNKNOWN_ID = 2,        ///< an id of nothing that is in the scene, such as one of another scene
  OCCLUDE_OUT_OF_MEMORY = 3,
  OCCLUDE_ROUNDING_MODE = 4,  ///< the processor does not round to nearest: nothing is made, culled or answered then
  OCCLUDE_STOPPED = 5,        ///< the caller's `should_stop` said so
  OCCLUDE_FAILED = 6          ///< anything else, such as a thread that could not be started
};

/// The name of a status in English; never null.
OCCLUDE_API const char* occlude_status_text(occlude_status status) OCCLUDE_NO_THROW;

/// Why the last function of this library that failed on this thread did so, with the place: "box 3: box has min > max". An
/// empty string if none did. Valid until the next one fails on this thread.
OCCLUDE_API const char* occlude_last_error(void) OCCLUDE_NO_THROW;

// ---- Numbers, points and boxes ----

typedef int32_t occlude_number_type;
enum { OCCLUDE_DOUBLE = 0, OCCLUDE_FLOAT = 1 };

typedef int32_t occlude_box_kind;
enum {
  OCCLUDE_ALIGNED = 0,  ///< 6 numbers: the least x, y, z, then the greatest
  OCCLUDE_ORIENTED = 1  ///< 12 numbers: the centre, then three half edges, any vectors
};

/// An axis-aligned box: 6 numbers as OCCLUDE_ALIGNED has them.
typedef struct occlude_box {
  double min[3], max[3];
} occlude_box;

/// An oriented box {center + a h0 + b h1 + g h2 : |a|, |b|, |g| <= 1}: 12 numbers as OCCLUDE_ORIENTED has them.
typedef struct occlude_oriented_box {
  double center[3], half_edges[3][3];
} occlude_oriented_box;

/// Points in memory of the caller: three numbers each. `data` may be null if `count` is 0. Nothing need be aligned.
typedef struct occlude_points {
  const void* data;
  size_t count;
  size_t stride;  ///< bytes from one point to the next; 0: they follow one another
  occlude_number_type type;
} occlude_points;

/// Boxes in memory of the caller: 6 or 12 numbers each. Otherwise as occlude_points.
typedef struct occlude_boxes {
  const void* data;
  size_t count;
  size_t stride;
  occlude_number_type type;
  occlude_box_kind kind;
} occlude_boxes;

// ---- Threads of the caller ----

/// A part of a piece of work, and what it is called with.
typedef void (*occlude_part)(void* work, size_t part);

/// Runs parts of a piece of work on threads of the caller: a job system, or a pool of threads. Results do not depend on it.
typedef struct occlude_executor {
  size_t size;     ///< of this struct
  size_t threads;  ///< how many parts `run` can run at once, 1 to 65536; work is divided into about so many
  /// Calls part(work, 0), ..., part(work, count - 1), each once, in any order and on any threads, at once or one after
  /// another. Returns when all have returned. Parts never throw. Must be said.
  void (*run)(void* context, size_t count, occlude_part part, void* work);
  void* context;
} occlude_executor;

#define OCCLUDE_EXECUTOR_INIT \
  { sizeof(occlude_executor), 1, NULL, NULL }

// ---- Meshes: what hides ----

/// Geometry that hides, prepared once and shared by all occluders that have it. It cannot be changed.
typedef struct occlude_mesh occlude_mesh;

/// Polygons, each drawn as the fan (v0, vi, vi+1) of its loop, whatever its shape, and opaque from both sides. A face that
/// is concave or has openings is not what its fan draws: occlude_face_is_fan() tells, occlude_face_triangles() divides it.
/// They may overlap and leave gaps. What they hide together is hidden.
typedef struct occlude_mesh_data {
  size_t size;  ///< of this struct
  occlude_points vertices;
  const uint32_t* indices;  ///< the loops of all polygons, one after another
  size_t index_count;
  const uint32_t* polygon_sizes;  ///< how many indices each polygon has, at least 3; null: all are triangles
  size_t polygon_count;           ///< 0 if polygon_sizes is null
  /// Asked every few milliseconds, on any thread and on several at once; not 0: making the mesh is given up. Null: never.
  int (*should_stop)(void* context);
  void* context;
  const occlude_executor* executor;  ///< where the mesh is made; null: threads of the library's own, one for each processor
  const uint8_t* see_through;        ///< for each polygon, not 0 where it hides nothing, as glass does; null: all hide
} occlude_mesh_data;

#define OCCLUDE_MESH_DATA_INIT \
  { sizeof(occlude_mesh_data), {NULL, 0, 0, OCCLUDE_DOUBLE}, NULL, 0, NULL, 0, NULL, NULL, NULL, NULL }

/// Copies the data, and writes the mesh to `mesh`. A mesh without polygons is legal and hides nothing.
OCCLUDE_API occlude_status occlude_mesh_create(const occlude_mesh_data* data, occlude_mesh** mesh) OCCLUDE_NO_THROW;
/// Occluders that have the mesh keep it for as long as they need it. Null is nothing.
OCCLUDE_API void occlude_mesh_destroy(occlude_mesh* mesh) OCCLUDE_NO_THROW;
/// The number of polygons; 0 for null.
OCCLUDE_API size_t occlude_mesh_polygons(const occlude_mesh* mesh) OCCLUDE_NO_THROW;
/// The box that holds all vertices; the origin if there are none.
OCCLUDE_API occlude_status occlude_mesh_box(const occlude_mesh* mesh, occlude_box* box) OCCLUDE_NO_THROW;

// ---- Faces of any shape ----

// A face is a loop of `count` vertices, at least 3. It lies in a plane, or nearly; it may be concave; an opening is joined
// to the outline by an edge that is passed twice. occlude/culler/polygon_soup.h says all of it. Numbers nearer to 0 than
// 2^-100 are taken for 0.

/// Writes to `is_fan` whether the fan of the loop draws the face: nothing outside of it, and nothing twice.
OCCLUDE_API occlude_status occlude_face_is_fan(const occlude_points* vertices, const uint32_t* loop, size_t count,
                                               int32_t* is_fan) OCCLUDE_NO_THROW;
/// Writes triangles that are the face to `triangles`, three vertices each, and to `triangle_count` how many they are: at
/// most `count` - 2, for which there must be room. Refused is a face that crosses itself.
OCCLUDE_API occlude_status occlude_face_triangles(const occlude_points* vertices, const uint32_t* loop, size_t count,
                                                  uint32_t* triangles, size_t* triangle_count) OCCLUDE_NO_THROW;

// ---- Scenes: objects and occluders ----

/// Objects with boxes, and occluders that need not be what is drawn. Changes show at the next occlude_scene_update().
typedef struct occlude_scene occlude_scene;

/// Name one object, or one occluder, of one scene until it is removed. No two ids that a program ever gets have the same
/// number, whatever scenes they are of. So functions refuse the ids of what was removed and those of another scene. What an
/// id names, its generation and its scene are in its number; 0 is none.
typedef struct occlude_object {
  uint64_t number;
} occlude_object;
typedef struct occlude_occluder {
  uint64_t number;
} occlude_occluder;

/// Initialises an id of either type that names nothing.
#define OCCLUDE_NONE \
  { 0 }

/// A small number that what is in the scene has to itself: objects apart from occluders. What is added takes the slot of
/// what was removed, so an array of the caller's own that is indexed by slots stays short. Means nothing for OCCLUDE_NONE.
#define OCCLUDE_SLOT(id) ((uint32_t)((id).number & 0x0fffffffu))

OCCLUDE_API occlude_status occlude_scene_create(occlude_scene** scene) OCCLUDE_NO_THROW;
/// Null is nothing.
OCCLUDE_API void occlude_scene_destroy(occlude_scene* scene) OCCLUDE_NO_THROW;

typedef struct occlude_object_options {
  size_t size;  ///< of this struct
  /// Whether it is moved often: those that are cost time in each update, the others only when they are moved.
  int32_t moves;
  /// Whether it is in every frame whose mask it has, wherever it is.
  int32_t is_always_drawn;
  /// Layers: see occlude_cull_options.mask.
  uint32_t mask;
  uint32_t reserved;  ///< 0
} occlude_object_options;

#define OCCLUDE_OBJECT_OPTIONS_INIT \
  { sizeof(occlude_object_options), 0, 0, 0xffffffffu, 0 }

/// Boxes of objects may have any numbers but NaN, with min <= max. One that reaches beyond 2^100 has no place, and its
/// object is always drawn.
OCCLUDE_API occlude_status occlude_scene_add_object(occlude_scene* scene, const occlude_box* box,
                                                    const occlude_object_options* options,
                                                    occlude_object* object) OCCLUDE_NO_THROW;
/// Adds an object for each box and writes as many ids. Objects that are near each other are best added together. When memory
/// runs out, the ids of objects that were not added are OCCLUDE_NONE.
OCCLUDE_API occlude_status occlude_scene_add_objects(occlude_scene* scene, const occlude_boxes* boxes,
                                                     const occlude_object_options* options,
                                                     occlude_object* objects) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_remove_object(occlude_scene* scene, occlude_object object) OCCLUDE_NO_THROW;
/// All of them are in the scene, else nothing is removed. One that is named twice counts once. When memory runs out, the
/// first of them are removed.
OCCLUDE_API occlude_status occlude_scene_remove_objects(occlude_scene* scene, const occlude_object* objects,
                                                        size_t count) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_move_object(occlude_scene* scene, occlude_object object,
                                                     const occlude_box* box) OCCLUDE_NO_THROW;
/// Moves as many objects as there are boxes. When memory runs out, the first of them are moved.
OCCLUDE_API occlude_status occlude_scene_move_objects(occlude_scene* scene, const occlude_object* objects,
                                                      const occlude_boxes* boxes) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_enable_object(occlude_scene* scene, occlude_object object,
                                                       int32_t is_enabled) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_mask_object(occlude_scene* scene, occlude_object object,
                                                     uint32_t mask) OCCLUDE_NO_THROW;
/// Whether the scene has it: 1 or 0. 0 for a null scene.
OCCLUDE_API int32_t occlude_scene_has_object(const occlude_scene* scene, occlude_object object) OCCLUDE_NO_THROW;

/// An affine map: the point p of a mesh is at p.x x + p.y y + p.z z + origin in the scene. These are the columns of a
/// matrix. They need be neither unit vectors nor perpendicular.
typedef struct occlude_placement {
  double x[3], y[3], z[3], origin[3];
} occlude_placement;

/// The mesh where its vertices are.
#define OCCLUDE_PLACEMENT_INIT                   \
  {                                              \
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, { 0, 0, 0 } \
  }

typedef struct occlude_occluder_options {
  size_t size;  ///< of this struct
  /// As occlude_object_options.moves.
  int32_t moves;
  /// Whether it hides only with the polygons that look counter-clockwise from the eye, for renderers that cull back faces. A
  /// mirrored placement turns no polygon over.
  int32_t is_one_sided;
  /// Layers: see occlude_cull_options.mask.
  uint32_t mask;
  /// A number of the caller's, 0: none. Occluders with the same weld, and all other options the same, hide as one mesh does:
  /// where corners of theirs are at the same place, to the bit, their polygons share edges, and no seam is left between
  /// occluders that only touch. Each update in which one of them changed prepares a mesh of all that are enabled, about 2
  /// microseconds for each triangle, and allocates.
  uint32_t weld;
  /// The object that draws it, if any, which is in the scene. It hides nothing in frames without that object: once the
  /// object is removed, and while it is disabled, in no layer of the frame or too small.
  occlude_object object;
} occlude_occluder_options;

#define OCCLUDE_OCCLUDER_OPTIONS_INIT \
  { sizeof(occlude_occluder_options), 0, 0, 0xffffffffu, 0, OCCLUDE_NONE }

/// Every point of an occluder must be on or inside something opaque that is drawn unless this scene hides it. A placement
/// may be null: OCCLUDE_PLACEMENT_INIT. Refused is one with a number that is not finite, or that takes its mesh beyond
/// 2^100.
OCCLUDE_API occlude_status occlude_scene_add_occluder(occlude_scene* scene, const occlude_mesh* mesh,
                                                      const occlude_placement* placement,
                                                      const occlude_occluder_options* options,
                                                      occlude_occluder* occluder) OCCLUDE_NO_THROW;
/// Adds an occluder of this mesh for each placement and writes as many ids. When memory runs out, the ids of those that were
/// not added are OCCLUDE_NONE.
OCCLUDE_API occlude_status occlude_scene_add_occluders(occlude_scene* scene, const occlude_mesh* mesh,
                                                       const occlude_placement* placements, size_t count,
                                                       const occlude_occluder_options* options,
                                                       occlude_occluder* occluders) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_remove_occluder(occlude_scene* scene, occlude_occluder occluder) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_move_occluder(occlude_scene* scene, occlude_occluder occluder,
                                                       const occlude_placement* placement) OCCLUDE_NO_THROW;
/// Gives it another mesh.
OCCLUDE_API occlude_status occlude_scene_replace_occluder(occlude_scene* scene, occlude_occluder occluder,
                                                          const occlude_mesh* mesh) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_enable_occluder(occlude_scene* scene, occlude_occluder occluder,
                                                         int32_t is_enabled) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_mask_occluder(occlude_scene* scene, occlude_occluder occluder,
                                                       uint32_t mask) OCCLUDE_NO_THROW;
/// Whether the scene has it: 1 or 0. 0 for a null scene.
OCCLUDE_API int32_t occlude_scene_has_occluder(const occlude_scene* scene, occlude_occluder occluder) OCCLUDE_NO_THROW;

/// Makes all changes since the last update. When memory runs out, the scene may only be destroyed.
OCCLUDE_API occlude_status occlude_scene_update(occlude_scene* scene) OCCLUDE_NO_THROW;
/// The same; large tiles, of thousands of objects that stand still, are built by the executor.
OCCLUDE_API occlude_status occlude_scene_update_by(occlude_scene* scene, const occlude_executor* executor) OCCLUDE_NO_THROW;

/// What is in the scene, disabled ones included, and bytes of memory held for objects; 0 for null.
OCCLUDE_API size_t occlude_scene_objects(const occlude_scene* scene) OCCLUDE_NO_THROW;
OCCLUDE_API size_t occlude_scene_occluders(const occlude_scene* scene) OCCLUDE_NO_THROW;
OCCLUDE_API size_t occlude_scene_object_bytes(const occlude_scene* scene) OCCLUDE_NO_THROW;

// ---- Cameras ----

typedef int32_t occlude_matrix_order;
enum {
  OCCLUDE_COLUMNS = 0,  ///< column after column: OpenGL, GLM; and row after row of Direct3D, for row vectors
  OCCLUDE_ROWS = 1      ///< row after row, for column vectors
};

/// The clip volume is -w <= x <= w, -w <= y <= w, and of the depth z:
typedef int32_t occlude_clip_depth;
enum {
  OCCLUDE_DEPTH_UNSAID = 0,        ///< refused: with the wrong one, what is visible might be hidden
  OCCLUDE_DEPTH_MINUS_W_TO_W = 1,  ///< -w <= z <= w, as in OpenGL
  OCCLUDE_DEPTH_ZERO_TO_W = 2      ///< 0 <= z <= w, as in Vulkan, Direct3D and Metal
};

/// Which of two depths z / w the renderer draws before the other.
typedef int32_t occlude_nearer;
enum {
  OCCLUDE_NEARER_UNSAID = 0,  ///< that which the matrix has nearer to its eye; must be said with parallel rays
  OCCLUDE_NEARER_LESS = 1,    ///< the usual
  OCCLUDE_NEARER_GREATER = 2  ///< reversed depth
};

/// Where the eye may be, relative to a camera's: in a ball, or in a box. All 0: there is one eye. What is culled for a
/// camera with such a region is hidden from each eye of it: those of two eyes of one person, or wherever the eye may be when
/// the picture is drawn.
typedef struct occlude_eye_region {
  double radius;            ///< of the ball, 0 or more
  double half_edges[3][3];  ///< of the box: its corners are all sums of them and their negatives
} occlude_eye_region;

/// The camera's own eye alone.
#define OCCLUDE_ONE_EYE_INIT            \
  {                                     \
    0, {                                \
      {0, 0, 0}, {0, 0, 0}, { 0, 0, 0 } \
    }                                   \
  }

/// A camera that is any projective matrix: the one that the renderer has, from the coordinates of the scene to clip space.
/// The matrix times the column (x, y, z, 1) is (x, y, z, w) in clip space. Perspective or parallel rays, either handedness,
/// reversed or infinite depth, off-centre or oblique: all of it follows from the matrix. More is said in
/// occlude/culler/camera.h.
typedef struct occlude_matrix_camera {
  size_t size;         ///< of this struct
  const void* matrix;  ///< 16 numbers of this type, in this order; need not be aligned
  occlude_number_type type;
  occlude_matrix_order order;
  occlude_clip_depth depth;  ///< must be said
  occlude_nearer nearer;
  occlude_eye_region eyes;  ///< relative to the matrix's eye
} occlude_matrix_camera;

#define OCCLUDE_MATRIX_CAMERA_INIT                                                                                     \
  {                                                                                                                    \
    sizeof(occlude_matrix_camera), NULL, OCCLUDE_DOUBLE, OCCLUDE_COLUMNS, OCCLUDE_DEPTH_UNSAID, OCCLUDE_NEARER_UNSAID, \
        OCCLUDE_ONE_EYE_INIT                                                                                           \
  }

typedef int32_t occlude_projection;
enum { OCCLUDE_PERSPECTIVE = 0, OCCLUDE_ORTHOGRAPHIC = 1 };

/// A right-handed camera that looks from `eye` to `target`, with `up` towards the top of the picture.
typedef struct occlude_look_at_camera {
  size_t size;  ///< of this struct
  double eye[3], target[3], up[3];
  double fov_y_deg;   ///< full vertical opening angle, in [0.001, 179]; perspective only
  double height;      ///< full vertical extent in units of the scene; orthographic only
  double aspect;      ///< width over height of the picture
  double near_plane;  ///< distance of the near plane from the eye, above 0
  double far_plane;   ///< as `near_plane`; 0 or infinite: no far plane
  occlude_projection projection;
  int32_t reserved;         ///< 0
  occlude_eye_region eyes;  ///< relative to `eye`
} occlude_look_at_camera;

#define OCCLUDE_LOOK_AT_CAMERA_INIT                                                                                       \
  {                                                                                                                       \
    sizeof(occlude_look_at_camera), {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 60, 100, 16.0 / 9.0, 0.1, 0, OCCLUDE_PERSPECTIVE, 0, \
        OCCLUDE_ONE_EYE_INIT                                                                                              \
  }

/// Writes the matrix of this camera to `matrix`, 16 numbers, column after column: for the renderer, and for
/// occlude_scene_cull(). With OCCLUDE_NEARER_GREATER and no far plane, depth is reversed and infinite. Both enumerators must
/// be said. Refused is an orthographic camera without a far plane.
OCCLUDE_API occlude_status occlude_look_at_matrix(const occlude_look_at_camera* camera, occlude_clip_depth depth,
                                                  occlude_nearer nearer, double* matrix) OCCLUDE_NO_THROW;

/// How far an eye may leave its way, and a head may turn. The lengths are for somebody who walks, in metres.
typedef struct occlude_ahead_options {
  size_t size;          ///< of this struct
  double aside;         ///< to both sides of the way, and before and after a way that is shorter
  double up;            ///< to both sides across that
  double turn_degrees;  ///< by how much the camera may turn, about any axis; perspective only
} occlude_ahead_options;

#define OCCLUDE_AHEAD_OPTIONS_INIT \
  { sizeof(occlude_ahead_options), 0.1, 0.05, 0 }

/// Writes to `ahead` a camera from the middle of the way that the eye takes in so many seconds, with all eyes near the way
/// as its `eyes`. A frame of it holds (occlude_view_holds_for()) for a camera with the same picture that is anywhere there,
/// turned by up to turn_degrees. It may be `camera` itself. Refused are a matrix of parallel rays, and numbers of which no
/// camera can be made. More is said at ahead() in occlude/culler/camera.h.
OCCLUDE_API occlude_status occlude_ahead(const occlude_matrix_camera* camera, const double velocity[3], double seconds,
                                         const occlude_ahead_options* options,
                                         occlude_look_at_camera* ahead) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_ahead_look_at(const occlude_look_at_camera* camera, const double velocity[3],
                                                 double seconds, const occlude_ahead_options* options,
                                                 occlude_look_at_camera* ahead) OCCLUDE_NO_THROW;

// ---- Simplified occluders: few triangles that hide for a mesh ----

typedef struct occlude_simplify_options {
  size_t size;       ///< of this struct
  size_t triangles;  ///< at most
  /// What the camera will see: those are chosen that hide most of the mesh in these views, all together, and then those that
  /// look largest from there. Null without any: those with the largest area.
  const occlude_look_at_camera* views;
  size_t view_count;
  /// Faces of inner boxes are chosen from, too, so many boxes of each closed part at most. They hide for eyes alone that are
  /// never inside of a closed part (occlude/culler/inner_boxes.h); all else hides for every eye.
  size_t boxes;
  /// Along each axis of a part, of the grid in which boxes are looked for: 3 to 64, else the nearest of these.
  size_t cells;
  /// By how much regions of closed parts may differ from flat ones and be merged still, inside of the part. 0: only what is
  /// exactly flat is merged. Otherwise they hide as boxes do.
  double inset;
} occlude_simplify_options;

#define OCCLUDE_SIMPLIFY_OPTIONS_INIT \
  { sizeof(occlude_simplify_options), 10000, NULL, 0, 0, 16, 0 }

/// Triangles that lie exactly on opaque polygons of a mesh and turn as they do, or are halves of faces of its inner boxes.
/// occlude/culler/simplified_occluders.h says why nothing is hidden wrongly.
typedef struct occlude_simplified occlude_simplified;

/// Makes them of what a mesh would be made of: occlude_mesh_data.executor and should_stop are used likewise.
OCCLUDE_API occlude_status occlude_simplified_create(const occlude_mesh_data* data, const occlude_simplify_options* options,
                                                     occlude_simplified** simplified) OCCLUDE_NO_THROW;
/// Null is nothing.
OCCLUDE_API void occlude_simplified_destroy(occlude_simplified* simplified) OCCLUDE_NO_THROW;

/// The best come first. The arrays belong to the occlude_simplified. Vertices and indices, or the first of them, are what
/// occlude_mesh_data has.
typedef struct occlude_occluders {
  size_t size;  ///< of this struct
  occlude_points vertices;
  const uint32_t* indices;   ///< three for each triangle
  const uint32_t* polygons;  ///< on which each lies, one of those; or the first of the part in which its box lies
  const uint32_t* boxes;     ///< the number of the inner box of which each is half a face; 0xffffffff: none
  size_t triangle_count;
  const occlude_box* inner_boxes;  ///< of which at least half a face is there
  size_t inner_box_count;
  size_t drawn_triangles;  ///< of the mesh: opaque, with three corners, not repeated
  size_t flat_triangles;   ///< that do for all of them
} occlude_occluders;

#define OCCLUDE_OCCLUDERS_INIT \
  { sizeof(occlude_occluders), {NULL, 0, 0, OCCLUDE_DOUBLE}, NULL, NULL, NULL, 0, NULL, 0, 0, 0 }

OCCLUDE_API occlude_status occlude_simplified_occluders(const occlude_simplified* simplified,
                                                        occlude_occluders* occluders) OCCLUDE_NO_THROW;

// ---- Frames ----

/// occlude_cull_options.margin for a picture of so many rows of pixels, drawn by a rasteriser with a grid of 1/256 pixel.
OCCLUDE_API double occlude_margin_for(uint32_t rows) OCCLUDE_NO_THROW;

/// One camera, and its last frame. It may be used with any scene at any time. A frame does not depend on those before it,
/// but for occlude_cull_options.is_adaptive.
typedef struct occlude_view occlude_view;

OCCLUDE_API occlude_status occlude_view_create(occlude_view** view) OCCLUDE_NO_THROW;
/// Null is nothing.
OCCLUDE_API void occlude_view_destroy(occlude_view* view) OCCLUDE_NO_THROW;

/// How a frame is culled.
typedef struct occlude_cull_options {
  size_t size;  ///< of this struct
  /// Where the objects are tested; null: on the calling thread. Occluders are drawn on the calling thread. The result is the
  /// same, and so is the order of the arrays.
  const occlude_executor* executor;
  /// The coarse picture in pixels, clamped to [64, 4096] and rounded up to multiples of 8. A larger one hides more and costs
  /// more. With a budget of less than about six milliseconds, or as much work, it is smaller than this.
  int32_t cover_width, cover_height;
  /// The budget: the most work, which is one for each box that is asked and 16 for each triangle that is drawn into the
  /// picture, and the most milliseconds. Occluders have three quarters of it; objects are all asked, because each is listed
  /// anyway. 0: no limit. With a limit of time, what is hidden depends on the machine's speed; nothing visible is.
  uint64_t cover_work;
  double cover_ms;
  /// By how much shadows are taken smaller, as a share of the picture's height: for a rasteriser to draw the same pixels
  /// with and without culling, at least what it rounds positions by. Nothing is hidden if it is negative or not a number.
  double margin;
  /// Objects and occluders take part if their mask and this one have a bit in common.
  uint32_t mask;
  /// Objects that look smaller are left out (occlude_frame.sizes).
  float least_size;
  /// Whether the objects to draw are listed from front to back.
  int32_t is_front_to_back;
  /// Whether only occluders hide that stand still, for a frame that later ones are held against. With a `least_size` those
  /// that an object draws hide nothing either: seen from elsewhere it may be too small.
  int32_t is_to_be_held;
  /// Whether the frames of a view save work where it does not pay. One in six looks at everything, and the others leave out
  /// the occluders that hid nothing then, unless they have changed since. Where less than a quarter of the objects in view
  /// was hidden, or in frames of little work less in proportion, later frames hide nothing, and one in 48 looks. A view that
  /// turns or moves far looks at once. Nothing is saved in frames that take less than about 0.3 ms, are of several eyes or
  /// are to be held. Otherwise a frame does not depend on those before it.
  int32_t is_adaptive;
  int32_t reserved;  ///< 0
} occlude_cull_options;

#define OCCLUDE_CULL_OPTIONS_INIT \
  { sizeof(occlude_cull_options), NULL, 576, 360, 0, 0, 0, 0xffffffffu, 0, 0, 0, 1, 0 }

/// What to draw, for the next frame of the view. If the camera is refused, the view keeps its last frame. When memory runs
/// out, it may be empty.
OCCLUDE_API occlude_status occlude_scene_cull(const occlude_scene* scene, const occlude_matrix_camera* camera,
                                              const occlude_cull_options* options, occlude_view* view) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_cull_look_at(const occlude_scene* scene, const occlude_look_at_camera* camera,
                                                      const occlude_cull_options* options,
                                                      occlude_view* view) OCCLUDE_NO_THROW;

/// Writes to `holds` whether the last frame of the view does for this camera, too: it leaves out nothing that the camera
/// shows from its eye and from all of its `eyes`. Never true by rounding, and not before the first frame. More is said at
/// View::holds_for() in occlude/culler/culler.h.
OCCLUDE_API occlude_status occlude_view_holds_for(const occlude_view* view, const occlude_matrix_camera* camera,
                                                  int32_t* holds) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_view_holds_for_look_at(const occlude_view* view, const occlude_look_at_camera* camera,
                                                          int32_t* holds) OCCLUDE_NO_THROW;

/// Writes to `holds` whether frames of this camera can be held against the last frame of `held`:
/// - that frame holds for the camera, and was culled with occlude_cull_options.is_to_be_held;
/// - `options` have its mask and least_size;
/// - no update since then has removed, moved, replaced, disabled or masked anew an occluder that stands still, or removed,
///   disabled or masked anew an object that draws an occluder;
/// - the scene reaches no farther from its eye than twice as far as then.
OCCLUDE_API occlude_status occlude_scene_holds(const occlude_scene* scene, const occlude_view* held,
                                               const occlude_matrix_camera* camera, const occlude_cull_options* options,
                                               int32_t* holds) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_holds_look_at(const occlude_scene* scene, const occlude_view* held,
                                                       const occlude_look_at_camera* camera,
                                                       const occlude_cull_options* options, int32_t* holds) OCCLUDE_NO_THROW;

/// The next frame of `view`, in which what hid in the last frame of `held` hides, and nothing is drawn into a coarse
/// picture. Each object is asked where it is now, so that objects may come, go and move. Occluders that move hide nothing,
/// and new ones not yet. Otherwise as occlude_scene_cull(); but occlude_scene_why() refuses such a frame, and
/// occlude_view_visibility() knows of no occluder in it. Refused unless occlude_scene_holds(), and if `held` is `view`.
/// Several threads may hold frames against one view at once.
OCCLUDE_API occlude_status occlude_scene_cull_held(const occlude_scene* scene, const occlude_matrix_camera* camera,
                                                   const occlude_cull_options* options, const occlude_view* held,
                                                   occlude_view* view) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_scene_cull_held_look_at(const occlude_scene* scene, const occlude_look_at_camera* camera,
                                                           const occlude_cull_options* options, const occlude_view* held,
                                                           occlude_view* view) OCCLUDE_NO_THROW;

/// The half-space of the points x with normal . x + offset >= 0.
typedef struct occlude_half_space {
  double normal[3], offset;
} occlude_half_space;

/// The objects to draw, each once, and the planes of the view. The arrays belong to the view.
typedef struct occlude_frame {
  size_t size;   ///< of this struct
  size_t count;  ///< objects to draw: elements of the three arrays
  const occlude_object* objects;
  /// No less than the height and the width of each box in the picture, as a share of the picture's height. Infinity for a
  /// box that reaches before the near plane, and for one that is always drawn.
  const float* sizes;
  /// About the square of the distance from the eye to each box, or how far along the line of sight it begins if rays are
  /// parallel. -infinity for what is always drawn.
  const float* distances;
  const occlude_half_space* planes;  ///< those that objects are tested against
  size_t plane_count;
  /// With is_adaptive: occluders that hid nothing when a frame of the view last looked at everything, though their polygons
  /// were looked at. They cost more than they hide. After the first frame of a view, only where there is work to save.
  const occlude_occluder* idle_occluders;
  size_t idle_occluder_count;
} occlude_frame;

#define OCCLUDE_FRAME_INIT \
  { sizeof(occlude_frame), 0, NULL, NULL, NULL, NULL, 0, NULL, 0 }

/// The last frame of the view; empty before the first. Valid until the next frame of this view.
OCCLUDE_API occlude_status occlude_view_frame(const occlude_view* view, occlude_frame* frame) OCCLUDE_NO_THROW;

/// Each object with a layer of the frame is counted in exactly one of the first four numbers.
typedef struct occlude_statistics {
  size_t size;               ///< of this struct
  size_t drawn;              ///< objects to draw
  size_t out_of_view;        ///< beyond a plane of the view
  size_t hidden;             ///< behind occluders
  size_t too_small;          ///< smaller than occlude_cull_options.least_size
  size_t occluders;          ///< of which at least a part was drawn into the coarse picture
  size_t nodes_visited;      ///< of the trees of objects and of occluders
  size_t view_tests;         ///< box against half-space
  size_t cover_tests;        ///< box against the coarse picture
  size_t cover_groups;       ///< joined meshes drawn into the picture
  size_t cover_groups_left;  ///< not drawn into it, because the budget was spent
  size_t cover_triangles;    ///< drawn into it
  uint64_t cover_work;       ///< as occlude_cull_options.cover_work counts it
} occlude_statistics;

#define OCCLUDE_STATISTICS_INIT \
  { sizeof(occlude_statistics), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/// Of the last frame; zeros before the first.
OCCLUDE_API occlude_status occlude_view_statistics(const occlude_view* view,
                                                   occlude_statistics* statistics) OCCLUDE_NO_THROW;

typedef int32_t occlude_visibility;
enum {
  OCCLUDE_VISIBLE = 0,     ///< neither of the other two could be proved
  OCCLUDE_OCCLUDED = 1,    ///< all of it is behind occluders
  OCCLUDE_OUT_OF_VIEW = 2  ///< all of it is beyond one plane of the view
};

/// Whether boxes, such as those of objects about to be created, would be visible in the last frame; before the first all
/// are. Writes as many answers as there are boxes. Refuses boxes with a number that is not legal (6); the answers before the
/// first of these are written.
OCCLUDE_API occlude_status occlude_view_visibility(const occlude_view* view, const occlude_boxes* boxes,
                                                   occlude_visibility* visibilities) OCCLUDE_NO_THROW;

/// A polygon that hides: its number in the mesh of the occluder, and where its corners are in the scene.
typedef struct occlude_hiding {
  occlude_occluder occluder;
  uint32_t polygon;
  uint32_t corner_count;
  const double* corners;  ///< x, y, z of each
} occlude_hiding;

typedef int32_t occlude_reason;
enum {
  OCCLUDE_DRAWN = 0,
  OCCLUDE_ALWAYS_DRAWN = 1,  ///< it has no place, or occlude_object_options.is_always_drawn
  OCCLUDE_OUT_OF_PLANE = 2,  ///< its box is beyond occlude_frame.planes[plane]
  OCCLUDE_HIDDEN = 3,        ///< `by` hide its box
  OCCLUDE_TOO_SMALL = 4,
  OCCLUDE_IN_NO_LAYER = 5,  ///< it is disabled, or has no bit of occlude_cull_options.mask
  OCCLUDE_NOT_IN_SCENE = 6  ///< there was no such object at the last update
};

/// What became of an object in a frame, and why.
typedef struct occlude_fate {
  occlude_reason reason;
  uint32_t plane;
  size_t by_count;
  const occlude_hiding* by;  ///< each polygon once; together they hide the box
} occlude_fate;

/// What became of these objects, all of them in the scene, in the last frame of the view. Refused before the first frame, if
/// the frame is of another scene, and if the scene was updated since. Takes the time of some frames. Writes as many fates as
/// there are objects; their arrays belong to the view, until its next frame or the next call of this function.
OCCLUDE_API occlude_status occlude_scene_why(const occlude_scene* scene, occlude_view* view, const occlude_object* objects,
                                             size_t count, occlude_fate* fates) OCCLUDE_NO_THROW;

// ---- Held culls: regions are culled now and then, and hold for the frames between ----

/// A task, and what it is called with.
typedef void (*occlude_task)(void* work);

typedef struct occlude_held_options {
  size_t size;  ///< of this struct
  /// Of all culls; null: defaults. Its executor is for frames, on the thread that asks for them.
  const occlude_cull_options* cull;
  /// How far the eye may leave its way and the camera turn, at least; null: defaults, but 2 degrees.
  const occlude_ahead_options* way;
  /// Where regions are culled while frames are drawn: has task(work) called once, on any thread, now or later, and returns
  /// at once. A task takes milliseconds and never throws. Where no thread is free, this may call it. One that is called
  /// after the held cull was destroyed does nothing; one that is never called costs a little memory. Null: regions are
  /// culled on the calling thread, when one is needed.
  void (*later)(void* context, occlude_task task, void* work);
  void* context;
  /// Whether the same cameras, at the same times, always give the same results: the next frame waits for a region that is
  /// being culled, and culls it itself if that has not begun.
  int32_t is_repeatable;
  int32_t reserved;  ///< 0
} occlude_held_options;

#define OCCLUDE_HELD_OPTIONS_INIT \
  { sizeof(occlude_held_options), NULL, NULL, NULL, NULL, 0, 0 }

/// Culls a scene for one camera that moves, as occlude_scene_cull() does, at a small part of its time: while one region
/// holds, the next is culled for where the eye will be then. A frame for which none holds is culled for itself, as the first
/// ones are, one after a jump, and where it would not pay. Nothing of this makes a frame wrong. Occluders that move hide in
/// frames for themselves alone. More is said at HeldCull and HeldSceneCull in occlude/culler/held_cull.h.
/// - The scene outlives it. occlude_scene_update() waits for a region that is being culled; it must still not run beside
///   occlude_held_cull_next(). Options are read once; the executor's and `later`'s functions and contexts outlive it.
typedef struct occlude_held_cull occlude_held_cull;

OCCLUDE_API occlude_status occlude_held_cull_create(const occlude_scene* scene, const occlude_held_options* options,
                                                    occlude_held_cull** held) OCCLUDE_NO_THROW;
/// Waits for a task that is running. Null is nothing.
OCCLUDE_API void occlude_held_cull_destroy(occlude_held_cull* held) OCCLUDE_NO_THROW;

/// What to draw for the next frame, at this time: seconds by any clock, from which speeds are found. What is refused leaves
/// the last frame as it was.
OCCLUDE_API occlude_status occlude_held_cull_next(occlude_held_cull* held, const occlude_matrix_camera* camera,
                                                  double seconds) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_held_cull_next_look_at(occlude_held_cull* held, const occlude_look_at_camera* camera,
                                                          double seconds) OCCLUDE_NO_THROW;

/// The last frame, and what was counted in it; empty, and zeros, before the first. Arrays are valid until the next frame.
OCCLUDE_API occlude_status occlude_held_cull_frame(const occlude_held_cull* held, occlude_frame* frame) OCCLUDE_NO_THROW;
OCCLUDE_API occlude_status occlude_held_cull_statistics(const occlude_held_cull* held,
                                                        occlude_statistics* statistics) OCCLUDE_NO_THROW;

/// Whether the last frame was culled for itself alone: 1 or 0. 0 for null.
OCCLUDE_API int32_t occlude_held_cull_is_of_point(const occlude_held_cull* held) OCCLUDE_NO_THROW;

/// What became of the frames so far.
typedef struct occlude_held_counts {
  size_t size;      ///< of this struct
  size_t frames;    ///< in all
  size_t of_point;  ///< culled for their own eye alone
  size_t regions;   ///< culled for regions, whether or not a frame used them
  size_t late;      ///< regions that held no longer when they were there
} occlude_held_counts;

#define OCCLUDE_HELD_COUNTS_INIT \
  { sizeof(occlude_held_counts), 0, 0, 0, 0 }

OCCLUDE_API occlude_status occlude_held_cull_counts(const occlude_held_cull* held,
                                                    occlude_held_counts* counts) OCCLUDE_NO_THROW;

#ifdef __cplusplus
}
#endif

#endif
