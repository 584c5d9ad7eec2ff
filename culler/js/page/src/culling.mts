// SPDX-License-Identifier: MIT
// What both methods of the package have in common, and culls that are held while they hold.
import type {Occlude} from "occlude";

import type {Camera} from "./camera.mjs";
import type {CullLimits, Frame, Method} from "./frame.mjs";
import type {Model} from "./model.mjs";
import {ObjectMethod} from "./objects.mjs";
import {length, scale, subtract, type Point} from "./points.mjs";
import {PolygonMethod} from "./polygons.mjs";

export const methods = {polygons: PolygonMethod, objects: ObjectMethod} as const;
export type MethodKey = keyof typeof methods;

/** Frames of one camera. With `hold` they are of a region of eyes ahead, and used while they hold: for so many seconds, at this speed. */
export class Culling {
  readonly #occlude: Occlude;
  readonly #method: Method;
  #last: {frame: Frame; isHeld: boolean; limits: string} | undefined;
  #before: {eye: Point; seconds: number} | undefined;
  /** What the last call took. */
  milliseconds = 0;
  /** Whether the last call found that the frame before holds. */
  isHeld = false;

  constructor(occlude: Occlude, model: Model, method: MethodKey) {
    this.#occlude = occlude;
    this.#method = new methods[method](occlude, model);
  }

  get everything(): Frame {
    return this.#method.everything;
  }

  /** `now` in seconds, by any clock. */
  cull(camera: Camera, limits: CullLimits, hold: number, now: number): Frame {
    const velocity = this.#velocityAt(camera.eye, now);
    const start = performance.now();
    const named = JSON.stringify(limits);
    this.isHeld = hold > 0 && this.#last?.isHeld === true && this.#last.limits === named && this.#method.holds(camera);
    if (!this.isHeld) {
      const asked = hold > 0 ? this.#occlude.ahead(camera, velocity, hold, {turnDegrees: kTurn}) : camera;
      this.#last = {frame: this.#method.cull(asked, limits), isHeld: hold > 0, limits: named};
    }
    this.milliseconds = performance.now() - start;
    return this.#last!.frame;
  }

  #velocityAt(eye: Point, seconds: number): Point {
    const before = this.#before;
    this.#before = {eye, seconds};
    if (before === undefined || seconds <= before.seconds) return [0, 0, 0];
    const velocity = scale(subtract(eye, before.eye), 1 / (seconds - before.seconds));
    return length(velocity) < kFastest ? velocity : [0, 0, 0];
  }

  dispose(): void {
    this.#method.dispose();
  }
}

/** How far the camera may turn while a frame is held, in degrees: about a quarter of a second of a walk round a corner. */
const kTurn = 8;
/** Units a second: who is faster has jumped. */
const kFastest = 1000;
