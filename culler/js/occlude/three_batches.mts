// SPDX-License-Identifier: MIT
// Instances of batched meshes of three.js.
import * as THREE from "three";

/** What a BatchedMesh keeps of an instance: its own functions throw for one that was deleted. */
interface Instance {
  visible: boolean;
  readonly active: boolean;
  readonly geometryIndex: number;
}

export const instancesOf = (batch: THREE.BatchedMesh): readonly Instance[] =>
  (batch as unknown as {_instanceInfo: Instance[]})._instanceInfo;

/** Where the instances are in the batch, 16 numbers each. */
export const placesOf = (batch: THREE.BatchedMesh): THREE.DataTexture =>
  (batch as unknown as {_matricesTexture: THREE.DataTexture})._matricesTexture;

type Hook = THREE.Object3D["onBeforeRender"];
const hooks = new WeakSet<Hook>();

export const isHooked = ({onBeforeRender}: THREE.Object3D): boolean => hooks.has(onBeforeRender);

/**
 * Hides instances of a batch from one camera.
 * - They are invisible from when the batch is about to be drawn with the camera until it has been drawn: for no shadow, no other
 *   camera and no question of the application.
 */
export class BatchHiding {
  readonly #batch: THREE.BatchedMesh;
  readonly #before: Hook;
  readonly #after: Hook;
  /** Those that are invisible now. */
  #hidden: readonly number[] = [];
  /** Drawings that have begun, one inside of the other as maps of shadows are, and what was invisible before each. */
  readonly #begun: {readonly given: Parameters<Hook>; readonly hidden: readonly number[]}[] = [];

  constructor(batch: THREE.BatchedMesh, hiddenFrom: (camera: THREE.Camera) => readonly number[]) {
    const {onBeforeRender: before, onAfterRender: after} = batch;
    this.#batch = batch;
    this.#before = (...given) => {
      // Without a scene it is drawn into the map of a shadow, and nobody says when that is done.
      if (given[1] !== null && batch.onAfterRender === this.#after) {
        this.#begun.push({given, hidden: this.#hidden});
        this.#hide(hiddenFrom(given[2]));
      }
      before.apply(batch, given);
    };
    this.#after = (...given) => {
      this.#hide(this.#begun.pop()?.hidden ?? []);
      after.apply(batch, given);
      // WebGPURenderer before 0.187 would go on with the list of the map of a shadow.
      const around = this.#begun.at(-1);
      if (around !== undefined) before.apply(batch, around.given);
    };
    hooks.add(this.#before);
    batch.onBeforeRender = this.#before;
    batch.onAfterRender = this.#after;
  }

  /** Shows what a frame has left invisible that threw. */
  reset(): void {
    this.#begun.length = 0;
    this.#hide([]);
  }

  dispose(): void {
    this.reset();
    const own = this.#batch as Partial<THREE.BatchedMesh>;
    if (own.onBeforeRender === this.#before) delete own.onBeforeRender;
    if (own.onAfterRender === this.#after) delete own.onAfterRender;
  }

  /** These, and no others. What the application has made invisible stays so. */
  #hide(instances: readonly number[]): void {
    const batch = this.#batch, all = instancesOf(batch);
    for (const id of this.#hidden) if (all[id]?.active) batch.setVisibleAt(id, true);
    this.#hidden = instances.filter(id => all[id]?.active && all[id].visible);
    for (const id of this.#hidden) batch.setVisibleAt(id, false);
  }
}
