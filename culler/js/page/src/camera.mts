// SPDX-License-Identifier: MIT
import type {LookAtCamera} from "occlude";

import {axesOf} from "./axes.mjs";
import {add, scale, type Point} from "./points.mjs";
import {halfSizeOf} from "./projection.mjs";

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

/** From the eye through a point of the picture, x and y from -1 to 1: one unit long along the line of sight. */
export function rayThrough(camera: Camera, x: number, y: number): Point {
  const {right, up, forward} = axesOf(camera);
  const [width, height] = halfSizeOf(camera);
  return add(forward, add(scale(right, x * width), scale(up, y * height)));
}
