// SPDX-License-Identifier: MIT
// Where the two views are on the canvas.
import {byId} from "./elements.mjs";
import type {Viewport} from "./painter.mjs";

/** More pixels would only take time. */
const kMostPixelRatio = 2;

export interface Views {
  readonly eye: Viewport;
  readonly outside: Viewport | undefined;
  /** Pixels of the canvas in one of the page. */
  readonly ratio: number;
}

/** Side by side, or one above the other on a screen that stands. */
export function viewsOf(canvas: HTMLCanvasElement, showsOutside: boolean): Views {
  const ratio = Math.min(devicePixelRatio, kMostPixelRatio);
  const width = Math.max(2, Math.round(canvas.clientWidth * ratio)), height = Math.max(2, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
  if (!showsOutside) return {eye: {x: 0, y: 0, width, height}, outside: undefined, ratio};
  if (width > height) {
    const left = Math.round(0.6 * width);
    return {eye: {x: 0, y: 0, width: left, height}, outside: {x: left, y: 0, width: width - left, height}, ratio};
  }
  const above = Math.round(0.54 * height);
  return {eye: {x: 0, y: height - above, width, height: above}, outside: {x: 0, y: 0, width, height: height - above}, ratio};
}

/** Puts an element over a part of the canvas. */
export function cover(element: HTMLElement, {x, y, width, height}: Viewport, {ratio}: Views, canvas: HTMLCanvasElement): void {
  const px = (pixels: number) => `${pixels / ratio}px`;
  Object.assign(element.style, {left: px(x), top: px(canvas.height - y - height), width: px(width), height: px(height)});
}

/** The line between the views, and what the other one is. */
export function showSplit(views: Views, canvas: HTMLCanvasElement): void {
  const {eye, outside} = views, split = byId("split"), name = byId("outside-name");
  split.hidden = name.hidden = outside === undefined;
  if (outside === undefined) return;
  const isBeside = outside.x > 0, thin = 2 * views.ratio;
  const line = isBeside ? {...outside, x: outside.x - thin / 2, width: thin} : {...eye, y: eye.y - thin / 2, height: thin};
  cover(split, line, views, canvas);
  cover(name, outside, views, canvas);
  Object.assign(name.style, {width: "auto", height: "auto"});
}
