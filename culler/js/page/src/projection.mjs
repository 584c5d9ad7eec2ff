// SPDX-License-Identifier: MIT
// What cameras see, and how that comes into a picture.
import {axesOf} from "./axes.mjs";
import {add, scale} from "./points.mjs";

/** @import {Point} from "./points.mjs" */
/** @typedef {{readonly eye: Point, readonly target: Point, readonly up: Point, readonly aspect: number, readonly near: number}} Aimed */
/** @typedef {{readonly fovY: number, readonly far?: number}} Spread Degrees from the lowest to the highest ray. */
/** @typedef {{readonly fovY?: undefined, readonly height: number, readonly far: number}} Parallel What they see is so high. */
/** @typedef {Spread | Parallel} Rays */
/** @typedef {Aimed & Rays} Seeing */

/** The whole picture: it reaches from -1 to 1 on both axes. */
const kWhole = {x: 0, y: 0, across: 1, up: 1};

/**
 * Half of the picture's width and height, so far from the eye.
 * @param {Pick<Aimed, "aspect"> & Rays} camera
 * @param {number} [away]
 * @returns {readonly [number, number]}
 */
export function halfSizeOf(camera, away = 1) {
  const half = camera.fovY === undefined ? camera.height / 2 : away * Math.tan((camera.fovY * Math.PI) / 360);
  return [half * camera.aspect, half];
}

/**
 * The corners of what the camera sees so far from the eye, counter-clockwise from the lower left.
 * @param {Seeing} camera
 * @param {number} away
 */
export function cornersOf(camera, away) {
  const {right, up, forward} = axesOf(camera), [wide, high] = halfSizeOf(camera, away);
  const middle = add(camera.eye, scale(forward, away));
  return /** @type {const} */ ([[-1, -1], [1, -1], [1, 1], [-1, 1]]).map(
    ([x, y]) => add(middle, add(scale(right, x * wide), scale(up, y * high))));
}

/**
 * From what is relative to the eye to the picture, column after column; w is the distance along the line of sight, or 1 of parallel rays.
 * Depth is told by the shader (programs.mjs). A window is a part of the picture: its middle, and by how much it is magnified.
 * @param {Seeing} camera
 * @param {typeof kWhole} [window]
 */
export function projectionOf(camera, window = kWhole) {
  const {right, up, forward} = axesOf(camera), [wide, high] = halfSizeOf(camera);
  const {near, far = Infinity} = camera, share = near / far;
  const rows = camera.fovY === undefined
    ? [[...scale(forward, 2 / (far - near)), -(far + near) / (far - near)], [0, 0, 0, 1]]
    : [[...scale(forward, (1 + share) / (1 - share)), (-2 * near) / (1 - share)], [...forward, 0]];
  const [depth, w] = /** @type {[number[], number[]]} */ (rows);
  /** @type {(row: Point, middle: number, magnified: number) => number[]} */
  const inWindow = (row, middle, magnified) => [...row, 0].map((c, i) => magnified * (c - middle * /** @type {number} */ (w[i])));
  const all = [inWindow(scale(right, 1 / wide), window.x, window.across), inWindow(scale(up, 1 / high), window.y, window.up), depth, w];
  return new Float32Array([0, 1, 2, 3].flatMap(column => all.map(row => /** @type {number} */ (row[column]))));
}
