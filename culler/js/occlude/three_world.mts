// SPDX-License-Identifier: MIT
// Meshes of three.js as objects and occluders of a scene of the package.
import * as THREE from "three";

import {
  slot, slots, type Camera, type CullOptions, type ObjectId, type Occlude, type OccluderId, type Scene, type View,
} from "./occlude.mjs";
import {instancesOf, placesOf} from "./three_batches.mjs";
import type {Hiding} from "./three_materials.mjs";
import {hasVersions, isSame, Shapes, versionsOf, whole, type Range, type Shape, type Versions} from "./three_shapes.mjs";

/** Something that is drawn or not: a mesh, or an instance of a batch. */
interface Part {
  /** The number of its geometry, in a batch. */
  readonly geometry: number;
  /** Where it is in its mesh: once, or more often. 16 numbers each. */
  readonly places: ArrayLike<number>;
}

/** A part as the scene knows it. */
interface Thing extends Part {
  readonly shape: Shape;
  readonly id: ObjectId;
  readonly slot: number;
  readonly occluders: readonly OccluderId[];
  places: ArrayLike<number>;
}

/** A mesh as it was seen. */
interface Seen {
  readonly mesh: THREE.Mesh;
  readonly hiding: Hiding;
  /** By the numbers of instances, in a batch. */
  readonly things: (Thing | undefined)[];
  readonly matrix: THREE.Matrix4;
  /** Of the geometry. */
  versions: Versions;
  /** What places the parts in the mesh, how many times they are placed, and the version of that. */
  placing: {readonly places: object | undefined; readonly count: number; readonly version: number};
  mask: number;
}

/** What is left out of a picture. */
export interface Hidden {
  readonly meshes: ReadonlySet<THREE.Object3D>;
  /** Of batches that are not left out as a whole. */
  readonly instances: ReadonlyMap<THREE.Object3D, readonly number[]>;
  readonly count: number;
}

/** The meshes that it was shown, as they were then. */
export class World {
  readonly #scene: Scene;
  readonly #shapes: Shapes;
  readonly #seen = new Map<THREE.Mesh, Seen>();

  constructor(occlude: Occlude) {
    this.#scene = new occlude.Scene();
    this.#shapes = new Shapes(occlude);
  }

  see(mesh: THREE.Mesh, hiding: Hiding): void {
    const mask = mesh.layers.mask >>> 0, before = this.#seen.get(mesh);
    let seen = before;
    if (seen?.hiding !== hiding) {
      seen = {mesh, hiding, things: [], matrix: new THREE.Matrix4(), versions: [], placing: unplaced, mask};
      this.#seen.set(mesh, seen);
    }
    if (seen.mask !== mask) this.#mask(seen, mask);
    this.#seeParts(seen);
    if (before !== undefined && before !== seen) this.#forget(before); // last, as its shapes may still be needed
  }

  forget(mesh: THREE.Mesh): void {
    this.#forget(this.#seen.get(mesh)!);
    this.#seen.delete(mesh);
  }

  cull(camera: Camera, view: View, options: CullOptions): Hidden {
    this.#scene.update();
    const isDrawn: true[] = [];
    for (const at of slots(this.#scene.cull(camera, view, options).objects)) isDrawn[at] = true;
    const meshes = new Set<THREE.Object3D>(), instances = new Map<THREE.Object3D, readonly number[]>();
    let count = 0;
    for (const {mesh, things} of this.#seen.values()) {
      const hidden: number[] = [];
      let isSeen = false;
      things.forEach((thing, i) => {
        if (thing === undefined) return;
        if (isDrawn[thing.slot]) isSeen = true;
        else hidden.push(i);
      });
      if (!isSeen) meshes.add(mesh);
      else if (hidden.length > 0) instances.set(mesh, hidden);
      count += hidden.length;
    }
    return {meshes, instances, count};
  }

  dispose(): void {
    for (const mesh of [...this.#seen.keys()]) this.forget(mesh);
    this.#scene.dispose();
  }

  #forget({things}: Seen): void {
    for (const thing of things) if (thing) this.#remove(thing);
  }

  #mask(seen: Seen, mask: number): void {
    seen.mask = mask;
    for (const thing of seen.things) {
      if (thing === undefined) continue;
      this.#scene.maskObjects([thing.id], mask);
      this.#scene.maskOccluders(thing.occluders, mask);
    }
  }

  #seeParts(seen: Seen): void {
    const {mesh, matrix, things} = seen;
    const isSameShapes = hasVersions(mesh.geometry, seen.versions), isMoved = !matrix.equals(mesh.matrixWorld);
    if (isSameShapes && !isMoved && !isPlacedAnew(seen) && !hasOtherInstances(seen)) return;
    seen.versions = versionsOf(mesh.geometry);
    seen.placing = placingOf(mesh);
    matrix.copy(mesh.matrixWorld);
    const parts = partsOf(mesh), come: number[] = [], moved: number[] = [], gone: Thing[] = [];
    for (let i = 0; i < Math.max(parts.length, things.length); ++i) {
      const part = parts[i], thing = things[i];
      if (thing !== undefined && part !== undefined && isSameShapes && thing.geometry === part.geometry) {
        if (!isMoved && isSame(part.places, thing.places)) continue;
        if (occludersOf(seen, placementsOf(seen, part)) === thing.occluders.length) {
          moved.push(i);
          continue;
        }
      }
      if (thing !== undefined) gone.push(thing);
      if (part !== undefined) come.push(i);
      else things[i] = undefined;
    }
    this.#move(seen, moved, parts);
    this.#add(seen, come, parts); // before others go, which may have the same shapes
    for (const thing of gone) this.#remove(thing);
    things.length = parts.length;
  }

  #move(seen: Seen, numbers: readonly number[], parts: readonly (Part | undefined)[]): void {
    const boxes: number[] = [], placements: number[] = [], things = numbers.map(i => seen.things[i]!);
    numbers.forEach((i, k) => {
      const thing = things[k]!, placed = placementsOf(seen, parts[i]!);
      thing.places = Array.from(parts[i]!.places);
      boxes.push(...boxOf(thing.shape, placed));
      if (thing.occluders.length > 0) for (const x of placed) placements.push(x);
    });
    this.#scene.moveObjects(things.map(({id}) => id), boxes);
    this.#scene.moveOccluders(things.flatMap(({occluders}) => occluders), placements);
  }

