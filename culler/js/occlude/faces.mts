// SPDX-License-Identifier: MIT
// Faces of any shape.
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {numbersOf, wordsOf, type Indices, type Numbers} from "./numbers.mjs";
import {asked} from "./view.mjs";

const pointsOf = (scratch: Scratch, vertices: Numbers): number =>
  scratch.struct(structs.points, numbersOf(scratch, vertices, 3, "vertices"));

/** See Occlude.isFan. */
export const isFan = (library: Library, vertices: Numbers, loop: Indices): boolean =>
  library.using(scratch => {
    const points = pointsOf(scratch, vertices);
    const corners = wordsOf(scratch, loop, "loop");
    return asked(library, answer => library.c.occlude_face_is_fan!(points, corners, loop.length, answer));
  });

/** See Occlude.triangulate. */
export const triangulate = (library: Library, vertices: Numbers, loop: Indices): Uint32Array<ArrayBuffer> =>
  library.using(scratch => {
    const points = pointsOf(scratch, vertices);
    const corners = wordsOf(scratch, loop, "loop");
    const triangles = scratch.room(12 * loop.length);
    const count = scratch.room(4);
    library.check(library.c.occlude_face_triangles!(points, corners, loop.length, triangles, count));
    return library.words(triangles, 3 * library.memory.getUint32(count, true));
  });
