// SPDX-License-Identifier: MIT
// Points and vectors in doubles.

/** @typedef {readonly [number, number, number]} Point */

/** @type {(a: Point, b: Point) => Point} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @type {(a: Point, b: Point) => Point} */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @type {(a: Point, by: number) => Point} */
export const scale = (a, by) => [a[0] * by, a[1] * by, a[2] * by];
/** @type {(a: Point, b: Point) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(a: Point, b: Point) => Point} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: Point) => number} */
export const length = a => Math.hypot(...a);
/** @type {(a: Point) => Point} */
export const unit = a => scale(a, 1 / length(a));
/** @type {(a: Point, b: Point) => number} */
export const distance = (a, b) => length(subtract(a, b));
/** @type {(a: Point, b: Point, share: number) => Point} */
export const mix = (a, b, share) => add(scale(a, 1 - share), scale(b, share));
