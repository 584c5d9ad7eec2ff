// SPDX-License-Identifier: MIT
// Puts models together, object by object.
import {metreOf} from "./metre.mjs";
import type {Flight, Model} from "./model.mjs";
import {distance, type Point} from "./points.mjs";

/** Objects with more triangles are cut into pieces that are near each other: engines do, as nothing large is ever hidden. */
const kMostOfObject = 256;

export type Colour = readonly [number, number, number];

const counted = (_: unknown, i: number) => i;

/** What is known of a model beside its triangles, and what may be; the flight depends on the box of them. */
export type Known = Pick<Model, "name" | "up" | "isColoured" | "cameras"> & Partial<Pick<Model, "origin" | "facet" | "lens">> & {
  flightIn: (box: Model["box"]) => Flight;
};

export class Builder {
  readonly #pieces: {name: string; corners: Float32Array; colours: Uint8Array; numbers: Uint32Array}[] = [];

  /** Nine numbers of each triangle, four of the colours of each corner, and what each triangle is called in the file. */
  add(name: string, corners: Float32Array, colours: Uint8Array, numbers = Uint32Array.from({length: corners.length / 9}, counted)): void {
    const count = corners.length / 9;
    if (count === 0) return;
    if (count <= kMostOfObject) {
      this.#pieces.push({name, corners, colours, numbers});
      return;
    }
    const order = orderOfNearness(corners);
    const pieces = Math.ceil(count / kMostOfObject);
    for (let p = 0; p < pieces; ++p) {
      const part = order.subarray(Math.floor((count * p) / pieces), Math.floor((count * (p + 1)) / pieces));
      this.#pieces.push({
        name: `${name}, part ${p + 1}`,
        corners: gather(corners, part, 9),
        colours: gather(colours, part, 12),
        numbers: gather(numbers, part, 1),
      });
    }
  }

  get isEmpty(): boolean {
    return this.#pieces.length === 0;
  }

  model({flightIn, ...known}: Known): Model {
    const firsts = new Uint32Array(this.#pieces.length + 1);
    this.#pieces.forEach(({corners}, i) => (firsts[i + 1] = firsts[i]! + corners.length / 9));
    const count = firsts.at(-1)!;
    const corners = new Float32Array(9 * count), colours = new Uint8Array(12 * count), boxes = new Float64Array(6 * this.#pieces.length);
    const numbers = new Uint32Array(count);
    this.#pieces.forEach((piece, i) => {
      corners.set(piece.corners, 9 * firsts[i]!);
      colours.set(piece.colours, 12 * firsts[i]!);
      numbers.set(piece.numbers, firsts[i]!);
      boxes.set(boxOf(piece.corners), 6 * i);
    });
    const [x0, y0, z0, x1, y1, z1] = boxOfBoxes(boxes);
    const low: Point = [x0!, y0!, z0!], high: Point = [x1!, y1!, z1!];
    const box = {low, high, size: distance(low, high)};
    const {origin = [0, 0, 0], facet = "triangle", lens = {fovY: 60, near: 0.1 * metreOf(box.size)}} = known, flight = flightIn(box);
    const names = this.#pieces.map(piece => piece.name);
    return {...known, origin, facet, lens, corners, colours, numbers, firsts, names, boxes, box, flight};
  }
}

export const emptyBox = () => [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

/** Six numbers of what holds all points, three numbers each. */
export function boxOf(points: ArrayLike<number>): number[] {
  const box = emptyBox();
  for (let i = 0; i < points.length; ++i) {
    const axis = i % 3, value = points[i]!;
    if (value < box[axis]!) box[axis] = value;
    if (value > box[axis + 3]!) box[axis + 3] = value;
  }
  return box;
}

function boxOfBoxes(boxes: Float64Array): number[] {
  const all = emptyBox();
  for (let i = 0; i < boxes.length; ++i) all[i % 6] = (i % 6 < 3 ? Math.min : Math.max)(all[i % 6]!, boxes[i]!);
  return all;
}

/** Of a list with so many numbers for each thing those of some things. */
export function gather<Numbers extends Float32Array | Uint8Array | Uint32Array>(from: Numbers, which: Uint32Array, size: number): Numbers {
  const part = from.slice(0, size * which.length) as Numbers;
  which.forEach((w, i) => part.set(from.subarray(size * w, size * w + size), size * i));
  return part;
}

/** The triangles along a curve (Morton's) that stays in one place for long. */
function orderOfNearness(corners: Float32Array): Uint32Array {
  const count = corners.length / 9, box = boxOf(corners);
  // Ten bits of each axis, and below them the triangle's number: exact in a double up to 2^23 triangles.
  const keys = new Float64Array(count);
  const cells = [0, 1, 2].map(axis => 1023.999 / Math.max(box[axis + 3]! - box[axis]!, Number.MIN_VALUE * 2 ** 60));
  for (let t = 0; t < count; ++t) {
    let key = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const middle = (corners[9 * t + axis]! + corners[9 * t + 3 + axis]! + corners[9 * t + 6 + axis]!) / 3;
      const cell = Math.floor((middle - box[axis]!) * cells[axis]!);
      key |= spread(Math.min(1023, Math.max(0, cell))) << axis;
    }
    keys[t] = key * 2 ** 23 + t;
  }
  keys.sort();
  return Uint32Array.from(keys, key => key % 2 ** 23);
}

/** Two bits free after each of ten bits. */
function spread(bits: number): number {
  let b = bits;
  b = (b | (b << 16)) & 0x030000ff;
  b = (b | (b << 8)) & 0x0300f00f;
  b = (b | (b << 4)) & 0x030c30c3;
  return (b | (b << 2)) & 0x09249249;
}
