// SPDX-License-Identifier: MIT
// Geometries of three.js as meshes that hide.
import * as THREE from "three";

import type {Occlude, OccluderMesh} from "./occlude.mjs";

/** A part of a geometry: of its indices, or of its vertices where it has no indices. */
export interface Range {
  readonly start: number;
  readonly count: number;
}
export const whole: Range = {start: 0, count: Infinity};

/** Change with the vertices and indices of a geometry. */
export type Versions = readonly unknown[];

/** What a part of a geometry is made of. */
interface Content {
  readonly vertices: Float64Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

/** A part of a geometry as it was, and how many have it. */
export interface Shape {
  readonly mesh: OccluderMesh;
  readonly box: THREE.Box3;
  readonly content: Content;
  readonly key: string;
  versions: Versions;
  users: number;
}

/** Each part of a geometry once, for all that have it. */
export class Shapes {
  readonly #newest = new Map<string, Shape>();

  constructor(readonly occlude: Occlude) {}

  /** `isReversed`: the other side of each triangle is its front. */
  take(geometry: THREE.BufferGeometry, range: Range, isReversed: boolean): Shape {
    const key = `${geometry.id} ${range.start} ${range.count} ${isReversed}`, versions = versionsOf(geometry);
    let shape = this.#newest.get(key);
    if (shape === undefined || !hasVersions(geometry, shape.versions)) {
      // A batch has one buffer for all, which changes for each.
      const content = contentOf(geometry, range, isReversed);
      if (shape !== undefined && isSameContent(shape.content, content)) shape.versions = versions;
      else this.#newest.set(key, (shape = this.#make(content, key, versions)));
    }
    ++shape.users;
    return shape;
  }

  release(shape: Shape): void {
    if (--shape.users > 0) return;
    shape.mesh.dispose();
    if (this.#newest.get(shape.key) === shape) this.#newest.delete(shape.key);
  }

  #make(content: Content, key: string, versions: Versions): Shape {
    const isFinite = content.vertices.every(Number.isFinite);
    const mesh = new this.occlude.OccluderMesh(isFinite ? content : {vertices: [], indices: []});
    const box = new THREE.Box3().setFromArray(content.vertices);
    return {mesh, box, content, key, versions, users: 0};
  }
}

const versionOf = (position: THREE.BufferAttribute | THREE.InterleavedBufferAttribute): number =>
  "data" in position ? position.data.version : position.version;

export function versionsOf({index, attributes: {position}}: THREE.BufferGeometry): Versions {
  return [position, versionOf(position!), position!.count, index, index?.version, index?.count];
}

/** Whether these are the versions of the geometry: as versionsOf(), without making an array. */
export function hasVersions({index, attributes: {position}}: THREE.BufferGeometry, versions: Versions): boolean {
  const isSamePosition = versions[0] === position && versions[1] === versionOf(position!) && versions[2] === position!.count;
  return isSamePosition && versions[3] === index && versions[4] === index?.version && versions[5] === index?.count;
}

/** Vertices that were freed once the renderer had them are nowhere. */
const nowhere: Content = {vertices: new Float64Array(3).fill(NaN), indices: new Uint32Array(0)};

const isFreed = (attribute: THREE.BufferAttribute | THREE.InterleavedBufferAttribute) =>
  !("data" in attribute ? attribute.data : attribute).array?.length;

function contentOf(geometry: THREE.BufferGeometry, {start, count}: Range, isReversed: boolean): Content {
  const {index} = geometry, position = geometry.attributes.position!;
  if (isFreed(position) || (index !== null && isFreed(index))) return nowhere;
  const triangles = Math.floor(Math.min(count, (index?.count ?? position.count) - start) / 3);
  const indices = Uint32Array.from({length: 3 * triangles}, (_, i) => {
    const at = start + (isReversed && i % 3 !== 0 ? i + 3 - 2 * (i % 3) : i);
    return index ? index.getX(at) : at;
  });
  const first = indices.reduce((least, i) => Math.min(least, i), Infinity), last = indices.reduce((most, i) => Math.max(most, i), -1);
  const vertices = new Float64Array(3 * Math.max(0, last + 1 - first));
  for (let i = first; i <= last; ++i) vertices.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * (i - first));
  return {vertices, indices: indices.map(i => i - first)};
}

export function isSame(a: ArrayLike<unknown>, b: ArrayLike<unknown>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}
const isSameContent = (a: Content, b: Content) => isSame(a.vertices, b.vertices) && isSame(a.indices, b.indices);
