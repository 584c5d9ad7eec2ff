// SPDX-License-Identifier: MIT
// Occlusion culling of a scene of three.js.
//
//   import {Occlusion} from "occlude/three";
//   const occlusion = await Occlusion.of(scene);
//   occlusion.update(camera), renderer.render(scene, camera);
import * as THREE from "three";

import {load, type CullOptions, type MatrixCamera, type Occlude, type View} from "./occlude.mjs";
import {BatchHiding} from "./three_batches.mjs";
import {hidingOf, type Asked} from "./three_materials.mjs";
import {World, type Hidden} from "./three_world.mjs";

export interface OcclusionOptions {
  /** The fewest rows of pixels of a picture: up to there pictures are the same to the pixel. Default: 360. */
  readonly rows?: number;
  /** The budget of a frame: see CullOptions. */
  readonly cull?: Pick<CullOptions, "coverSize" | "coverWork" | "coverMs">;
}

/** What the last update of a camera found, for frames of the same camera at the same place. */
interface Found {
  readonly view: View;
  readonly matrix: THREE.Matrix4;
  readonly hidden: Hidden;
}

/** What a renderer is at: its camera, what it leaves out, and the meshes that it has asked for. */
interface Rendering {
  readonly camera: THREE.Camera;
  readonly hidden: Hidden | undefined;
  readonly asked: Set<THREE.Object3D>;
}

/** How a mesh is left out. */
interface Hook {
  readonly layers: THREE.Layers;
  readonly batch: BatchHiding | undefined;
}

/**
 * Leaves out what is hidden when a scene is rendered with a camera that was updated.
 * - update() comes last before render(). A camera that was moved since, or was not updated, is rendered with everything.
 * - Hidden are meshes, instanced ones as a whole, and each instance of batched ones. What may reach out of its box is always drawn:
 *   skinned and morphing meshes, materials with own shaders, displacement or wireframe, what is drawn without a depth test, meshes
 *   with an own onBeforeRender, and what is in a BundleGroup.
 * - Opaque meshes hide. Transparent ones, and those with tests of alpha or clipping planes, hide nothing.
 * - Shadows, picking, other cameras, `visible`, `layers`, visibility of instances and materials are as they would be without this.
 */
export class Occlusion {
  readonly #occlude: Occlude;
  readonly #scene: THREE.Scene;
  readonly #options: OcclusionOptions;
  readonly #world: World;
  readonly #hooks = new Map<THREE.Mesh, Hook>();
  #found = new WeakMap<THREE.Camera, Found>();
  /** Whose layers they are; null: of several. */
  readonly #owners = new Map<THREE.Layers, THREE.Mesh | null>();
  readonly #before: THREE.Scene["onBeforeRender"];
  readonly #after: THREE.Scene["onAfterRender"];
  /** The last is that which is inside of all others. */
  readonly #renderings: Rendering[] = [];

  /** Loads the module if none is given. */
  static async of(scene: THREE.Scene, options: OcclusionOptions = {}): Promise<Occlusion> {
    return new Occlusion(await load(), scene, options);
  }

