// SPDX-License-Identifier: MIT
// Occlusion culling of a scene of three.js.
//
//   import {Occlusion} from "occlude/three";
//   const occlusion = await Occlusion.of(scene);
//   occlusion.update(camera), renderer.render(scene, camera);
import * as THREE from "three";

import {
  load, type CullOptions, type MatrixCamera, type ObjectId, type Occlude, type OccluderId, type OccluderMesh, type Scene, type View,
} from "./occlude.mjs";

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
  hidden: Set<THREE.Object3D>;
}

/** A geometry, and how many meshes have it. */
interface Shape {
  readonly mesh: OccluderMesh;
  readonly box: THREE.Box3;
  readonly key: string;
  users: number;
}

/** A geometry where it is in the world. */
interface Part {
  readonly shape: Shape;
  readonly matrix: THREE.Matrix4;
}

/** What is known of a mesh. */
interface Known {
  readonly shape: Shape;
  id: ObjectId;
  occluders: OccluderId[];
  /** What the box and the occluders were made of: when it changes they are made anew. */
  made: string;
  readonly matrix: THREE.Matrix4;
  mask: number;
  layers: THREE.Layers;
}

/**
 * Leaves out what is hidden when a scene is rendered with a camera that was updated.
 * - update() comes last before render(). A camera that was moved since, or was not updated, is rendered with everything.
 * - Hidden are meshes, also instanced ones, as a whole. What may reach out of its box is always drawn: skinned and morphing meshes,
 *   materials with own shaders, displacement or wireframe, and what is drawn without a depth test. So are batched meshes.
 * - Opaque meshes hide. Transparent ones, and those with tests of alpha or clipping planes, hide nothing.
 * - Shadows, picking, other cameras, `visible`, `layers` and materials are as they would be without this.
 */
export class Occlusion {
  readonly #occlude: Occlude;
  readonly #scene: THREE.Scene;
  readonly #options: OcclusionOptions;
  readonly #world: Scene;
  readonly #known = new Map<THREE.Mesh, Known>();
  readonly #found = new Map<THREE.Camera, Found>();
  /** By what it is made of. */
  readonly #shapes = new Map<string, Shape>();
  /** Whose layers they are; null: of several. */
  readonly #owners = new Map<THREE.Layers, THREE.Mesh | null>();
  readonly #before: THREE.Scene["onBeforeRender"];
  readonly #after: THREE.Scene["onAfterRender"];
  /** While the renderer looks for what to draw, of which camera; and those that it has asked for. */
  #rendered: {readonly layers: THREE.Layers; readonly hidden: Set<THREE.Object3D>} | undefined;
  readonly #asked = new Set<THREE.Object3D>();

  /** Loads the module if none is given. */
  static async of(scene: THREE.Scene, options: OcclusionOptions = {}): Promise<Occlusion> {
    return new Occlusion(await load(), scene, options);
  }

