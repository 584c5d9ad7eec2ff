// SPDX-License-Identifier: MIT
import {slots, type LookAtCamera, type Occlude, type OccluderMesh, type Planes, type Scene, type View} from "occlude";

import type {Camera} from "./camera.mjs";
import {everythingIn, Fate, type Counts, type CullLimits, type Frame, type Method} from "./frame.mjs";
import {objectCount, triangleCount, type Model} from "./model.mjs";
import {polygonsOf} from "./polygons.mjs";

/** A scene, as engines have it: whole objects are left out, by their boxes, behind everything together. */
export class ObjectMethod implements Method {
  readonly #model: Model;
  readonly #scene: Scene;
  readonly #view: View;
  readonly #walls: OccluderMesh;
  /** The object of each slot. */
  readonly #numbers: number[] = [];
  readonly #index: Uint32Array<ArrayBuffer>;

  constructor(occlude: Occlude, model: Model) {
    this.#model = model;
    this.#scene = new occlude.Scene();
    this.#view = new occlude.View();
    this.#walls = new occlude.OccluderMesh(polygonsOf(model));
    slots(this.#scene.addObjects(model.boxes)).forEach((slot, object) => (this.#numbers[slot] = object));
    this.#scene.addOccluder(this.#walls);
    this.#scene.update();
    this.#index = Uint32Array.from({length: 3 * triangleCount(model)}, (_, i) => i);
  }

  get everything(): Frame {
    return everythingIn(this.#index);
  }

  cull(camera: LookAtCamera, {budget, margin}: CullLimits): Frame {
    const {objects, planes} = this.#scene.cull(camera, this.#view, {coverMs: budget, margin});
    const drawn = Uint32Array.from(slots(objects), slot => this.#numbers[slot]!).sort();
    const ofObjects = this.#fatesOfObjects(drawn, planes);
    const {firsts} = this.#model;
    const ranges = new Uint32Array(2 * drawn.length);
    drawn.forEach((object, i) => ranges.set([firsts[object]!, firsts[object + 1]! - firsts[object]!], 2 * i));
    return {
      index: this.#index,
      drawn: ranges,
      counts: this.#countsOf(ofObjects),
      tellFates: fates => ofObjects.forEach((fate, object) => fates.fill(fate, firsts[object]!, firsts[object + 1]!)),
    };
  }

  holds(camera: Camera): boolean {
    return this.#view.holdsFor(camera);
  }

  dispose(): void {
    this.#view.dispose();
    this.#scene.dispose();
    this.#walls.dispose();
  }

  #fatesOfObjects(drawn: Uint32Array, planes: Planes): Uint8Array {
    const fates = new Uint8Array(objectCount(this.#model)).fill(Fate.hidden);
    for (const object of drawn) fates[object] = Fate.drawn;
    fates.forEach((fate, object) => {
      if (fate === Fate.hidden && isBeyond(this.#model.boxes, object, planes)) fates[object] = Fate.outOfView;
    });
    return fates;
  }

  #countsOf(ofObjects: Uint8Array): Counts {
    const sums = [0, 0, 0], {firsts} = this.#model;
    ofObjects.forEach((fate, object) => (sums[fate]! += firsts[object + 1]! - firsts[object]!));
    return {drawn: sums[Fate.drawn]!, hidden: sums[Fate.hidden]!, outOfView: sums[Fate.outOfView]!};
  }
}

/** Whether a box is beyond one of the planes. */
function isBeyond(boxes: Float64Array, object: number, planes: Planes): boolean {
  for (let p = 0; p < planes.length; p += 4) {
    let most = planes[p + 3]!;
    for (let axis = 0; axis < 3; ++axis) most += planes[p + axis]! * boxes[6 * object + axis + (planes[p + axis]! > 0 ? 3 : 0)]!;
    if (most < 0) return true;
  }
  return false;
}
