// SPDX-License-Identifier: MIT
// Other kinds of cullers, each as it is usually built. They know objects and their boxes, and what a picture shows at the centres of
// its pixels, and are as right as these are.
import {objectCount, type Model} from "./model.mjs";
import type {Picture} from "./picture.mjs";
import {DepthPyramid} from "./pyramid.mjs";

/** What a frame shows, and what the frame before showed. */
export interface Seen {
  readonly coarse: Picture;
  readonly before: Picture | undefined;
}

export interface Rival {
  readonly key: RivalKey;
  readonly title: string;
  /** What it does, for a reader. */
  readonly says: string;
  /** Not 0 for each object that it hides, out of view or not. */
  hide(model: Model, owners: Uint32Array, seen: Seen): Uint8Array;
}
export type RivalKey = "rays" | "pyramid" | "last";

/** The coarse picture is as wide as that: twice that of the smaller pictures of `bench rivals`, and what engines take. */
export const kCoarseWidth = 320;

export const rivals: readonly Rival[] = [
  {
    key: "rays",
    title: "Coarse rays",
    says: `A ray through the centre of each pixel of a picture ${kCoarseWidth} pixels wide: an object that none meets is left out.`,
    hide(model, owners, {coarse}) {
      const hidden = new Uint8Array(objectCount(model)).fill(1);
      for (const triangle of coarse.triangles) if (triangle > 0) hidden[owners[triangle - 1]!] = 0;
      return hidden;
    },
  },
  {
    key: "pyramid",
    title: "Depth pyramid",
    says: `The depths of a picture ${kCoarseWidth} pixels wide, and of ever smaller ones with the greatest of four each: a box behind ` +
      "all that it covers is left out.",
    hide: (model, _, {coarse}) => hiddenBehind(coarse, model),
  },
  {
    key: "last",
    title: "Last frame's depth",
    says: "The depths of the last frame, in full size: a box behind all that it covered there is left out of this one.",
    hide: (model, _, {before}) => (before ? hiddenBehind(before, model) : new Uint8Array(objectCount(model))),
  },
];

function hiddenBehind(picture: Picture, model: Model): Uint8Array {
  const pyramid = new DepthPyramid(picture, model);
  return Uint8Array.from({length: objectCount(model)}, (_, object) => Number(pyramid.hides(model.boxes, object)));
}