  #add(seen: Seen, numbers: readonly number[], parts: readonly (Part | undefined)[]): void {
    const {mesh, mask, hiding, things} = seen;
    const shapes = numbers.map(i => this.#shapes.take(mesh.geometry, rangeOf(mesh, parts[i]!.geometry), hiding === THREE.BackSide));
    const placed = numbers.map(i => placementsOf(seen, parts[i]!));
    const ids = this.#scene.addObjects(shapes.flatMap((shape, k) => boxOf(shape, placed[k]!)), {mask});
    numbers.forEach((i, k) => {
      const {geometry, places} = parts[i]!, id = ids[k]!, shape = shapes[k]!;
      const how = {object: id, mask, oneSided: hiding !== THREE.DoubleSide};
      const occluders = occludersOf(seen, placed[k]!) > 0 ? [...this.#scene.addOccluders(shape.mesh, placed[k]!, how)] : [];
      things[i] = {geometry, places: Array.from(places), shape, id, slot: slot(id), occluders};
    });
  }

  #remove({id, occluders, shape}: Thing): void {
    this.#scene.removeOccluders(occluders);
    this.#scene.removeObjects([id]);
    this.#shapes.release(shape);
  }
}

const identity = new THREE.Matrix4().elements;

function partsOf(mesh: THREE.Mesh): (Part | undefined)[] {
  if (mesh instanceof THREE.InstancedMesh) return [{geometry: 0, places: mesh.instanceMatrix.array.subarray(0, 16 * mesh.count)}];
  if (!(mesh instanceof THREE.BatchedMesh)) return [{geometry: 0, places: identity}];
  const places = placesOf(mesh).image.data as Float32Array;
  return instancesOf(mesh).map(({visible, active, geometryIndex: geometry}, i) =>
    visible && active ? {geometry, places: places.subarray(16 * i, 16 * i + 16)} : undefined);
}

const rangeOf = (mesh: THREE.Mesh, geometry: number): Range =>
  mesh instanceof THREE.BatchedMesh ? mesh.getGeometryRangeAt(geometry)! : whole;

const unplaced = {places: undefined, count: 1, version: 0};
function placingOf(mesh: THREE.Mesh): Seen["placing"] {
  if (mesh instanceof THREE.InstancedMesh) return {places: mesh.instanceMatrix, count: mesh.count, version: mesh.instanceMatrix.version};
  return mesh instanceof THREE.BatchedMesh ? {places: placesOf(mesh), count: 1, version: placesOf(mesh).version} : unplaced;
}
function isPlacedAnew({mesh, placing: {places, count, version}}: Seen): boolean {
  const now = placingOf(mesh);
  return now.places !== places || now.count !== count || now.version !== version;
}

/** Whether instances have come or gone, or have another geometry. */
function hasOtherInstances({mesh, things}: Seen): boolean {
  if (!(mesh instanceof THREE.BatchedMesh)) return false;
  const all = instancesOf(mesh);
  const isOther = ({visible, active, geometryIndex}: (typeof all)[0], i: number) =>
    (visible && active ? geometryIndex : undefined) !== things[i]?.geometry;
  return all.length !== things.length || all.some(isOther);
}

/** Matrices in the world. */
function placementsOf({matrix}: Seen, {places}: Part): Float64Array<ArrayBuffer> {
  const placements = new Float64Array(places.length), placed = new THREE.Matrix4();
  for (let i = 0; i < places.length; i += 16) placements.set(placed.fromArray(places, i).premultiply(matrix).elements, i);
  return placements;
}

/** How many occluders there are: none where a matrix is nothing that places. */
function occludersOf({hiding}: Seen, placements: Float64Array): number {
  if (hiding === "none") return 0;
  for (let i = 0; i < placements.length; ++i) {
    if (!Number.isFinite(placements[i]) || (i % 4 === 3 && placements[i] !== (i % 16 === 15 ? 1 : 0))) return 0;
  }
  return placements.length / 16;
}

/** The box of a shape at all these places. One without a place, which is always drawn, if it is nowhere. */
function boxOf({box}: Shape, placements: Float64Array): number[] {
  const all = new THREE.Box3(), placed = new THREE.Matrix4();
  for (let i = 0; i < placements.length; i += 16) all.union(box.clone().applyMatrix4(placed.fromArray(placements, i)));
  const sides = [...all.min.toArray(), ...all.max.toArray()];
  return !all.isEmpty() && sides.every(Number.isFinite) ? sides : [-1e300, -1e300, -1e300, 1e300, 1e300, 1e300];
}