  constructor(occlude: Occlude, scene: THREE.Scene, options: OcclusionOptions = {}) {
    this.#occlude = occlude;
    this.#scene = scene;
    this.#options = options;
    this.#world = new World(occlude);
    const before = (this.#before = scene.onBeforeRender), after = (this.#after = scene.onAfterRender);
    scene.onBeforeRender = (...given) => {
      before.apply(scene, given);
      this.#renderings.push({camera: given[2], hidden: this.#hiddenNow(given[0], given[2]), asked: new Set()});
    };
    scene.onAfterRender = (...given) => {
      this.#renderings.pop();
      after.apply(scene, given);
    };
  }

  /** Finds what is hidden from the camera as everything is now. */
  update(camera: THREE.Camera): void {
    this.#renderings.length = 0; // of what threw
    for (const {batch} of this.#hooks.values()) batch?.reset();
    if (this.#scene.matrixWorldAutoUpdate) this.#scene.updateMatrixWorld();
    if (camera.matrixWorldAutoUpdate) camera.updateWorldMatrix(true, false);
    this.#see(camera);
    const matrix = matrixOf(camera);
    const view = this.#found.get(camera)?.view ?? new this.#occlude.View();
    const options = {...this.#options.cull, mask: camera.layers.mask >>> 0, margin: this.#occlude.marginFor(this.#options.rows ?? 360)};
    this.#found.set(camera, {view, matrix, hidden: this.#world.cull(cameraOf(camera, matrix), view, options)});
  }

  /** How many meshes, and instances of batched ones, the last update of the camera leaves out, those out of view included. */
  hiddenFrom(camera: THREE.Camera): number {
    return this.#found.get(camera)?.hidden.count ?? 0;
  }

  /** Whether the box, such as of something that is still to be loaded, was hidden or out of view in the last update of the camera. */
  isHidden({min, max}: THREE.Box3, camera: THREE.Camera): boolean {
    const found = this.#found.get(camera);
    return found !== undefined && found.view.visibility([...min.toArray(), ...max.toArray()])[0] !== "visible";
  }

  /** Everything is as it was before. */
  dispose(): void {
    this.#scene.onBeforeRender = this.#before;
    this.#scene.onAfterRender = this.#after;
    for (const mesh of [...this.#hooks.keys()]) this.#unhook(mesh);
    this.#found = new WeakMap();
    this.#world.dispose();
  }

  #hiddenNow(renderer: THREE.WebGLRenderer, camera: THREE.Camera): Hidden | undefined {
    const found = this.#found.get(camera);
    const isClipped = (renderer as Partial<THREE.WebGLRenderer>).clippingPlanes?.length ?? 0;
    if (found === undefined || isClipped || this.#scene.overrideMaterial !== null) return undefined;
    return found.matrix.equals(matrixOf(camera)) ? found.hidden : undefined;
  }

  /** The renderer asks each object once for the picture, and then again for shadows. */
  #isLeftOut(mesh: THREE.Mesh, layers: THREE.Layers): boolean {
    const rendering = this.#renderings.at(-1);
    if (rendering?.camera.layers !== layers || rendering.asked.has(mesh)) return false;
    rendering.asked.add(mesh);
    return rendering.hidden?.meshes.has(mesh) ?? false;
  }
  #instancesLeftOut(batch: THREE.BatchedMesh, camera: THREE.Camera): readonly number[] {
    const rendering = this.#renderings.at(-1);
    return (rendering?.camera === camera && rendering.hidden?.instances.get(batch)) || [];
  }

  /** Tells the world what has come, gone and changed. */
  #see(camera: THREE.Camera): void {
    const seen = new Set<THREE.Mesh>(), asked: Asked = new Map();
    const visit = (object: THREE.Object3D, isCut: boolean) => {
      const {isBundleGroup, isClippingGroup} = object as {isBundleGroup?: boolean; isClippingGroup?: boolean};
      if (!object.visible || isBundleGroup) return; // a bundle is drawn as it was recorded, by any camera
      if (object instanceof THREE.LOD && object.autoUpdate) object.update(camera);
      if (object instanceof THREE.Mesh) {
        const hiding = hidingOf(object, asked);
        if (hiding !== "own") {
          seen.add(object);
          this.#world.see(object, isCut ? "none" : hiding);
          this.#hook(object);
        }
      }
      for (const child of object.children) visit(child, isCut || isClippingGroup === true);
    };
    visit(this.#scene, false);
    for (const mesh of this.#hooks.keys()) {
      if (!seen.has(mesh)) this.#unhook(mesh), this.#world.forget(mesh);
    }
  }

  #hook(mesh: THREE.Mesh): void {
    const {layers} = mesh, hook = this.#hooks.get(mesh);
    if (hook?.layers === layers) return;
    if (hook !== undefined) this.#unhook(mesh);
    const batch = mesh instanceof THREE.BatchedMesh ? new BatchHiding(mesh, camera => this.#instancesLeftOut(mesh, camera)) : undefined;
    this.#hooks.set(mesh, {layers, batch});
    if (this.#owners.has(layers)) {
      this.#owners.set(layers, null);
      delete (layers as Partial<THREE.Layers>).test; // nobody could tell whose they are: they are drawn
    } else {
      this.#owners.set(layers, mesh);
      layers.test = other => !this.#isLeftOut(mesh, other) && THREE.Layers.prototype.test.call(layers, other);
    }
  }

  #unhook(mesh: THREE.Mesh): void {
    const {layers, batch} = this.#hooks.get(mesh)!;
    this.#hooks.delete(mesh);
    batch?.dispose();
    if (this.#owners.get(layers) !== mesh) return;
    this.#owners.delete(layers);
    delete (layers as Partial<THREE.Layers>).test;
  }
}

const matrixOf = (camera: THREE.Camera) => new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);

function cameraOf(camera: THREE.Camera, matrix: THREE.Matrix4): MatrixCamera {
  const isReversed = (camera as {reversedDepth?: boolean}).reversedDepth === true;
  const isZeroToW = isReversed || camera.coordinateSystem === THREE.WebGPUCoordinateSystem;
  return {matrix: matrix.elements, depth: isZeroToW ? "zero_to_w" : "minus_w_to_w", nearer: isReversed ? "greater" : "less"};
}
