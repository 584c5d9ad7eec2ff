// SPDX-License-Identifier: MIT
// No struct that begins with its size ends in padding. A newer version appends members. If one of them lay in what was
// padding, the size of an older struct would say that it is there. It is valid C, so that tests can ask for other machines.
#pragma once

#include <stddef.h>

#include "occlude.h"

#ifdef __cplusplus
#define OCCLUDE_ASSERT static_assert
#else
#define OCCLUDE_ASSERT _Static_assert
#endif

#define OCCLUDE_LAST_MEMBER(type, member) \
  OCCLUDE_ASSERT(offsetof(type, member) + sizeof(((type*)0)->member) == sizeof(type), #type " ends in padding")

OCCLUDE_LAST_MEMBER(occlude_executor, context);
OCCLUDE_LAST_MEMBER(occlude_mesh_data, see_through);
OCCLUDE_LAST_MEMBER(occlude_simplify_options, inset);
OCCLUDE_LAST_MEMBER(occlude_occluders, flat_triangles);
OCCLUDE_LAST_MEMBER(occlude_object_options, reserved);
OCCLUDE_LAST_MEMBER(occlude_occluder_options, object);
OCCLUDE_LAST_MEMBER(occlude_matrix_camera, eyes);
OCCLUDE_LAST_MEMBER(occlude_look_at_camera, eyes);
OCCLUDE_LAST_MEMBER(occlude_ahead_options, turn_degrees);
OCCLUDE_LAST_MEMBER(occlude_cull_options, reserved);
OCCLUDE_LAST_MEMBER(occlude_frame, idle_occluder_count);
OCCLUDE_LAST_MEMBER(occlude_statistics, cover_work);
OCCLUDE_LAST_MEMBER(occlude_held_options, reserved);
OCCLUDE_LAST_MEMBER(occlude_held_counts, late);

#undef OCCLUDE_LAST_MEMBER
#undef OCCLUDE_ASSERT
