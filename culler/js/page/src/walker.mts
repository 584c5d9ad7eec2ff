// SPDX-License-Identifier: MIT
// Walks: keys move, dragging looks around, the wheel changes the speed; on a phone one finger looks around and two move.
import {levelAxes} from "./axes.mjs";
import type {Place} from "./camera.mjs";
import {add, cross, dot, scale, subtract, unit, type Point} from "./points.mjs";

/** Radians up or down: at the pole there is no right and left. */
const kSteepest = 1.55;

/** What a key does: so much to the right, forward and up. */
const moves: Record<string, Point> = {
  w: [0, 1, 0], arrowup: [0, 1, 0], s: [0, -1, 0], arrowdown: [0, -1, 0], a: [-1, 0, 0], d: [1, 0, 0], q: [0, 0, -1], e: [0, 0, 1],
};
const turns: Record<string, number> = {arrowleft: 1, arrowright: -1};

export class Walker {
  readonly #keys = new Set<string>();
  #eye: Point = [0, 0, 0];
  #yaw = 0;
  #pitch = 0;
  /** Units a second. */
  speed = 3;
  up: Point = [0, 0, 1];

  get place(): Place {
    return {eye: this.#eye, target: add(this.#eye, this.#forward())};
  }
  set place({eye, target}: Place) {
    const {east, north, up} = levelAxes(this.up), forward = unit(subtract(target, eye));
    this.#eye = eye;
    this.#yaw = Math.atan2(dot(forward, north), dot(forward, east));
    this.#pitch = clampPitch(Math.asin(Math.min(1, Math.max(-1, dot(forward, up)))));
  }

  /** Moves on by the keys that are held down; returns whether any is. */
  advance(seconds: number): boolean {
    const pressed = [...this.#keys];
    const move = pressed.flatMap(key => (moves[key] ? [moves[key]] : [])).reduce(add, [0, 0, 0] as Point);
    const turn = pressed.reduce((sum, key) => sum + (turns[key] ?? 0), 0);
    this.look(1.2 * turn * seconds, 0);
    this.go(scale(move, this.speed * (this.#keys.has("shift") ? 5 : 1) * seconds));
    return turn !== 0 || move.some(x => x !== 0);
  }

  look(yaw: number, pitch: number): void {
    this.#yaw += yaw;
    this.#pitch = clampPitch(this.#pitch + pitch);
  }

  /** By so much to the right, forward and up. */
  go([right, forward, up]: Point): void {
    const ahead = this.#forward(), aside = unit(cross(ahead, this.up));
    this.#eye = [scale(aside, right), scale(ahead, forward), scale(unit(this.up), up)].reduce(add, this.#eye);
  }

  /** Takes a key, if it is one of those that move. */
  press(key: string): boolean {
    const known = key.toLowerCase();
    if (!(known in moves) && !(known in turns) && known !== "shift") return false;
    this.#keys.add(known);
    return known !== "shift";
  }
  release(key: string): void {
    this.#keys.delete(key.toLowerCase());
  }
  releaseAll(): void {
    this.#keys.clear();
  }

  #forward(): Point {
    const {east, north, up} = levelAxes(this.up);
    const level = add(scale(east, Math.cos(this.#yaw)), scale(north, Math.sin(this.#yaw)));
    return add(scale(level, Math.cos(this.#pitch)), scale(up, Math.sin(this.#pitch)));
  }
}

const clampPitch = (pitch: number): number => Math.min(kSteepest, Math.max(-kSteepest, pitch));
