// SPDX-License-Identifier: MIT
// Catches cullers that hide what shows. A picture of all triangles proposes what shows at the centre of a pixel; it counts only if a ray
// is proved to reach it.
import type {Camera} from "./camera.mjs";
import {Fate, type Frame} from "./frame.mjs";
import {ownersOf, triangleCount, type Model} from "./model.mjs";
import {isInPicture, rayOf, type Picture} from "./picture.mjs";
import {prove, type Proof} from "./proof.mjs";
import {kCoarseWidth, rivals, type RivalKey} from "./rivals.mjs";
import type {Painter} from "./painter.mjs";

export type AccusedKey = RivalKey | "occlude";

/** A culler that hides what shows. */
export interface Catch {
  readonly accused: AccusedKey;
  readonly proof: Proof;
  readonly object: number;
  /** Pixels of the picture that show the object. */
  readonly pixels: number;
  /** Where the proof's ray goes through the picture, from 0 to 1, from the lower left. */
  readonly at: readonly [number, number];
  readonly camera: Camera;
  /** Not 0 for each object that it hid; undefined of the package, which hides triangles. */
  readonly hidden: Uint8Array | undefined;
  /** Where the camera was in the frame before, which the last frame's depth is of. */
  readonly before: Camera | undefined;
}

export interface Score {
  frames: number;
  wrongFrames: number;
  wrongPixels: number;
  /** What each frame took, in milliseconds. */
  readonly times: number[];
  first: Catch | undefined;
}

export type Scores = Record<AccusedKey, Score>;
export const newScores = (): Scores => {
  const zero = (): Score => ({frames: 0, wrongFrames: 0, wrongPixels: 0, times: [], first: undefined});
  return {occlude: zero(), rays: zero(), pyramid: zero(), last: zero()};
};

/** How many pixels an accused culler is confronted with before a frame counts as right: a proof takes milliseconds. */
const kMostTries = 12;

export class Judge {
  readonly #painter: Painter;
  readonly #model: Model;
  readonly #owners: Uint32Array;
  #before: Picture | undefined;

  constructor(painter: Painter, model: Model) {
    this.#painter = painter;
    this.#model = model;
    this.#owners = ownersOf(model);
  }

  /** Forgets the frame before. */
  restart(): void {
    this.#before = undefined;
  }

  /** Judges the package's frame, which took so long, and what the others make of the same camera, in a picture of this size. */
  judge(camera: Camera, frame: Frame, milliseconds: number, [width, height]: readonly [number, number], scores: Scores): Catch[] {
    const model = this.#model;
    const shown = this.#painter.numbers(camera, width, height);
    const coarse = this.#painter.numbers(camera, kCoarseWidth, Math.max(1, Math.round((kCoarseWidth * height) / width)));
    const caught: Catch[] = [];
    const hold = (accused: AccusedKey, isHidden: (triangle: number) => boolean, time: number, hidden?: Uint8Array) => {
      const score = scores[accused], found = this.#confront(accused, shown, isHidden, hidden);
      score.frames += 1;
      score.times.push(time);
      if (found === undefined) return;
      score.wrongFrames += 1;
      score.wrongPixels += found.pixels;
      score.first ??= found;
      caught.push(found);
    };
    const fates = new Uint8Array(triangleCount(model));
    frame.tellFates(fates);
    hold("occlude", triangle => fates[triangle] !== Fate.drawn, milliseconds);
    for (const rival of rivals) {
      const start = performance.now();
      const hidden = rival.hide(model, this.#owners, {coarse, before: this.#before});
      const time = performance.now() - start;
      hold(rival.key, triangle => hidden[this.#owners[triangle]!] !== 0, time, hidden);
    }
    this.#before = shown;
    return caught;
  }

  /** Of what is hidden and shows, that which shows most, if that can be proved. */
  #confront(accused: AccusedKey, shown: Picture, isHidden: (triangle: number) => boolean, hidden?: Uint8Array): Catch | undefined {
    const pixelsOf = new Map<number, number[]>();
    shown.triangles.forEach((number, pixel) => {
      if (number === 0 || !isHidden(number - 1)) return;
      const object = this.#owners[number - 1]!, pixels = pixelsOf.get(object);
      if (pixels) pixels.push(pixel);
      else pixelsOf.set(object, [pixel]);
    });
    const worst = [...pixelsOf].sort(([, a], [, b]) => b.length - a.length);
    const tries = worst.flatMap(([object, pixels]) => middlesOf(pixels).map(pixel => ({object, pixels, pixel}))).slice(0, kMostTries);
    for (const {object, pixels, pixel} of tries) {
      const x = pixel % shown.width, y = Math.floor(pixel / shown.width), {camera} = shown;
      const proof = prove(this.#model, camera.eye, rayOf(shown, x, y), shown.triangles[pixel]! - 1);
      if (proof === undefined || !isInPicture(camera, proof.to)) continue;
      const at = [(x + 0.5) / shown.width, (y + 0.5) / shown.height] as const;
      return {accused, proof, object, pixels: pixels.length, at, camera, hidden, before: this.#before?.camera};
    }
    return undefined;
  }
}

/** Some that are likely to be in the middle of what shows. */
const middlesOf = (pixels: readonly number[]): number[] => [0.5, 0.25, 0.75, 0.1].map(share => pixels[Math.floor(share * pixels.length)]!);
