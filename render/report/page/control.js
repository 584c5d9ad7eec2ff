// SPDX-License-Identifier: MIT
// Moves the camera outside: drag turns, shift or the right button or two fingers move, the wheel or a pinch zooms.

const kRadiansOfPixel = 0.006;

class OrbitControl {
  /** `onClick` takes a point of the canvas, in its CSS pixels. */
  constructor(viewer, onClick) {
    this.viewer = viewer;
    const {canvas} = viewer;
    takeGestures(canvas, {
      onClick: (x, y) => {
        const box = canvas.getBoundingClientRect();
        onClick(x - box.left, y - box.top);
      },
      onDrag: (x, y, isAside) => this.move(orbit => isAside ? this.shift(x, y) : orbit.turn(-x * kRadiansOfPixel, y * kRadiansOfPixel)),
      onPinch: (x, y, factor) => this.move(orbit => {
        orbit.zoom(1 / factor);
        this.shift(x, y);
      }),
      onWheel: factor => this.move(orbit => orbit.zoom(1 / factor)),
    });
    canvas.addEventListener('keydown', event => this.key(event));
  }

  /** Moves what no longer follows the camera of the frames; returns whether one looks from outside. */
  move(action) {
    const {orbit, isOutside} = this.viewer;
    if (!isOutside) return false;
    orbit.isFollowing = false;
    action(orbit);
    this.viewer.seeSoon();
    this.viewer.invalidate();
    return true;
  }
  /** By pixels of the canvas. */
  shift(x, y) {
    const {orbit, camera, canvas} = this.viewer;
    orbit.shift(camera, x / canvas.clientHeight, -y / canvas.clientHeight);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 0.08;
    const turns = {a: [-step, 0], d: [step, 0], w: [0, step], s: [0, -step]}, zooms = {'+': 0.9, '-': 1.1};
    const key = event.key.toLowerCase();
    if (!(key in turns) && !(key in zooms)) return;
    if (this.move(orbit => key in turns ? orbit.turn(...turns[key]) : orbit.zoom(zooms[key]))) event.preventDefault();
  }
}
