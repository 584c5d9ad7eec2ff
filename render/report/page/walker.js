// SPDX-License-Identifier: MIT
// Walks with the camera of the frame: keys move, dragging looks around, the wheel changes the speed; on a phone one finger looks
// around and two move.

const kSteepest = 1.55;  // radians up or down: at the pole there is no right and left
const kRadiansOfPixel = 0.004;

/** What a key does: so much to the right, forward and up. */
const kKeysOfWalk = {
  w: [0, 1, 0], arrowup: [0, 1, 0], s: [0, -1, 0], arrowdown: [0, -1, 0], a: [-1, 0, 0], d: [1, 0, 0], q: [0, 0, -1], e: [0, 0, 1],
};
const kKeysOfTurn = {arrowleft: 1, arrowright: -1};

class WalkControl {
  /** `speed` in model units a second; `onMove` is called when there is something to do. */
  constructor(viewer, speed, onMove) {
    Object.assign(this, {viewer, speed, onMove, keys: new Set(), pointers: new Map()});
    const {canvas} = viewer;
    canvas.addEventListener('pointerdown', event => this.pointers.set(event.pointerId, [event.clientX, event.clientY]));
    canvas.addEventListener('pointermove', event => this.drag(event));
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, event => this.pointers.delete(event.pointerId));
    canvas.addEventListener('wheel', event => {
      if (!this.isWalking) return;
      event.preventDefault();
      this.speed *= Math.exp(-event.deltaY * 0.0015);
    }, {passive: false});
    addEventListener('keydown', event => this.press(event));
    addEventListener('keyup', event => this.keys.delete(event.key.toLowerCase()));
    addEventListener('blur', () => this.keys.clear());
  }

  get isWalking() {
    return !this.viewer.isOutside;
  }

  /** Stands at `eye` and looks to `target`. */
  place(eye, target) {
    const {east, north, up} = levelAxes(this.viewer.lens.up);
    const forward = unit(subtract(target, eye));
    this.eye = eye;
    this.yaw = Math.atan2(dot(forward, north), dot(forward, east));
    this.pitch = Math.asin(Math.min(1, Math.max(-1, dot(forward, up))));
    this.target = target;
    if (Math.abs(this.pitch) > kSteepest) this.look(0, 0);
  }

  /** Moves on by the keys that are held down; returns whether any is. */
  advance(seconds) {
    const pressed = [...this.keys];
    const move = pressed.map(key => kKeysOfWalk[key]).filter(m => m).reduce(add, [0, 0, 0]);
    const turn = pressed.reduce((sum, key) => sum + (kKeysOfTurn[key] ?? 0), 0);
    if (!this.isWalking || (turn === 0 && length(move) === 0)) return false;
    if (turn !== 0) this.look(1.2 * turn * seconds, 0);
    this.go(scale(move, this.speed * (this.keys.has('shift') ? 5 : 1) * seconds));
    return true;
  }

  look(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.min(kSteepest, Math.max(-kSteepest, this.pitch + pitch));
    this.aim();
  }
  /** By so much to the right, forward and up. */
  go([right, forward, up]) {
    const axes = axesOf({eye: this.eye, target: this.target, up: this.viewer.lens.up});
    this.eye = [scale(axes.right, right), scale(axes.forward, forward), scale(unit(this.viewer.lens.up), up)].reduce(add, this.eye);
    this.aim();
  }
  aim() {
    const {east, north, up} = levelAxes(this.viewer.lens.up);
    const level = add(scale(east, Math.cos(this.yaw)), scale(north, Math.sin(this.yaw)));
    this.target = add(this.eye, add(scale(level, Math.cos(this.pitch)), scale(up, Math.sin(this.pitch))));
    this.onMove();
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before || !this.isWalking) return;
    const x = event.clientX - before[0], y = event.clientY - before[1];
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.pointers.size === 1) this.look(x * kRadiansOfPixel, y * kRadiansOfPixel);
    else this.go([-x, y, 0].map(pixels => pixels * this.speed * 0.01));
  }

  press(event) {
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey || event.altKey || !this.isWalking) return;
    if (event.target.closest?.('input, select') && key.startsWith('arrow')) return;
    if (!(key in kKeysOfWalk) && !(key in kKeysOfTurn) && key !== 'shift') return;
    if (key !== 'shift') event.preventDefault();
    this.keys.add(key);
    this.onMove();
  }
}
