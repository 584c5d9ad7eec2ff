// SPDX-License-Identifier: MIT
import type {Place} from "./camera.mjs";
import type {Point} from "./points.mjs";

/** A camera of the file. */
export interface NamedPlace extends Place {
  readonly name: string;
}

/** A way through a model: as long as it takes, in seconds. */
export interface Flight {
  readonly places: readonly Place[];
  readonly seconds: number;
}

/** What all cameras share: degrees, and where pictures begin. */
export interface Lens {
  readonly fovY: number;
  readonly near: number;
}

/** Triangles that stand still, in single precision: these numbers are the model, for whoever draws, culls and proves. */
export interface Model {
  readonly name: string;
  /** Where the file has what is 0 here: not 0 itself where a model is far from that, as single precision has few digits. */
  readonly origin: Point;
  /** Nine numbers of each triangle. */
  readonly corners: Float32Array<ArrayBuffer>;
  /** Of each corner red, green and blue, and 255 or, if light comes through, 0. */
  readonly colours: Uint8Array<ArrayBuffer>;
  /** The first triangle of each object, and the number of all. An object is what engines cull as a whole: some triangles and a box. */
  readonly firsts: Uint32Array<ArrayBuffer>;
  readonly names: readonly string[];
  /** What each triangle is of the file: a polygon as the command counts them, or a triangle of its mesh. */
  readonly facet: "polygon" | "triangle";
  readonly numbers: Uint32Array<ArrayBuffer>;
  /** Six numbers of each object. */
  readonly boxes: Float64Array<ArrayBuffer>;
  readonly box: {readonly low: Point; readonly high: Point; readonly size: number};
  readonly up: Point;
  /** Whether the file has colours. */
  readonly isColoured: boolean;
  readonly cameras: readonly NamedPlace[];
  readonly lens: Lens;
  readonly flight: Flight;
}

export const triangleCount = (model: Model): number => model.corners.length / 9;
export const objectCount = (model: Model): number => model.firsts.length - 1;
export const isSeeThrough = (model: Model, triangle: number): boolean => model.colours[12 * triangle + 3] === 0;

/** What a triangle is called in the file. */
export const facetOf = ({facet, numbers}: Model, triangle: number): string => `${facet} ${numbers[triangle]!}`;

export function cornerOf(model: Model, triangle: number, corner: number): Point {
  const at = 9 * triangle + 3 * corner;
  return [model.corners[at]!, model.corners[at + 1]!, model.corners[at + 2]!];
}

/** The object of each triangle. */
export function ownersOf(model: Model): Uint32Array<ArrayBuffer> {
  const owners = new Uint32Array(triangleCount(model));
  for (let o = 0; o < objectCount(model); ++o) owners.fill(o, model.firsts[o]!, model.firsts[o + 1]!);
  return owners;
}
