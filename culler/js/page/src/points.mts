// SPDX-License-Identifier: MIT
// Points and vectors in doubles.

export type Point = readonly [number, number, number];

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Point, by: number): Point => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Point): number => Math.hypot(...a);
export const unit = (a: Point): Point => scale(a, 1 / length(a));
export const distance = (a: Point, b: Point): number => length(subtract(a, b));
export const mix = (a: Point, b: Point, share: number): Point => add(scale(a, 1 - share), scale(b, share));
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
