// SPDX-License-Identifier: MIT
// The way that somebody has gone, as a file that every --path of the command takes.
import type {Place} from "./camera.mjs";
import type {Model} from "./model.mjs";

/** Keyframes a second. */
export const kRate = 30;
/** Half an hour. */
const kMost = 30 * 60 * kRate;

export class Recorder {
  #places: Place[] = [];
  #next = 0;
  isOn = false;

  start(): void {
    this.#places = [];
    this.#next = 0;
    this.isOn = true;
  }

  /** Keeps a place for each keyframe up to now: seconds since the start. */
  record({eye, target}: Place, seconds: number): void {
    for (; this.isOn && this.#next <= seconds * kRate && this.#next < kMost; ++this.#next) this.#places.push({eye, target});
  }

  get seconds(): number {
    return this.#next / kRate;
  }

  /** The file. One place alone stays for two frames. */
  text({name, lens: {fovY, near}, up}: Pick<Model, "name" | "lens" | "up">): string {
    const keyframes = this.#places.length > 1 ? this.#places : [...this.#places, ...this.#places];
    return `${JSON.stringify({model: name, frames: keyframes.length, fov_y_deg: fovY, near, up, keyframes})}\n`;
  }
}
