// SPDX-License-Identifier: MIT
// Frames of scenes, and how they are asked for.
import type {ObjectIds, OccluderIds} from "./ids.mjs";
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {fixed} from "./numbers.mjs";

/** The coarse picture, and the budget: what is hidden depends on them, what is visible is never left out. */
export interface CoverOptions {
  /** The coarse picture in pixels. A larger one hides more and costs more. Default: [576, 360]. */
  readonly coverSize?: readonly [number, number];
  /** The most work: one for each box that is asked, 16 for each triangle that is drawn into the picture. */
  readonly coverWork?: number;
  /** The most milliseconds. What is hidden depends on the machine's speed then. */
  readonly coverMs?: number;
  /**
   * By how much shadows are taken smaller, as a share of the picture's height: `marginFor(rows)` for a rasteriser to draw the
   * same pixels with and without culling. Default: 0.
   */
  readonly margin?: number;
}

export interface HeldCullOptions extends CoverOptions {
  /** Objects and occluders take part if their mask and this one have a bit in common. Default: all. */
  readonly mask?: number;
  /** Objects that look smaller are left out (SceneFrame.sizes). Default: 0. */
  readonly leastSize?: number;
  /** Whether objects are listed from front to back. Default: false. */
  readonly frontToBack?: boolean;
}

export interface CullOptions extends HeldCullOptions {
  /** Whether frames of the view save work where it does not pay. Otherwise a frame does not depend on those before it. Default: true. */
  readonly adaptive?: boolean;
  /** Whether only occluders hide that stand still, for a frame that later ones are held against. Default: false. */
  readonly toBeHeld?: boolean;
}

/** The half-space of the points with a x + b y + c z + d >= 0: four numbers each, a, b, c, d. */
export type Planes = Float64Array<ArrayBuffer>;

/** Each object with a layer of the frame is counted in exactly one of the first four. More is said at occlude_statistics. */
export interface SceneStatistics {
  readonly drawn: number;
  readonly outOfView: number;
  readonly hidden: number;
  readonly tooSmall: number;
  readonly occluders: number;
  readonly nodesVisited: number;
  readonly viewTests: number;
  readonly coverTests: number;
  readonly coverGroups: number;
  readonly coverGroupsLeft: number;
  readonly coverTriangles: number;
  readonly coverWork: number;
}

/** What to draw. All of it is the caller's own: copies, which nothing changes. */
export interface SceneFrame {
  /** The objects to draw, each once. `slots(frame.objects)` are indices for arrays of the caller's own. */
  readonly objects: ObjectIds;
  /** No less than the height and the width of each box in the picture, as a share of the picture's height. */
  readonly sizes: Float32Array<ArrayBuffer>;
  /** About the square of the distance from the eye to each box. -Infinity for what is always drawn. */
  readonly distances: Float32Array<ArrayBuffer>;
  /** Those that objects were tested against. */
  readonly planes: Planes;
  /** With `adaptive`: occluders that hid nothing when a frame of the view last looked at everything. */
  readonly idleOccluders: OccluderIds;
  readonly statistics: SceneStatistics;
}

export const coverValues = ({coverSize, coverWork, coverMs, margin}: CoverOptions) => ({
  cover_width: coverSize && fixed(coverSize, 2, "coverSize")[0],
  cover_height: coverSize?.[1],
  cover_work: coverWork,
  cover_ms: coverMs,
  margin,
});

/** A truth value, or the default. */
export const flag = (given: boolean | undefined) => (given === undefined ? undefined : Number(given));

/** An occlude_cull_options. */
export const cullOptionsOf = (scratch: Scratch, options: CullOptions): number =>
  scratch.struct(structs.cullOptions, {
    ...coverValues(options),
    mask: options.mask,
    least_size: options.leastSize,
    is_front_to_back: flag(options.frontToBack),
    is_to_be_held: flag(options.toBeHeld),
    is_adaptive: flag(options.adaptive),
  });

/** The last frame of something of C that has the functions PREFIX_frame and PREFIX_statistics. */
export function frameOf(library: Library, prefix: "occlude_view" | "occlude_held_cull", pointer: number): SceneFrame {
  return library.using(scratch => {
    const frame = scratch.struct(structs.frame);
    const counts = scratch.struct(structs.statistics);
    library.check(library.c[`${prefix}_frame`]!(pointer, frame));
    library.check(library.c[`${prefix}_statistics`]!(pointer, counts));
    const {memory} = library;
    const of = (member: keyof typeof structs.frame.fields) => structs.frame.read(memory, frame, member);
    const counted = (member: keyof typeof structs.statistics.fields) => structs.statistics.read(memory, counts, member);
    const count = of("count");
    return {
      objects: library.ids(of("objects"), count) as ObjectIds,
      sizes: library.floats(of("sizes"), count),
      distances: library.floats(of("distances"), count),
      planes: library.doubles(of("planes"), 4 * of("plane_count")),
      idleOccluders: library.ids(of("idle_occluders"), of("idle_occluder_count")) as OccluderIds,
      statistics: {
        drawn: counted("drawn"),
        outOfView: counted("out_of_view"),
        hidden: counted("hidden"),
        tooSmall: counted("too_small"),
        occluders: counted("occluders"),
        nodesVisited: counted("nodes_visited"),
        viewTests: counted("view_tests"),
        coverTests: counted("cover_tests"),
        coverGroups: counted("cover_groups"),
        coverGroupsLeft: counted("cover_groups_left"),
        coverTriangles: counted("cover_triangles"),
        coverWork: counted("cover_work"),
      },
    };
  });
}
