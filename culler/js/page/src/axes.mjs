// SPDX-License-Identifier: MIT
// The directions of cameras.
import {cross, dot, length, scale, subtract, unit} from "./points.mjs";

/** @import {Point} from "./points.mjs" */
/** @typedef {{readonly right: Point, readonly up: Point, readonly forward: Point}} Axes */

/**
 * Right, up and forward of a camera.
 * @param {{readonly eye: Point, readonly target: Point, readonly up: Point}} camera
 * @returns {Axes}
 */
export function axesOf({eye, target, up}) {
  const forward = unit(subtract(target, eye));
  const right = unit(cross(forward, up));
  return {right, up: cross(right, forward), forward};
}

/**
 * The directions in which headings are told: a full turn is about `up`.
 * @param {Point} up
 */
export function levelAxes(up) {
  /** @type {Point} */
  const helper = Math.abs(up[0]) < 0.9 * length(up) ? [1, 0, 0] : [0, 1, 0];
  const east = unit(subtract(helper, scale(up, dot(helper, up) / dot(up, up))));
  return {east, north: unit(cross(up, east)), up: unit(up)};
}
