// SPDX-License-Identifier: MIT
// The occlusion culler that is never wrong, for browsers, workers and Node.
//
//   import {load} from "occlude";
//   const occlude = await load();
//   const scene = new occlude.Scene();
import {ahead, matrixOf, type Camera, type ClipDepth, type LookAtCamera, type MatrixCamera, type Nearer, type Way} from "./cameras.mjs";
import {isFan, triangulate} from "./faces.mjs";
import {HeldSceneCull, type HeldOptions} from "./held.mjs";
import {loadLibrary, type Source} from "./load.mjs";
import {OccluderMesh, type Polygons} from "./mesh.mjs";
import {Culler, ModelView, type CullerOptions} from "./model.mjs";
import type {Indices, Numbers, Point} from "./numbers.mjs";
import {Scene} from "./scene.mjs";
import {View} from "./view.mjs";

export type {Camera, ClipDepth, EyeRegion, LookAtCamera, MatrixCamera, Nearer, Way} from "./cameras.mjs";
export {OccludeError, type ErrorCode} from "./errors.mjs";
export type {CoverOptions, CullOptions, HeldCullOptions, Planes, SceneFrame, SceneStatistics} from "./frames.mjs";
export type {HeldOptions, HeldSceneCull, HeldStatistics} from "./held.mjs";
export {slot, slots, type IdArray, type Ids, type ObjectId, type ObjectIds, type OccluderId, type OccluderIds} from "./ids.mjs";
export type {Source} from "./load.mjs";
export type {OccluderMesh, Polygons} from "./mesh.mjs";
export {hidden} from "./model.mjs";
export type {Culler, CullerOptions, ModelCullOptions, ModelFrame, ModelStatistics, ModelView} from "./model.mjs";
export type {Boxes, Indices, Numbers, Point} from "./numbers.mjs";
export type {Fate, Hiding, ObjectOptions, OccluderOptions, Placement, Reason, Scene} from "./scene.mjs";
export type {View, Visibility} from "./view.mjs";

/** One module of WebAssembly, with its memory. What belongs to one is refused by another. */
export interface Occlude {
  readonly version: string;
  readonly Scene: new () => Scene;
  readonly View: new () => View;
  readonly OccluderMesh: new (polygons: Polygons) => OccluderMesh;
  readonly HeldSceneCull: new (scene: Scene, options?: HeldOptions) => HeldSceneCull;
  readonly Culler: new (polygons: Polygons, options?: CullerOptions) => Culler;
  readonly ModelView: new () => ModelView;
  /**
   * A camera from the middle of the way that the eye takes in so many seconds, with all eyes near the way as its `eyes`: a
   * frame of it holds for a camera that is anywhere there. View.holdsFor() tells.
   */
  ahead(camera: Camera, velocity: Point, seconds: number, way?: Way): LookAtCamera;
  /** The matrix of a camera, for the renderer. With `greater` and no far plane, depth is reversed and infinite. */
  matrixOf(camera: LookAtCamera, depth: ClipDepth, nearer: Nearer): MatrixCamera;
  /** CoverOptions.margin for a picture of so many rows of pixels. */
  marginFor(rows: number): number;
  /** Whether the fan of the loop draws the face: nothing outside of it, and nothing twice. */
  isFan(vertices: Numbers, loop: Indices): boolean;
  /** Triangles that are the face, which may be concave or have openings: three vertices each. */
  triangulate(vertices: Numbers, loop: Indices): Uint32Array<ArrayBuffer>;
  /** Bytes of memory that the module has. It never shrinks. */
  readonly memoryBytes: number;
}

/** Starts a module: once for a page, or for a worker. Reads occlude.wasm beside this file unless a source is given. */
export async function load(source?: Source): Promise<Occlude> {
  const library = await loadLibrary(source);
  const version = library.c.occlude_version!();
  return {
    version: [version / 10000, (version / 100) % 100, version % 100].map(Math.floor).join("."),
    Scene: class extends Scene {
      constructor() {
        super(library);
      }
    },
    View: class extends View {
      constructor() {
        super(library);
      }
    },
    OccluderMesh: class extends OccluderMesh {
      constructor(polygons: Polygons) {
        super(library, polygons);
      }
    },
    HeldSceneCull: class extends HeldSceneCull {
      constructor(scene: Scene, options?: HeldOptions) {
        super(library, scene, options);
      }
    },
    Culler: class extends Culler {
      constructor(polygons: Polygons, options?: CullerOptions) {
        super(library, polygons, options);
      }
    },
    ModelView: class extends ModelView {
      constructor() {
        super(library);
      }
    },
    ahead: (camera, velocity, seconds, way = {}) => ahead(library, camera, velocity, seconds, way),
    matrixOf: (camera, depth, nearer) => matrixOf(library, camera, depth, nearer),
    marginFor: rows => library.c.occlude_margin_for!(rows),
    isFan: (vertices, loop) => isFan(library, vertices, loop),
    triangulate: (vertices, loop) => triangulate(library, vertices, loop),
    get memoryBytes() {
      return library.c.memory.buffer.byteLength;
    },
  };
}