  constructor(occlude: Occlude, scene: THREE.Scene, options: OcclusionOptions = {}) {
    this.#occlude = occlude;
    this.#scene = scene;
    this.#options = options;
    this.#world = new occlude.Scene();
    const before = (this.#before = scene.onBeforeRender), after = (this.#after = scene.onAfterRender);
    scene.onBeforeRender = (...given) => {
      before.apply(scene, given);
      this.#begin(given[0], given[2]);
    };
    scene.onAfterRender = (...given) => {
      this.#rendered = undefined;
      after.apply(scene, given);
    };
  }

  /** Finds what is hidden from the camera as everything is now. */
  update(camera: THREE.Camera): void {
    if (this.#scene.matrixWorldAutoUpdate) this.#scene.updateMatrixWorld();
    if (camera.matrixWorldAutoUpdate) camera.updateWorldMatrix(true, false);
    this.#scene.traverse(object => {
      if (object instanceof THREE.LOD && object.autoUpdate) object.update(camera);
    });
    this.#see();
    this.#world.update();
    const matrix = matrixOf(camera);
    const view = this.#found.get(camera)?.view ?? new this.#occlude.View();
    const options = {...this.#options.cull, mask: camera.layers.mask >>> 0, margin: this.#occlude.marginFor(this.#options.rows ?? 360)};
    const frame = this.#world.cull(cameraOf(camera, matrix), view, options);
    const drawn = new Set(frame.objects);
    const hidden = new Set<THREE.Object3D>();
    for (const [mesh, {id}] of this.#known) if (!drawn.has(id)) hidden.add(mesh);
    this.#found.set(camera, {view, matrix, hidden});
  }

  /** How many meshes the last update of the camera leaves out, those out of view included. */
  hiddenFrom(camera: THREE.Camera): number {
    return this.#found.get(camera)?.hidden.size ?? 0;
  }

  /** Everything is as it was before. */
  dispose(): void {
    this.#scene.onBeforeRender = this.#before;
    this.#scene.onAfterRender = this.#after;
    for (const layers of this.#owners.keys()) delete (layers as Partial<THREE.Layers>).test;
    for (const {view} of this.#found.values()) view.dispose();
    for (const {mesh} of this.#shapes.values()) mesh.dispose();
    this.#known.clear();
    this.#found.clear();
    this.#shapes.clear();
    this.#world.dispose();
  }

  #begin(renderer: THREE.WebGLRenderer, camera: THREE.Camera): void {
    this.#asked.clear();
    this.#rendered = undefined;
    const found = this.#found.get(camera);
    const isClipped = (renderer as Partial<THREE.WebGLRenderer>).clippingPlanes?.length ?? 0;
    if (found === undefined || isClipped || this.#scene.overrideMaterial !== null || !found.matrix.equals(matrixOf(camera))) return;
    this.#rendered = {layers: camera.layers, hidden: found.hidden};
  }

  /** The renderer asks each object once for the picture, and then again for shadows. */
  #isLeftOut(mesh: THREE.Mesh, layers: THREE.Layers): boolean {
    if (this.#rendered?.layers !== layers || this.#asked.has(mesh)) return false;
    this.#asked.add(mesh);
    return this.#rendered.hidden.has(mesh);
  }

  /** Tells the world what has come, gone and changed. */
  #see(): void {
    const seen = new Set<THREE.Mesh>();
    this.#scene.traverseVisible(object => {
      if (!(object instanceof THREE.Mesh) || !staysInBox(object)) return;
      seen.add(object);
      this.#seeMesh(object);
    });
    for (const [mesh, known] of this.#known) {
      if (!seen.has(mesh)) this.#forget(mesh, known);
    }
  }

  #seeMesh(mesh: THREE.Mesh): void {
    const made = signatureOf(mesh);
    let known = this.#known.get(mesh);
    if (known !== undefined && known.made !== made) {
      this.#forget(mesh, known);
      known = undefined;
    }
    const mask = mesh.layers.mask >>> 0;
    if (known === undefined) return this.#add(mesh, made, mask);
    if (known.layers !== mesh.layers) {
      this.#unhook(mesh, known.layers);
      known.layers = mesh.layers;
      this.#hook(mesh);
    }
    if (known.mask !== mask) {
      known.mask = mask;
      this.#world.maskObjects([known.id], mask);
      this.#world.maskOccluders(known.occluders, mask);
    }
    if (known.matrix.equals(mesh.matrixWorld)) return;
    known.matrix.copy(mesh.matrixWorld);
    this.#world.moveObjects([known.id], boxOf(partsOf(mesh, known.shape)));
    if (known.occluders.length > 0) this.#world.moveOccluders(known.occluders, placementsOf(mesh, known.shape));
  }

  #add(mesh: THREE.Mesh, made: string, mask: number): void {
    const side = hidingSideOf(mesh), shape = this.#take(mesh.geometry, side === THREE.BackSide);
    const id = this.#world.addObject(boxOf(partsOf(mesh, shape)), {mask});
    const how = {object: id, mask, oneSided: side !== THREE.DoubleSide};
    const occluders = side === undefined ? [] : [...this.#world.addOccluders(shape.mesh, placementsOf(mesh, shape), how)];
    this.#known.set(mesh, {shape, id, occluders, made, mask, matrix: mesh.matrixWorld.clone(), layers: mesh.layers});
    this.#hook(mesh);
  }

  #hook(mesh: THREE.Mesh): void {
    const {layers} = mesh;
    if (this.#owners.has(layers)) {
      this.#owners.set(layers, null);
      delete (layers as Partial<THREE.Layers>).test; // nobody could tell whose they are: they are drawn
    } else {
      this.#owners.set(layers, mesh);
      layers.test = other => !this.#isLeftOut(mesh, other) && THREE.Layers.prototype.test.call(layers, other);
    }
  }
  #unhook(mesh: THREE.Mesh, layers: THREE.Layers): void {
    if (this.#owners.get(layers) !== mesh) return;
    this.#owners.delete(layers);
    delete (layers as Partial<THREE.Layers>).test;
  }

  #forget(mesh: THREE.Mesh, known: Known): void {
    this.#world.removeOccluders(known.occluders);
    this.#world.removeObjects([known.id]);
    this.#unhook(mesh, known.layers);
    this.#known.delete(mesh);
    if (--known.shape.users > 0) return;
    known.shape.mesh.dispose();
    this.#shapes.delete(known.shape.key);
  }

  #take(geometry: THREE.BufferGeometry, isReversed: boolean): Shape {
    const key = `${geometrySignatureOf(geometry)} ${isReversed}`;
    let made = this.#shapes.get(key);
    if (made === undefined) {
      const position = geometry.getAttribute("position");
      const vertices = new Float64Array(3 * position.count);
      for (let i = 0; i < position.count; ++i) vertices.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i);
      const {index} = geometry;
      const count = 3 * Math.floor((index?.count ?? position.count) / 3);
      const indices = Uint32Array.from({length: count}, (_, i) => {
        const at = isReversed && i % 3 !== 0 ? i + 3 - 2 * (i % 3) : i;
        return index ? index.getX(at) : at;
      });
      const box = new THREE.Box3().setFromArray(vertices), isFinite = vertices.every(Number.isFinite);
      made = {mesh: new this.#occlude.OccluderMesh(isFinite ? {vertices, indices} : {vertices: [], indices: []}), box, key, users: 0};
      this.#shapes.set(key, made);
    }
    ++made.users;
    return made;
  }
}

