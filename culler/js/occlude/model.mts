// SPDX-License-Identifier: MIT
// Models that stand still: Culler, its cameras and its frames.
import {cameraOf, type Camera} from "./cameras.mjs";
import {coverValues, type CoverOptions, type Planes} from "./frames.mjs";
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {meshDataOf, type Polygons} from "./mesh.mjs";
import {choiceOf} from "./numbers.mjs";
import {Disposable} from "./resource.mjs";
import {asked} from "./view.mjs";

/** `automatic` is by cover, and saves work where it does not pay. */
export type Method = "automatic" | "frusta" | "cover";
const methods = ["automatic", "frusta", "cover"] as const;

export interface CullerOptions {
  /** The most polygons of a leaf. Smaller leaves cull more, but cost more and make more ranges. Default: 4. */
  readonly leafSize?: number;
  /** Default: aabb. */
  readonly bounds?: "aabb" | "obb";
}

export interface ModelCullOptions extends CoverOptions {
  readonly method?: Method;
  /** Frusta. The most occluders that a frame uses; 0: view-frustum culling alone. Default: 8. */
  readonly occluders?: number;
  /** Frusta. Candidates that are tried for the next frame. Default: 8. */
  readonly probes?: number;
  /** Frusta. Whether occluders that share an edge also hide together. Default: false. */
  readonly unions?: boolean;
}

export interface ModelStatistics {
  readonly drawnPolygons: number;
  readonly viewCulledPolygons: number;
  readonly shadowCulledPolygons: number;
  readonly nodesVisited: number;
  readonly viewTests: number;
  readonly shadowTests: number;
  readonly coverTests: number;
  readonly coverTriangles: number;
  /** Drawn unasked: the budget was spent, or they were idle. */
  readonly unaskedPolygons: number;
}

/** What to draw of a model. All of it is the caller's own: copies, which nothing changes. */
export interface ModelFrame {
  /** Ranges of Culler.order, two numbers each: the first polygon, and how many. With triangles alone, 3 x both are a draw call. */
  readonly drawn: Uint32Array<ArrayBuffer>;
  /** Ranges that are not drawn, four numbers each: first, count, why (CulledBy), and with CulledBy.view the index in `planes`. */
  readonly culled: Uint32Array<ArrayBuffer>;
  readonly planes: Planes;
  readonly statistics: ModelStatistics;
}

/** Why polygons of a model are not drawn. */
export const CulledBy = {view: 0, shadow: 1, cover: 2} as const;

/** One camera of a model, and its last frame. */
export class ModelView extends Disposable {
  /** @internal */
  constructor(library: Library) {
    super(library, (_, place) => library.c.occlude_model_view_create!(place), "occlude_model_view_destroy");
  }

  /** As View.holdsFor(). */
  holdsFor(camera: Camera): boolean {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      return asked(library, holds => library.c[`occlude_model_view_holds_for${suffix}`]!(pointer, place, holds));
    });
  }
}

/** A model that stands still. */
export class Culler extends Disposable {
  /** The number that each polygon of the culler's order had when given: draw the index buffer in this order. */
  readonly order: Uint32Array<ArrayBuffer>;

  /** @internal Takes a second for a million polygons. */
  constructor(library: Library, polygons: Polygons, options: CullerOptions = {}) {
    const isOriented = choiceOf(options.bounds ?? "aabb", ["aabb", "obb"], "bounds");
    const create = (scratch: Scratch, place: number) =>
      library.c.occlude_model_create!(meshDataOf(scratch, polygons), options.leafSize ?? 4, isOriented, place);
    super(library, create, "occlude_model_destroy");
    const {pointer} = this.resource;
    const count = library.c.occlude_model_polygons!(pointer) >>> 0;
    this.order = library.using(scratch => {
      const order = scratch.room(4 * count);
      library.check(library.c.occlude_model_order!(pointer, order));
      return library.words(order, count);
    });
  }

  /** Makes what frames by this method need; else the first of them does. */
  prepare(method: Method = "automatic"): void {
    const {library, pointer} = this.resource;
    library.check(library.c.occlude_model_prepare!(pointer, choiceOf(method, methods, "method")));
  }

  /** What to draw, for the next frame of the view. A view that was used with another culler starts anew. */
  cull(camera: Camera, view: ModelView, options: ModelCullOptions = {}): ModelFrame {
    const {library, pointer} = this.resource;
    const of = view.pointerFor(library);
    return library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      const how = scratch.struct(structs.modelOptions, {
        ...coverValues(options),
        method: choiceOf(options.method ?? "automatic", methods, "method"),
        occluders: options.occluders,
        probes: options.probes,
        is_with_unions: Number(options.unions ?? false),
      });
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
    culled: library.words(of("culled"), 4 * of("culled_count")),
    planes: library.doubles(of("planes"), 4 * of("plane_count")),
    statistics: {
      drawnPolygons: of("drawn_polygons"),
      viewCulledPolygons: of("view_culled_polygons"),
      shadowCulledPolygons: of("shadow_culled_polygons"),
      nodesVisited: of("nodes_visited"),
      viewTests: of("view_tests"),
      shadowTests: of("shadow_tests"),
      coverTests: of("cover_tests"),
      coverTriangles: of("cover_triangles"),
      unaskedPolygons: of("unasked_polygons"),
    },
  };
}
