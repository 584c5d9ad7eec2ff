// SPDX-License-Identifier: MIT
// What a cull leaves of a model.
import type {LookAtCamera} from "occlude";

import type {Camera} from "./camera.mjs";

/** What became of a triangle in a frame. */
export const Fate = {drawn: 0, hidden: 1, outOfView: 2} as const;

export interface Counts {
  readonly drawn: number;
  readonly hidden: number;
  readonly outOfView: number;
}

/** What a frame draws of a model. */
export interface Frame {
  /** The three corners of each triangle, in the order of the method. */
  readonly index: Uint32Array<ArrayBuffer>;
  /** Ranges of triangles of that order, two numbers each: the first, and how many. */
  readonly drawn: Uint32Array<ArrayBuffer>;
  /** Triangles, of the model. */
  readonly counts: Counts;
  /** Writes a Fate for each triangle of the model. */
  tellFates(fates: Uint8Array): void;
}

export interface CullLimits {
  /** Milliseconds; undefined: none. */
  readonly budget?: number | undefined;
  readonly margin: number;
}

/** A way of the package to cull a model. */
export interface Method {
  /** A frame that draws all, in the order of all frames. */
  readonly everything: Frame;
  cull(camera: LookAtCamera, limits: CullLimits): Frame;
  /** Whether the last frame does for this camera, too. */
  holds(camera: Camera): boolean;
  dispose(): void;
}

/** Of a method that has this order. */
export const everythingIn = (index: Uint32Array<ArrayBuffer>): Frame => ({
  index,
  drawn: Uint32Array.of(0, index.length / 3),
  counts: {drawn: index.length / 3, hidden: 0, outOfView: 0},
  tellFates: fates => fates.fill(Fate.drawn),
});
