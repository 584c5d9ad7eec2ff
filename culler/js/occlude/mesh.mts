// SPDX-License-Identifier: MIT
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {refuse} from "./errors.mjs";
import {numbersOf, wordsOf, type Indices, type Numbers} from "./numbers.mjs";
import {Disposable} from "./resource.mjs";

/** Polygons, each drawn as the fan (v0, vi, vi+1) of its loop, and opaque from both sides. */
export interface Polygons {
  /** Three numbers each. */
  readonly vertices: Numbers;
  /** The loops of all polygons, one after another. */
  readonly indices: Indices;
  /** How many indices each polygon has, at least 3. Default: all are triangles. */
  readonly sizes?: Indices;
  /** For each polygon, not 0 where it hides nothing, as glass does. Default: all hide. */
  readonly seeThrough?: ArrayLike<number | boolean>;
}

/** An occlude_mesh_data. */
export function meshDataOf(scratch: Scratch, polygons: Polygons): number {
  const {data, count, type} = numbersOf(scratch, polygons.vertices, 3, "vertices");
  const {indices, sizes, seeThrough} = polygons;
  const polygonCount = sizes?.length ?? Math.floor(indices.length / 3);
  if (seeThrough !== undefined && seeThrough.length !== polygonCount) {
    refuse(`seeThrough: ${seeThrough.length} numbers of ${polygonCount} polygons`);
  }
  return scratch.struct(structs.meshData, {
    "vertices.data": data,
    "vertices.count": count,
    "vertices.type": type,
    indices: wordsOf(scratch, indices, "indices"),
    index_count: indices.length,
    polygon_sizes: sizes && wordsOf(scratch, sizes, "sizes"),
    polygon_count: sizes?.length,
    see_through: seeThrough && scratch.copyOf(Uint8Array.from(seeThrough, value => (value ? 1 : 0))),
  });
}

/** Geometry that hides, prepared once and shared by all occluders that have it. They keep it, if it is disposed of. */
export class OccluderMesh extends Disposable {
  /** @internal */
  constructor(library: Library, polygons: Polygons) {
    const create = (scratch: Scratch, place: number) => library.c.occlude_mesh_create!(meshDataOf(scratch, polygons), place);
    super(library, create, "occlude_mesh_destroy");
  }

  /** The number of polygons. */
  get size(): number {
    const {library, pointer} = this.resource;
    return library.c.occlude_mesh_polygons!(pointer) >>> 0;
  }

  /** The box that holds all vertices: six numbers. The origin if there are none. */
  get box(): Float64Array<ArrayBuffer> {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const box = scratch.room(48);
      library.check(library.c.occlude_mesh_box!(pointer, box));
      return library.doubles(box, 6);
    });
  }
}
