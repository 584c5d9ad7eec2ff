// SPDX-License-Identifier: MIT
// What mouse and fingers do on a picture.

/** Pixels: who moves less has clicked. */
const kStill = 5;
/** So much of a turn of the wheel doubles about: 460 of its units, four to five notches. */
const kFactorOfWheel = 0.0015;

/**
 * @typedef {object} Taker Whoever does something with it. Places and ways are pixels of the page.
 * @property {(x: number, y: number) => void} onClick
 * @property {(x: number, y: number) => void} [onStart] The first finger, or a button, comes down.
 * @property {(x: number, y: number, isAside: boolean) => void} onDrag By so much; aside: with shift or the right button.
 * @property {(x: number, y: number, factor: number) => void} onPinch Two fingers move by so much, and are that much farther apart.
 * @property {(factor: number, x: number, y: number) => boolean} onWheel Returns whether it was taken.
 */

/**
 * @param {HTMLElement} element
 * @param {Taker} taker
 */
export function takeGestures(element, {onClick, onStart, onDrag, onPinch, onWheel}) {
  /** @type {Map<number, {x: number, y: number}>} */
  const pointers = new Map();
  let travelled = 0;

  element.addEventListener("pointerdown", event => {
    element.setPointerCapture(event.pointerId);
    element.focus({preventScroll: true});
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    travelled = pointers.size > 1 ? Infinity : 0;
    if (pointers.size === 1) onStart?.(event.clientX, event.clientY);
  });
  element.addEventListener("pointermove", event => {
    const pointer = pointers.get(event.pointerId);
    if (pointer === undefined) return;
    const before = {...pointer}, x = event.clientX - pointer.x, y = event.clientY - pointer.y;
    Object.assign(pointer, {x: event.clientX, y: event.clientY});
    travelled += Math.hypot(x, y);
    if (travelled < kStill) return;
    const other = [...pointers.values()].find(p => p !== pointer);
    if (other === undefined) return onDrag(x, y, event.shiftKey || (event.buttons & 2) !== 0);
    /** @param {{x: number, y: number}} p */
    const away = p => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    onPinch(x / 2, y / 2, away(pointer) / away(before)); // each finger is half of what moves
  });
  for (const name of /** @type {const} */ (["pointerup", "pointercancel"])) {
    element.addEventListener(name, event => {
      if (name === "pointerup" && pointers.has(event.pointerId) && travelled < kStill) onClick(event.clientX, event.clientY);
      pointers.delete(event.pointerId);
    });
  }
  element.addEventListener("contextmenu", event => event.preventDefault());
  element.addEventListener("wheel", event => {
    if (onWheel(Math.exp(-event.deltaY * kFactorOfWheel), event.clientX, event.clientY)) event.preventDefault();
  }, {passive: false});
}
