// SPDX-License-Identifier: MIT
import {axesOf, type Axes} from "./axes.mjs";
import type {Model} from "./model.mjs";
import {dot, subtract, type Point} from "./points.mjs";
import {depthsOf, type Picture} from "./picture.mjs";
import {halfSizeOf} from "./projection.mjs";

interface Level {
  readonly depths: Float32Array;
  readonly width: number;
  readonly height: number;
}

/** Whether boxes are behind what a picture shows, as engines ask: from a pyramid of the greatest depths, in single precision. */
export class DepthPyramid {
  readonly #picture: Picture;
  readonly #axes: Axes;
  readonly #levels: Level[];

  constructor(picture: Picture, model: Model) {
    this.#picture = picture;
    this.#axes = axesOf(picture.camera);
    this.#levels = [{depths: depthsOf(picture, model), width: picture.width, height: picture.height}];
    for (let level = this.#levels[0]!; level.width > 1 || level.height > 1;) {
      level = halved(level);
      this.#levels.push(level);
    }
  }

  /** Of the box of an object: out of the picture and what comes too near are not hidden. */
  hides(boxes: Float64Array, object: number): boolean {
    const {camera, width, height} = this.#picture;
    const {right, up, forward} = this.#axes, [wide, high] = halfSizeOf(camera);
    let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity, nearest = Infinity;
    for (let corner = 0; corner < 8; ++corner) {
      const relative = subtract(cornerOfBox(boxes, object, corner), camera.eye), depth = Math.fround(dot(relative, forward));
      if (depth < camera.near) return false;
      const x = Math.fround(((dot(relative, right) / (depth * wide) + 1) * width) / 2);
      const y = Math.fround(((dot(relative, up) / (depth * high) + 1) * height) / 2);
      x0 = Math.min(x0, x);
      x1 = Math.max(x1, x);
      y0 = Math.min(y0, y);
      y1 = Math.max(y1, y);
      nearest = Math.min(nearest, depth);
    }
    if (x1 <= 0 || y1 <= 0 || x0 >= width || y0 >= height) return false;
    return nearest > this.#farthestIn(Math.max(x0, 0), Math.max(y0, 0), Math.min(x1, width), Math.min(y1, height));
  }

  /** Of a rectangle, in the first level where it is at most two pixels wide and high, or three where it lies badly. */
  #farthestIn(x0: number, y0: number, x1: number, y1: number): number {
    const number = Math.min(this.#levels.length - 1, Math.max(0, Math.ceil(Math.log2(Math.max(x1 - x0, y1 - y0) / 2))));
    const {depths, width, height} = this.#levels[number]!, size = 2 ** number;
    const last = (edge: number, count: number) => Math.min(count - 1, Math.floor(edge / size));
    let farthest = 0;
    for (let y = Math.floor(y0 / size); y <= last(y1, height); ++y) {
      for (let x = Math.floor(x0 / size); x <= last(x1, width); ++x) farthest = Math.max(farthest, depths[y * width + x]!);
    }
    return farthest;
  }
}

function cornerOfBox(boxes: Float64Array, object: number, corner: number): Point {
  const at = 6 * object;
  return [boxes[at + (corner & 1 ? 3 : 0)]!, boxes[at + (corner & 2 ? 4 : 1)]!, boxes[at + (corner & 4 ? 5 : 2)]!];
}

function halved({depths, width, height}: Level): Level {
  const wide = Math.ceil(width / 2), high = Math.ceil(height / 2);
  const smaller = new Float32Array(wide * high);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const at = (y >> 1) * wide + (x >> 1);
      smaller[at] = Math.max(smaller[at]!, depths[y * width + x]!);
    }
  }
  return {depths: smaller, width: wide, height: high};
}
