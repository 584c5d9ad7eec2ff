// SPDX-License-Identifier: MIT
import {axesOf} from "./axes.mjs";
import type {Camera} from "./camera.mjs";
import type {Model} from "./model.mjs";
import {add, dot, scale, subtract, type Point} from "./points.mjs";
import {halfSizeOf} from "./projection.mjs";

/** Which triangle each pixel shows, from 1, row after row from below; 0: none. As the graphics card draws them, at the pixels' centres. */
export interface Picture {
  readonly triangles: Uint32Array;
  readonly width: number;
  readonly height: number;
  readonly camera: Camera;
}

/** Through the centre of a pixel: one unit long along the line of sight. */
export function rayOf({width, height, camera}: Picture, x: number, y: number): Point {
  const {right, up, forward} = axesOf(camera);
  const [wide, high] = halfSizeOf(camera);
  return add(forward, add(scale(right, ((2 * x + 1) / width - 1) * wide), scale(up, ((2 * y + 1) / height - 1) * high)));
}

/** Whether a point is certainly beyond the near plane and within the edges, with room for rounding. */
export function isInPicture(camera: Camera, point: Point): boolean {
  const {right, up, forward} = axesOf(camera), [wide, high] = halfSizeOf(camera), relative = subtract(point, camera.eye);
  const depth = dot(relative, forward) * (1 - 1e-9);
  return depth > camera.near && Math.abs(dot(relative, right)) < depth * wide && Math.abs(dot(relative, up)) < depth * high;
}

/** The distance along the line of sight of what each pixel shows, in single precision; infinite where there is nothing. */
export function depthsOf(picture: Picture, model: Model): Float32Array {
  const {triangles, width, height, camera} = picture;
  const {corners} = model, [ex, ey, ez] = camera.eye;
  const first = rayOf(picture, 0, 0), right = rayOf(picture, 1, 0), above = rayOf(picture, 0, 1);
  const depths = new Float32Array(width * height).fill(Infinity);
  for (let i = 0; i < depths.length; ++i) {
    const triangle = triangles[i]!;
    if (triangle === 0) continue;
    const at = 9 * (triangle - 1), x = i % width, y = (i - x) / width;
    const ax = corners[at]!, ay = corners[at + 1]!, az = corners[at + 2]!;
    const ux = corners[at + 3]! - ax, uy = corners[at + 4]! - ay, uz = corners[at + 5]! - az;
    const vx = corners[at + 6]! - ax, vy = corners[at + 7]! - ay, vz = corners[at + 8]! - az;
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const dx = first[0] + x * (right[0] - first[0]) + y * (above[0] - first[0]);
    const dy = first[1] + x * (right[1] - first[1]) + y * (above[1] - first[1]);
    const dz = first[2] + x * (right[2] - first[2]) + y * (above[2] - first[2]);
    depths[i] = (nx * (ax - ex) + ny * (ay - ey) + nz * (az - ez)) / (nx * dx + ny * dy + nz * dz);
  }
  return depths;
}
