// SPDX-License-Identifier: MIT
// Mouse, fingers and keys on the two views.
import type {App} from "./app.mjs";

const kRadiansOfPixel = 0.004;
/** Pixels: who moves less has clicked. */
const kStill = 5;

interface Pointer {
  x: number;
  y: number;
}

export function listen(app: App, onPick: (x: number, y: number) => void): void {
  const {canvas, walker, outside} = app;
  const pointers = new Map<number, Pointer>();
  let isOutside = false, travelled = 0;

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus();
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    travelled = pointers.size > 1 ? Infinity : 0;
    isOutside = app.viewAt(event.clientX, event.clientY).view === app.views.outside;
  });
  canvas.addEventListener("pointermove", event => {
    const pointer = pointers.get(event.pointerId);
    if (pointer === undefined) return;
    const before = {...pointer}, x = event.clientX - pointer.x, y = event.clientY - pointer.y;
    Object.assign(pointer, {x: event.clientX, y: event.clientY});
    travelled += Math.hypot(x, y);
    const other = [...pointers.values()].find(p => p !== pointer);
    if (travelled < kStill) return;
    if (isOutside) turnOutside(x, y, before, pointer, other);
    else walkOrLook(x, y, other !== undefined);
    app.wake();
  });
  for (const name of ["pointerup", "pointercancel"] as const) {
    canvas.addEventListener(name, event => {
      if (name === "pointerup" && pointers.has(event.pointerId) && travelled < kStill) onPick(event.clientX, event.clientY);
      pointers.delete(event.pointerId);
    });
  }
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    const factor = Math.exp(-event.deltaY * 0.0015);
    if (app.viewAt(event.clientX, event.clientY).view === app.views.outside) outside.zoom(1 / factor);
    else walker.speed *= factor;
    app.wake();
  }, {passive: false});
  addEventListener("keydown", event => {
    const isElsewhere = event.target instanceof HTMLElement && event.target.matches("input, select, button");
    if (event.ctrlKey || event.metaKey || event.altKey || isElsewhere || !walker.press(event.key)) return;
    event.preventDefault();
    takeOver();
  });
  addEventListener("keyup", event => walker.release(event.key));
  addEventListener("blur", () => walker.releaseAll());

  function turnOutside(x: number, y: number, before: Pointer, pointer: Pointer, other: Pointer | undefined): void {
    if (other === undefined) return outside.turn(-x * 0.006, y * 0.006);
    const away = (p: Pointer) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    outside.zoom(away(before) / away(pointer));
  }
  function walkOrLook(x: number, y: number, withTwo: boolean): void {
    takeOver();
    if (withTwo) walker.go([-x * walker.speed * 0.005, y * walker.speed * 0.005, 0]);
    else walker.look(x * kRadiansOfPixel, y * kRadiansOfPixel);
  }
  /** Who moves by hand flies no longer. */
  function takeOver(): void {
    if (app.isFlying) app.setFlying(false);
    app.forget();
  }
}
