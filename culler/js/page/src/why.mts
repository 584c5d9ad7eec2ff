// SPDX-License-Identifier: MIT
// Why a triangle is drawn or not, in words.
import type {Camera as AnyCamera, ObjectId, Occlude, OccluderMesh, Scene, View} from "occlude";

import {axesOf} from "./axes.mjs";
import type {Camera} from "./camera.mjs";
import {cornerOf, facetOf, ownersOf, type Model} from "./model.mjs";
import {boxOf} from "./builder.mjs";
import {dot, type Point} from "./points.mjs";
import {polygonsOf} from "./polygons.mjs";

export interface Answer {
  readonly text: string;
  /** Triangles that hide it together. */
  readonly hiders: readonly number[];
}

/** Asks a scene whose only object is the box of the triangle in question. */
export class Asker {
  readonly #model: Model;
  readonly #owners: Uint32Array;
  readonly #scene: Scene;
  readonly #view: View;
  readonly #walls: OccluderMesh;
  readonly #object: ObjectId;

  constructor(occlude: Occlude, model: Model) {
    this.#model = model;
    this.#owners = ownersOf(model);
    this.#scene = new occlude.Scene();
    this.#view = new occlude.View();
    this.#walls = new occlude.OccluderMesh(polygonsOf(model));
    this.#object = this.#scene.addObject([0, 0, 0, 0, 0, 0]);
    this.#scene.addOccluder(this.#walls);
  }

  why(triangle: number, camera: Camera, margin: number): Answer {
    const {names} = this.#model, owner = this.#owners[triangle]!;
    const corners = [0, 1, 2].flatMap(corner => [...cornerOf(this.#model, triangle, corner)]);
    this.#scene.moveObjects([this.#object], boxOf(corners));
    this.#scene.update();
    const frame = this.#scene.cull(camera as AnyCamera, this.#view, {margin, adaptive: false});
    const fate = this.#scene.why([this.#object], this.#view)[0]!;
    const facet = facetOf(this.#model, triangle), what = `${facet[0]!.toUpperCase()}${facet.slice(1)} of “${names[owner]}”`;
    if (fate.reason === "out_of_view") {
      const [a, b, c] = frame.planes.subarray(4 * fate.plane!, 4 * fate.plane! + 3);
      return {text: `${what} is out of view: its box is wholly ${edgeOf([a!, b!, c!], camera)}.`, hiders: []};
    }
    if (fate.reason !== "hidden") return {text: `${what} is drawn: nothing in front is proved to hide all of its box.`, hiders: []};
    const hiders = fate.by!.map(({polygon}) => polygon);
    return {text: `${what} is hidden: every ray from the eye to its box meets ${this.#nameOf(hiders)} first.`, hiders};
  }

  dispose(): void {
    this.#view.dispose();
    this.#scene.dispose();
    this.#walls.dispose();
  }

  /** The objects that hide with most triangles, by name. */
  #nameOf(hiders: readonly number[]): string {
    const counts = new Map<string, number>();
    for (const hider of hiders) {
      const name = this.#model.names[this.#owners[hider]!]!;
      counts.set(name, (counts.get(name) ?? 0) + 1);
    }
    const named = [...counts].sort(([, a], [, b]) => b - a).slice(0, 2).map(([name, count]) => `${count} of “${name}”`).join(" and ");
    const rest = counts.size > 2 ? " and others" : "";
    return hiders.length === 1 ? `1 triangle of “${[...counts.keys()][0]!}”` : `one of ${hiders.length} triangles (${named}${rest})`;
  }
}

/** Beyond which edge of the picture a plane is, whose normal points into view. */
function edgeOf(normal: Point, camera: Camera): string {
  const {right, up, forward} = axesOf(camera);
  const sizes = [dot(normal, right), dot(normal, up)];
  if (Math.abs(sizes[0]!) + Math.abs(sizes[1]!) < 0.02 * dot(normal, forward)) return "behind the camera or too near to it";
  if (Math.abs(sizes[0]!) > Math.abs(sizes[1]!)) return sizes[0]! > 0 ? "beyond the left edge" : "beyond the right edge";
  return sizes[1]! > 0 ? "below the lower edge" : "above the upper edge";
}