const matrixOf = (camera: THREE.Camera) => new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);

function cameraOf(camera: THREE.Camera, matrix: THREE.Matrix4): MatrixCamera {
  const isReversed = (camera as {reversedDepth?: boolean}).reversedDepth === true;
  const isZeroToW = isReversed || camera.coordinateSystem === THREE.WebGPUCoordinateSystem;
  return {matrix: matrix.elements, depth: isZeroToW ? "zero_to_w" : "minus_w_to_w", nearer: isReversed ? "greater" : "less"};
}

/** Where a mesh is: once, or once for each instance. */
function partsOf(mesh: THREE.Mesh, shape: Shape): Part[] {
  if (!(mesh instanceof THREE.InstancedMesh)) return [{shape, matrix: mesh.matrixWorld}];
  return Array.from({length: mesh.count}, (_, i) => {
    const matrix = new THREE.Matrix4();
    mesh.getMatrixAt(i, matrix);
    return {shape, matrix: matrix.premultiply(mesh.matrixWorld)};
  });
}
const placementsOf = (mesh: THREE.Mesh, shape: Shape): number[] => partsOf(mesh, shape).flatMap(({matrix}) => matrix.elements);

/** The box of all parts in the world: six numbers. One without a place, which is always drawn, if there are none. */
function boxOf(parts: readonly Part[]): number[] {
  const all = new THREE.Box3();
  for (const {shape, matrix} of parts) all.union(shape.box.clone().applyMatrix4(matrix));
  const isSomewhere = !all.isEmpty() && [...all.min.toArray(), ...all.max.toArray()].every(Number.isFinite);
  return !isSomewhere ? [-1e300, -1e300, -1e300, 1e300, 1e300, 1e300] : [...all.min.toArray(), ...all.max.toArray()];
}

const materialsOf = (mesh: THREE.Mesh): THREE.Material[] => (Array.isArray(mesh.material) ? mesh.material : [mesh.material]);

const defaultCompile = THREE.Material.prototype.onBeforeCompile;

/** Whether the mesh is drawn where its vertices are, behind what hides it, and does nothing else. */
function staysInBox(mesh: THREE.Mesh): boolean {
  const {geometry} = mesh;
  const isPlain = !(mesh instanceof THREE.SkinnedMesh) && !(mesh instanceof THREE.BatchedMesh);
  const hasMorphs = Object.keys(geometry.morphAttributes).length > 0;
  return isPlain && !hasMorphs && geometry.getAttribute("position") !== undefined && materialsOf(mesh).every(isSimple);
}

function isSimple(material: THREE.Material): boolean {
  const {displacementMap, wireframe, positionNode, vertexNode} = material as THREE.Material & Record<string, unknown>;
  const isPatched = material.onBeforeCompile !== defaultCompile || positionNode || vertexNode;
  const hasOwnShader = material instanceof THREE.ShaderMaterial || isPatched;
  const isDrawnBehind = material.depthTest && material.depthFunc === THREE.LessEqualDepth && !material.polygonOffset;
  return !hasOwnShader && !displacementMap && !wireframe && isDrawnBehind && !material.stencilWrite;
}

/** From which sides the mesh hides; undefined: it hides nothing. */
function hidingSideOf(mesh: THREE.Mesh): THREE.Side | undefined {
  const materials = materialsOf(mesh), {side} = materials[0]!;
  const {drawRange, groups} = mesh.geometry;
  const isWhole = drawRange.start === 0 && drawRange.count === Infinity && (!Array.isArray(mesh.material) || groups.length === 1);
  return isWhole && materials.every(material => isOpaque(material) && material.side === side) ? side : undefined;
}

function isOpaque(material: THREE.Material): boolean {
  const {transmission = 0} = material as THREE.Material & {transmission?: number};
  const isTested = material.alphaTest !== 0 || material.alphaHash || material.alphaToCoverage;
  const isSolid = !material.transparent && !isTested && transmission === 0;
  const isNormal = material.blending === THREE.NormalBlending || material.blending === THREE.NoBlending;
  return isSolid && isNormal && material.visible && material.depthWrite && material.colorWrite && !material.clippingPlanes?.length;
}

function geometrySignatureOf(geometry: THREE.BufferGeometry): string {
  const position = geometry.getAttribute("position");
  const {version} = "data" in position ? position.data : (position as THREE.BufferAttribute);
  return `${geometry.id} ${position.count} ${version} ${geometry.index?.count} ${geometry.index?.version}`;
}

/** Changes with all of which objects and occluders are made, but for where the mesh is. */
function signatureOf(mesh: THREE.Mesh): string {
  const instances = mesh instanceof THREE.InstancedMesh ? `${mesh.count} ${mesh.instanceMatrix.version}` : "";
  return `${geometrySignatureOf(mesh.geometry)} ${hidingSideOf(mesh)} ${instances}`;
}
