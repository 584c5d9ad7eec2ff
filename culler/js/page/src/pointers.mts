// SPDX-License-Identifier: MIT
// Mouse, fingers and keys on the two views.
import type {App} from "./app.mjs";
import {takeGestures} from "./gestures.mjs";

const kRadiansOfPixel = 0.004;
/** From outside, where what is far turns as well. */
const kRadiansOfPixelOutside = 0.006;
/** Seconds of a walk, for two fingers. */
const kSecondsOfPixel = 0.01;

export function listen(app: App, onPick: (x: number, y: number) => void): void {
  const {canvas, walker, outside} = app;
  let isOutside = false;

  takeGestures(canvas, {
    onClick: onPick,
    onStart: (x, y) => (isOutside = app.viewAt(x, y).view === app.views.outside),
    onDrag(x, y, isAside) {
      if (isOutside && isAside) shiftOutside(x, y);
      else if (isOutside) outside.turn(-x * kRadiansOfPixelOutside, y * kRadiansOfPixelOutside);
      else takeOver(() => walker.look(x * kRadiansOfPixel, y * kRadiansOfPixel));
      app.wake();
    },
    onPinch(x, y, factor) {
      if (isOutside) {
        outside.zoom(1 / factor);
        shiftOutside(x, y);
      } else takeOver(() => walker.go([-x * walker.speed * kSecondsOfPixel, y * walker.speed * kSecondsOfPixel, 0]));
      app.wake();
    },
    onWheel(factor, x, y) {
      if (app.viewAt(x, y).view === app.views.outside) outside.zoom(1 / factor);
      else walker.speed *= factor;
      app.wake();
      return true;
    },
  });
  addEventListener("keydown", event => {
    const isElsewhere = event.target instanceof HTMLElement && event.target.matches("input, select, button");
    if (event.ctrlKey || event.metaKey || event.altKey || isElsewhere || !walker.press(event.key)) return;
    event.preventDefault();
    takeOver(() => {});
  });
  addEventListener("keyup", event => walker.release(event.key));
  addEventListener("blur", () => walker.releaseAll());

  function shiftOutside(x: number, y: number): void {
    const {outside: view, ratio} = app.views;
    if (view) outside.shift(app.camera, (x * ratio) / view.height, (-y * ratio) / view.height);
  }
  /** Who moves by hand flies no longer. */
  function takeOver(move: () => void): void {
    move();
    if (app.isFlying) app.setFlying(false);
    app.forget();
  }
}
