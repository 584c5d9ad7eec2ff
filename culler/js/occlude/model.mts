// SPDX-License-Identifier: MIT
// Models that stand still: Culler, its cameras and its frames.
import {cameraOf, type Camera} from "./cameras.mjs";
import {coverValues, flag, type CoverOptions, type Planes} from "./frames.mjs";
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {meshDataOf, type Polygons} from "./mesh.mjs";
import {choiceOf, wholeOf} from "./numbers.mjs";
import {Disposable} from "./resource.mjs";
import {holdsFor} from "./view.mjs";

export interface CullerOptions {
  /** The most polygons of a leaf. Smaller leaves cull more, but cost more and make more ranges. Default: 4. */
  readonly leafSize?: number;
  /** Default: aabb. */
  readonly bounds?: "aabb" | "obb";
}

export interface ModelCullOptions extends CoverOptions {
  /** As CullOptions.adaptive. Default: true. */
  readonly adaptive?: boolean;
}

export interface ModelStatistics {
  readonly drawnPolygons: number;
  readonly outOfViewPolygons: number;
  readonly hiddenPolygons: number;
  /** Drawn unasked: the budget was spent, or they were idle. */
  readonly unaskedPolygons: number;
  readonly nodesVisited: number;
  readonly viewTests: number;
  readonly coverTests: number;
  readonly coverTriangles: number;
  readonly coverWork: number;
}

/** What to draw of a model. All of it is the caller's own: copies, which nothing changes. */
export interface ModelFrame {
  /** Ranges of Culler.order, two numbers each: the first polygon, and how many. With triangles alone, 3 x both are a draw call. */
  readonly drawn: Uint32Array<ArrayBuffer>;
  /** Ranges that are not drawn, three numbers each: the first, how many, and the one of `planes` they are beyond, or `hidden`. */
  readonly culled: Uint32Array<ArrayBuffer>;
  readonly planes: Planes;
  readonly statistics: ModelStatistics;
}

/** Of a range of ModelFrame.culled, in place of a plane: other polygons hide it. */
export const hidden = 0xffffffff;

/** One camera of a model, and its last frame. */
export class ModelView extends Disposable {
  /** @internal */
  constructor(library: Library) {
    super(library, (_, place) => library.c.occlude_model_view_create!(place), "occlude_model_view_destroy");
  }

  /** As View.holdsFor(). */
  holdsFor(camera: Camera): boolean {
    return holdsFor(this, "occlude_model_view_holds_for", camera);
  }
}

/** A model that stands still. */
export class Culler extends Disposable {
  /** The number that each polygon of the culler's order had when given: draw the index buffer in this order. */
  readonly order: Uint32Array<ArrayBuffer>;

  /** @internal */
  constructor(library: Library, polygons: Polygons, options: CullerOptions = {}) {
    const isOriented = choiceOf(options.bounds ?? "aabb", ["aabb", "obb"], "bounds");
    const leafSize = wholeOf(options.leafSize ?? 4, "leafSize");
    const create = (scratch: Scratch, place: number) =>
      library.c.occlude_model_create!(meshDataOf(scratch, polygons), leafSize, isOriented, place);
    super(library, create, "occlude_model_destroy");
    const {pointer} = this.resource;
    const count = library.c.occlude_model_polygons!(pointer) >>> 0;
    this.order = library.using(scratch => {
      const order = scratch.room(4 * count);
      library.check(library.c.occlude_model_order!(pointer, order));
      return library.words(order, count);
    });
  }

  /** What to draw, for the next frame of the view. A view that was used with another culler starts anew. */
  cull(camera: Camera, view: ModelView, options: ModelCullOptions = {}): ModelFrame {
    const {library, pointer} = this.resource;
    const of = view.pointerFor(library);
    return library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      const how = scratch.struct(structs.modelOptions, {...coverValues(options), is_adaptive: flag(options.adaptive)});
      library.check(library.c[`occlude_model_cull${suffix}`]!(pointer, place, how, of));
      const frame = scratch.struct(structs.modelFrame);
      library.check(library.c.occlude_model_view_frame!(of, frame));
      return read(library, frame);
    });
  }
}

function read(library: Library, at: number): ModelFrame {
  const {memory} = library;
  const of = (member: keyof typeof structs.modelFrame.fields) => structs.modelFrame.read(memory, at, member);
  return {
    drawn: library.words(of("drawn"), 2 * of("drawn_count")),
    culled: library.words(of("culled"), 3 * of("culled_count")),
    planes: library.doubles(of("planes"), 4 * of("plane_count")),
    statistics: {
      drawnPolygons: of("drawn_polygons"),
      outOfViewPolygons: of("out_of_view_polygons"),
      hiddenPolygons: of("hidden_polygons"),
      unaskedPolygons: of("unasked_polygons"),
      nodesVisited: of("nodes_visited"),
      viewTests: of("view_tests"),
      coverTests: of("cover_tests"),
      coverTriangles: of("cover_triangles"),
      coverWork: of("cover_work"),
    },
  };
}
