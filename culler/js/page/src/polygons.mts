// SPDX-License-Identifier: MIT
import type {Culler, LookAtCamera, ModelFrame, ModelView, Occlude} from "occlude";
import {hidden} from "occlude";

import type {Camera} from "./camera.mjs";
import {everythingIn, Fate, type CullLimits, type Frame, type Method} from "./frame.mjs";
import {isSeeThrough, triangleCount, type Model} from "./model.mjs";

/** The culler of models: any polygon may be left out. */
export class PolygonMethod implements Method {
  readonly #culler: Culler;
  readonly #view: ModelView;
  readonly #index: Uint32Array<ArrayBuffer>;

  constructor(occlude: Occlude, model: Model) {
    this.#culler = new occlude.Culler(polygonsOf(model));
    this.#view = new occlude.ModelView();
    const {order} = this.#culler;
    this.#index = new Uint32Array(3 * order.length);
    order.forEach((triangle, i) => this.#index.set([3 * triangle, 3 * triangle + 1, 3 * triangle + 2], 3 * i));
  }

  get everything(): Frame {
    return everythingIn(this.#index);
  }

  cull(camera: LookAtCamera, {budget, margin}: CullLimits): Frame {
    const frame = this.#culler.cull(camera, this.#view, {coverMs: budget, margin});
    const {drawnPolygons, hiddenPolygons, outOfViewPolygons} = frame.statistics;
    return {
      index: this.#index,
      drawn: frame.drawn,
      counts: {drawn: drawnPolygons, hidden: hiddenPolygons, outOfView: outOfViewPolygons},
      tellFates: fates => this.#tellFates(frame, fates),
    };
  }

  holds(camera: Camera): boolean {
    return this.#view.holdsFor(camera);
  }

  dispose(): void {
    this.#view.dispose();
    this.#culler.dispose();
  }

  #tellFates({culled}: ModelFrame, fates: Uint8Array): void {
    fates.fill(Fate.drawn);
    const {order} = this.#culler;
    for (let i = 0; i < culled.length; i += 3) {
      const first = culled[i]!, end = first + culled[i + 1]!, fate = culled[i + 2] === hidden ? Fate.hidden : Fate.outOfView;
      for (let p = first; p < end; ++p) fates[order[p]!] = fate;
    }
  }
}

/** A model as the package takes it. What light comes through hides nothing. */
export function polygonsOf(model: Model) {
  const indices = Uint32Array.from({length: 3 * triangleCount(model)}, (_, i) => i);
  const seeThrough = Uint8Array.from({length: triangleCount(model)}, (_, t) => Number(isSeeThrough(model, t)));
  return {vertices: model.corners, indices, seeThrough};
}
