// SPDX-License-Identifier: MIT
// Simplified occluders: few triangles that hide for a mesh.
import {lookAtsOf, type LookAtCamera} from "./cameras.mjs";
import {structs} from "./layout.mjs";
import type {Library} from "./library.mjs";
import {meshDataOf, type Polygons} from "./mesh.mjs";

export interface SimplifyOptions {
  /** At most. Default: 10000. */
  readonly triangles?: number;
  /** What the camera will see: those are chosen that hide most of the mesh there. Default: those with the largest area. */
  readonly views?: readonly LookAtCamera[];
  /** So many inner boxes of each closed part at most; for eyes that are never inside of one. Default: 0. */
  readonly boxes?: number;
  /** Along each axis of a part, of the grid in which boxes are looked for. Default: 16. */
  readonly cells?: number;
  /** By how much regions of closed parts may differ from flat ones. Default: 0, exactly flat. */
  readonly inset?: number;
}

/** The best come first. An OccluderMesh can be made of it as it is. */
export interface SimplifiedOccluders {
  readonly vertices: Float64Array<ArrayBuffer>;
  /** Three for each triangle. */
  readonly indices: Uint32Array<ArrayBuffer>;
  /** The polygon on which each lies, or the first of the part in which its box lies. */
  readonly polygons: Uint32Array<ArrayBuffer>;
  /** The number of the inner box of which each is half a face; 0xffffffff: none. */
  readonly boxes: Uint32Array<ArrayBuffer>;
  /** Six numbers each. */
  readonly innerBoxes: Float64Array<ArrayBuffer>;
  readonly drawnTriangles: number;
  readonly flatTriangles: number;
}

/** See Occlude.simplifiedOccluders. */
export function simplifiedOccluders(library: Library, polygons: Polygons, options: SimplifyOptions): SimplifiedOccluders {
  const {c} = library;
  return library.using(scratch => {
    const {views = []} = options;
    const how = scratch.struct(structs.simplifyOptions, {
      triangles: options.triangles,
      views: views.length === 0 ? 0 : lookAtsOf(scratch, () => library.memory, views),
      view_count: views.length,
      boxes: options.boxes,
      cells: options.cells,
      inset: options.inset,
    });
    const place = scratch.room(4);
    library.check(c.occlude_simplified_create!(meshDataOf(scratch, polygons), how, place));
    const pointer = library.memory.getUint32(place, true);
    try {
      const made = scratch.struct(structs.occluders);
      library.check(c.occlude_simplified_occluders!(pointer, made));
      return read(library, made);
    } finally {
      c.occlude_simplified_destroy!(pointer);
    }
  });
}

function read(library: Library, at: number): SimplifiedOccluders {
  const {memory} = library;
  const of = (member: keyof typeof structs.occluders.fields) => structs.occluders.read(memory, at, member);
  const count = of("triangle_count");
  return {
    vertices: library.doubles(of("vertices.data"), 3 * of("vertices.count")),
    indices: library.words(of("indices"), 3 * count),
    polygons: library.words(of("polygons"), count),
    boxes: library.words(of("boxes"), count),
    innerBoxes: library.doubles(of("inner_boxes"), 6 * of("inner_box_count")),
    drawnTriangles: of("drawn_triangles"),
    flatTriangles: of("flat_triangles"),
  };
}
