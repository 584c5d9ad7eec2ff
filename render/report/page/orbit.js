// SPDX-License-Identifier: MIT
// Moves the camera outside: drag turns, shift or the right button or two fingers move, the wheel or a pinch zooms. A click
// that does not move is a click.

const kLeastPitch = -1.5, kMostPitch = 1.55;

class OrbitControl {
  constructor(viewer, onClick) {
    this.viewer = viewer;
    this.onClick = onClick;
    this.pointers = new Map();
    const {canvas} = viewer;
    canvas.addEventListener('pointerdown', event => this.down(event));
    canvas.addEventListener('pointermove', event => this.move(event));
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, event => this.up(event));
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
      if (!viewer.isOutside) return;
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.0015));
    }, {passive: false});
    canvas.addEventListener('keydown', event => this.key(event));
  }

  /** The viewer, whose camera outside no longer follows that of the frames. */
  taken() {
    this.viewer.isFollowing = false;
    return this.viewer;
  }
  turn(yaw, pitch) {
    const {orbit} = this.taken();
    orbit.yaw += yaw;
    orbit.pitch = Math.min(kMostPitch, Math.max(kLeastPitch, orbit.pitch + pitch));
    this.viewer.invalidate();
  }
  zoom(factor) {
    const {orbit, size} = this.taken();
    orbit.distance = Math.min(4 * size, Math.max(size * 1e-5, orbit.distance * factor));
    this.viewer.invalidate();
  }
  /** By pixels of the canvas. */
  shift(x, y) {
    const {orbit, canvas} = this.taken();
    const {right, up} = axesOf(this.viewer.outside());
    const unitOfPixel = orbit.distance / canvas.clientHeight;
    orbit.centre = add(orbit.centre, add(scale(right, -x * unitOfPixel), scale(up, y * unitOfPixel)));
    this.viewer.invalidate();
  }

  down(event) {
    this.viewer.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    this.travelled = this.pointers.size > 1 ? Infinity : 0;
  }
  move(event) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const x = event.clientX - pointer.x, y = event.clientY - pointer.y;
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
    const before = {...pointer};
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    this.travelled += Math.hypot(x, y);
    if (!this.viewer.isOutside) return;
    if (others.length > 0) {
      const away = p => Math.hypot(p.x - others[0].x, p.y - others[0].y);
      this.zoom(Math.max(1, away(before)) / Math.max(1, away(pointer)));
      this.shift(x / 2, y / 2);
    } else if (event.shiftKey || event.buttons & 2) {
      this.shift(x, y);
    } else {
      this.turn(-x * 0.006, y * 0.006);
    }
  }
  up(event) {
    const kStill = 5;  // pixels
    if (event.type === 'pointerup' && this.pointers.has(event.pointerId) && this.travelled < kStill) {
      const box = this.viewer.canvas.getBoundingClientRect();
      this.onClick(event.clientX - box.left, event.clientY - box.top);
    }
    this.pointers.delete(event.pointerId);
  }
  key(event) {
    if (!this.viewer.isOutside || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 0.08;
    const actions = {a: () => this.turn(-step, 0), d: () => this.turn(step, 0), w: () => this.turn(0, step), s: () => this.turn(0, -step),
                     '+': () => this.zoom(0.9), '-': () => this.zoom(1.1)};
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
