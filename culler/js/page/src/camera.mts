// SPDX-License-Identifier: MIT
import type {LookAtCamera} from "occlude";

import {axesOf} from "./axes.mjs";
import {add, scale, type Point} from "./points.mjs";

/** Where somebody stands, and where they look. */
export interface Place {
  readonly eye: Point;
  readonly target: Point;
}

/** The same from somewhere else. */
export const moved = ({eye, target}: Place, by: Point): Place => ({eye: add(eye, by), target: add(target, by)});

/** A camera of the culler that has said all that a picture needs. It has no far plane. */
export interface Camera extends Place, LookAtCamera {
  readonly eye: Point;
  readonly target: Point;
  readonly up: Point;
  readonly fovY: number;
  readonly aspect: number;
  readonly near: number;
}

/** Half of the picture's width and height, one unit before the eye. */
export function halfSizeOf({fovY, aspect}: Camera): readonly [number, number] {
  const height = Math.tan((fovY * Math.PI) / 360);
  return [height * aspect, height];
}

/** From the eye through a point of the picture, x and y from -1 to 1: one unit long along the line of sight. */
export function rayThrough(camera: Camera, x: number, y: number): Point {
  const {right, up, forward} = axesOf(camera);
  const [width, height] = halfSizeOf(camera);
  return add(forward, add(scale(right, x * width), scale(up, y * height)));
}

/**
 * From what is relative to the eye to the picture, column after column. Nothing is far: depth is told by the shader, which has the
 * distance along the line of sight in w.
 */
export function projectionOf(camera: Camera): Float32Array<ArrayBuffer> {
  const {right, up, forward} = axesOf(camera);
  const [width, height] = halfSizeOf(camera);
  const rows = [scale(right, 1 / width), scale(up, 1 / height), forward, forward];
  const matrix = new Float32Array(16);
  rows.forEach((row, r) => row.forEach((value, column) => (matrix[4 * column + r] = value)));
  matrix[14] = -2 * camera.near; // -w <= z is where the near plane is
  return matrix;
}
