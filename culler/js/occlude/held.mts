// SPDX-License-Identifier: MIT
import {cameraOf, wayOf, type Camera, type Way} from "./cameras.mjs";
import {cullOptionsOf, flag, frameOf, type HeldCullOptions, type SceneFrame} from "./frames.mjs";
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {Disposable} from "./resource.mjs";
import type {Scene} from "./scene.mjs";

export interface HeldOptions extends HeldCullOptions {
  /** How far the eye may leave its way and the camera turn, at least. */
  readonly way?: Way;
  /**
   * Has a task called that culls a region: once, now or later. Such as `task => requestIdleCallback(task)`, so that regions
   * are culled in the time that frames leave. Default: they are culled when one is needed.
   */
  readonly later?: (task: () => void) => void;
  /** Whether the same cameras, at the same times, always give the same results. Default: false. */
  readonly repeatable?: boolean;
}

/** What became of the frames so far. */
export interface HeldStatistics {
  readonly frames: number;
  /** Culled for their own eye alone. */
  readonly ofPoint: number;
  /** Culled for regions, whether or not a frame used them. */
  readonly regions: number;
  /** Regions that held no longer when they were there. */
  readonly late: number;
}

/**
 * Culls a scene for one camera that moves, at a small part of the time of a cull for each frame: while one region of eyes
 * holds, the next is culled for where the eye will be then. Nothing of this makes a frame wrong. It keeps the scene, if that
 * is disposed of. More is said at occlude_held_cull in occlude.h.
 */
export class HeldSceneCull extends Disposable {
  /** @internal */
  constructor(library: Library, scene: Scene, options: HeldOptions = {}) {
    const of = scene.resource;
    const context = options.later && library.addLater(options.later);
    of.keep();
    const create = (scratch: Scratch, place: number) => {
      const how = scratch.struct(structs.heldOptions, {
        cull: cullOptionsOf(scratch, options),
        way: options.way && wayOf(scratch, {turnDegrees: 2, ...options.way}),
        later: context && library.c.occlude_js_later_function!(),
        context,
        is_repeatable: flag(options.repeatable),
      });
      return library.c.occlude_held_cull_create!(scene.pointerFor(library), how, place);
    };
    super(library, create, "occlude_held_cull_destroy", () => {
      if (context !== undefined) library.removeLater(context);
      of.release();
    });
  }

  /** What to draw for the next frame, at this time: seconds by any clock, from which speeds are found. */
  cull(camera: Camera, seconds: number): SceneFrame {
    const {library, pointer} = this.resource;
    library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      library.check(library.c[`occlude_held_cull_next${suffix}`]!(pointer, place, seconds));
    });
    return frameOf(library, "occlude_held_cull", pointer);
  }

  /** Whether the last frame was culled for itself alone. */
  get isOfPoint(): boolean {
    const {library, pointer} = this.resource;
    return library.c.occlude_held_cull_is_of_point!(pointer) !== 0;
  }

  get statistics(): HeldStatistics {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const counts = scratch.struct(structs.heldCounts);
      library.check(library.c.occlude_held_cull_counts!(pointer, counts));
      const of = (member: keyof typeof structs.heldCounts.fields) => structs.heldCounts.read(library.memory, counts, member);
      return {frames: of("frames"), ofPoint: of("of_point"), regions: of("regions"), late: of("late")};
    });
  }
}
