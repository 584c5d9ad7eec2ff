// SPDX-License-Identifier: MIT
// The rows of the fuzzer's table that are not families: each asks a question of its own. experiment.cpp names them.
#pragma once

#include <cstdint>

#include "occlude/kernel/region_shadow.h"
#include "report.h"

namespace occlude::fuzz {

/// Damaged cases of any family: which side refuses, and which answers.
void run_refusals(std::uint64_t seed, Report& report);

/// Compares a box with the shadows of many cases at once (kernel/batch.h).
void run_frustum_batch(std::uint64_t seed, Report& report);

/// Compares boxes with the shadows of two occluders together (kernel/shadow_union.h): parts of one polygon, and others.
void run_unions(std::uint64_t seed, Report& report);

/// Compares boxes with half-spaces, one and many (kernel/half_space.h, kernel/view_frustum.h): the planes of a shadow
/// frustum as doubles, and perhaps a far plane.
void run_view_frusta(std::uint64_t seed, Report& report);

/// Compares what a viewpoint sees of two convex objects by the general test (kernel/judge, view_cone.h). The objects are
/// occluders of any case, parts of them and faces of boxes. Silhouettes and farthest vertices are compared as well.
void run_cones(std::uint64_t seed, Report& report);

/// The same for convex polytopes instead of boxes (kernel/judge, polytope_overlap.h): boxes, tetrahedra of their corners,
/// and occluders.
void run_occludees(std::uint64_t seed, Report& report);

/// Compares boxes with the joined shadow of several polygons (kernel/judge, cover.h): pieces of a polygon that fit exactly
/// or nearly, and any polygons on a lattice.
void run_covers(std::uint64_t seed, Report& report);

/// Compares boxes with the umbra or penumbra of an occluder for a region of viewpoints (kernel/region_shadow.h), as
/// region_questions.h makes them.
void run_region_shadows(kernel::ShadowKind kind, std::uint64_t seed, Report& report);

/// Compares frames of the culler with the promises of culling (cull_judge.h) and with a traversal that has no active sets.
/// The scenes are small: walls, boxes and folded loops on a lattice, and soups. The eye is in odd places and moves or jumps.
/// Options are random. A case is a polygon of a frame: `inside` means culled by shadow, `partial` drawn, `outside` culled by
/// view. It counts as decided by the exact stage when the frame needed that stage.
void run_culling(std::uint64_t seed, Report& report);

/// Gives the prover the witness lines of a forger who may write anything in the file. The scenes are small. The cameras have
/// all angles, shapes, near and far planes and both projections. Planes cut off little or much of the view, overflow or
/// vanish. Boxes, occluders, near planes, ranges, frames, parts and margins are true or false. A case is a line: `inside`
/// means that the prover accepts it, `outside` that it does not. By exact visibility, nothing that an accepted line culls
/// may show.
void run_forgeries(std::uint64_t seed, Report& report);

/// Gives the prover witness lines for regions of eyes that were bent: a window taken away or narrowed, a sheet without a
/// polygon or of another window, a focus plane moved, another region or near plane, a box that reaches nearer, another
/// polygon. A case is a line: `inside` means that the prover accepts it, `outside` that it does not and that a line of sight
/// from an eye of the region refutes it, `partial` that it does not accept it either. What is refuted must not be accepted.
void run_region_forgeries(std::uint64_t seed, Report& report);

/// Checks a small scene from a few viewpoints: every polygon is drawn or culled once, and every cull by cover is proved.
void run_joined(std::uint64_t seed, Report& report);

/// Checks frames for regions of eyes over small scenes, each of which aims at one thing that is hard to bound
/// (region_scenes.h). Every cull is proved by the oracle, and exact lines of sight from eyes of the region must not refute
/// it. A case is a polygon of a frame, as in run_culling().
void run_regions(std::uint64_t seed, Report& report);

/// Changes a small scene at random, some seventy times, with stale ids and frames between. A case is an object of a frame:
/// `inside` means hidden, `partial` drawn, `outside` out of view. Objects and occluders come, go, move, are disabled and
/// change layers. Each object must be drawn or counted once; what is culled is proved by the oracle; a scene that is made
/// anew with the same content must draw the same.
void run_worlds(std::uint64_t seed, Report& report);

/// Makes simplified occluders of fine walls, with boxes inside or without. A case is a triangle: `inside` means that it is
/// proved to lie on what is drawn, `partial` half a face of a proved inner box, `outside` one that was moved by three ulps,
/// which must not be proved. All that is drawn must lie on the triangles.
void run_simplified(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
