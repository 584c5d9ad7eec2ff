// SPDX-License-Identifier: MIT
// Reads files: glTF and OBJ by the loaders of three.js, and PLY.
import * as THREE from "three";
import {DRACOLoader} from "three/addons/loaders/DRACOLoader.js";
import {GLTFLoader} from "three/addons/loaders/GLTFLoader.js";
import {MTLLoader} from "three/addons/loaders/MTLLoader.js";
import {OBJLoader} from "three/addons/loaders/OBJLoader.js";
import {MeshoptDecoder} from "three/addons/libs/meshopt_decoder.module.js";

import {Builder, gather, type Known} from "./builder.mjs";
import {ColourOf} from "./materials.mjs";
import {orbit} from "./flight.mjs";
import type {Model, NamedPlace} from "./model.mjs";
import {readPly} from "./ply.mjs";
import {add, type Point} from "./points.mjs";

/** What is dropped together, by name: a model, and what it refers to. */
export type Files = ReadonlyMap<string, Blob>;

const kinds = /\.(gltf|glb|obj|ply)$/i;

/** 23 bits number triangles (builder.mts). */
const kMostTriangles = 2 ** 23;

export async function read(files: Files): Promise<Model> {
  const name = [...files.keys()].find(file => kinds.test(file));
  if (name === undefined) throw new Error(`${[...files.keys()].join(", ") || "nothing"}: no glTF, OBJ or PLY file`);
  if (/\.ply$/i.test(name)) return modelOfPly(name, new Uint8Array(await files.get(name)!.arrayBuffer()));
  const urls = new Map([...files].map(([file, blob]) => [file, URL.createObjectURL(blob)]));
  const manager = new THREE.LoadingManager();
  manager.setURLModifier(url => urls.get(decodeURIComponent(url.split(/[\\/]/).at(-1)!)) ?? url);
  try {
    return await modelOf(name, await load(name, files, manager));
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url);
  }
}

interface Loaded {
  readonly root: THREE.Object3D;
  readonly cameras: readonly THREE.Camera[];
  /** What the format says. */
  readonly up: Point | undefined;
  readonly isColoured: boolean;
}

async function load(name: string, files: Files, manager: THREE.LoadingManager): Promise<Loaded> {
  const blob = files.get(name)!;
  if (/\.obj$/i.test(name)) {
    const loader = new OBJLoader(manager), library = [...files.keys()].find(file => /\.mtl$/i.test(file));
    if (library !== undefined) loader.setMaterials(await materialsIn(await files.get(library)!.text(), manager));
    return {root: loader.parse(await blob.text()), cameras: [], up: undefined, isColoured: library !== undefined};
  }
  const draco = new DRACOLoader(manager).setDecoderPath("draco/");
  const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder).setDRACOLoader(draco);
  const {scene, cameras} = await loader.parseAsync(await blob.arrayBuffer(), "");
  return {root: scene, cameras, up: [0, 1, 0], isColoured: true};
}

async function materialsIn(text: string, manager: THREE.LoadingManager) {
  const creator = new MTLLoader(manager).parse(text, "");
  // Pictures of textures come later than the materials that have them.
  const isLoaded = new Promise<void>(resolve => (manager.onLoad = resolve));
  manager.itemStart("materials");
  creator.preload();
  manager.itemEnd("materials");
  await isLoaded;
  return creator;
}

function modelOfPly(name: string, bytes: Uint8Array<ArrayBuffer>): Model {
  const {corners, colours, faces, isColoured} = readPly(bytes, name), builder = new Builder();
  requireFew(name, faces.length);
  builder.add(name, ...withoutBroken(corners, colours, faces));
  return modelIn(builder, {name, isColoured, cameras: [], facet: "polygon"}, undefined);
}

function requireFew(name: string, triangles: number): void {
  if (triangles > kMostTriangles) throw new Error(`${name}: more than ${kMostTriangles} triangles`);
}

function modelOf(name: string, {root, cameras, up, isColoured}: Loaded): Model {
  root.updateMatrixWorld(true);
  const builder = new Builder();
  let count = 0;
  root.traverseVisible(object => {
    if (!(object instanceof THREE.Mesh)) return;
    count += addMesh(builder, object);
    requireFew(name, count);
  });
  return modelIn(builder, {name, isColoured, cameras: cameras.map(placeOfCamera)}, up);
}

function modelIn(builder: Builder, known: Omit<Known, "up" | "flightIn">, up: Point | undefined): Model {
  if (builder.isEmpty) throw new Error(`${known.name}: no triangles`);
  const model = builder.model({...known, up: up ?? [0, 0, 1], flightIn: box => orbit(box, up ?? [0, 0, 1])});
  return up === undefined ? turned(model, likelyUp(known.name, model)) : model;
}

/** The same model with another direction up. */
export const turned = (model: Model, up: Point): Model => ({...model, up, flight: orbit(model.box, up)});

/** Where the file does not say: the direction in which the model is smallest, or the custom of the format if it is about a cube. */
function likelyUp(name: string, {box: {low, high}}: Model): Point {
  const y = high[1] - low[1], z = high[2] - low[2], isYCustom = /\.obj$/i.test(name);
  return (isYCustom ? y <= 1.2 * z : 1.2 * y < z) ? [0, 1, 0] : [0, 0, 1];
}

function placeOfCamera(camera: THREE.Camera, i: number): NamedPlace {
  const eye = camera.getWorldPosition(new THREE.Vector3()).toArray() as unknown as Point;
  const ahead = camera.getWorldDirection(new THREE.Vector3()).toArray() as unknown as Point;
  return {name: nameOf(camera) || `Camera ${i + 1}`, eye, target: add(eye, ahead)};
}

/** As in the file: of glTF the loader changes names, and keeps them aside. */
const nameOf = ({userData, name}: THREE.Object3D): string => (typeof userData.name === "string" ? userData.name : name);

/** Returns the number of triangles. */
function addMesh(builder: Builder, mesh: THREE.Mesh): number {
  const {geometry} = mesh, position = geometry.getAttribute("position");
  if (position === undefined) return 0;
  const index = indexOf(geometry), {colours, kept} = coloursOf(mesh, index);
  const instances = mesh instanceof THREE.InstancedMesh ? mesh.count : 1;
  const place = new THREE.Matrix4(), vertex = new THREE.Vector3();
  for (let instance = 0; instance < instances; ++instance) {
    place.copy(mesh.matrixWorld);
    if (mesh instanceof THREE.InstancedMesh) {
      mesh.getMatrixAt(instance, place);
      place.premultiply(mesh.matrixWorld);
    }
    const points = new Float32Array(3 * position.count);
    for (let i = 0; i < position.count; ++i) mesh.getVertexPosition(i, vertex).applyMatrix4(place).toArray(points, 3 * i);
    const corners = new Float32Array(3 * kept.length);
    kept.forEach((at, i) => corners.set(points.subarray(3 * index[at]!, 3 * index[at]! + 3), 3 * i));
    const name = nameOf(mesh) || (mesh.parent && nameOf(mesh.parent)) || "Mesh";
    builder.add(instances > 1 ? `${name}, instance ${instance + 1}` : name, ...withoutBroken(corners, colours));
  }
  return (instances * kept.length) / 3;
}

function indexOf(geometry: THREE.BufferGeometry): Uint32Array {
  const {index} = geometry, count = index?.count ?? geometry.getAttribute("position").count;
  return Uint32Array.from({length: 3 * Math.floor(count / 3)}, (_, i) => (index ? index.getX(i) : i));
}

/** Of the corners that groups draw: which, and four bytes each. */
function coloursOf(mesh: THREE.Mesh, index: Uint32Array) {
  const {geometry, material} = mesh;
  const given = Array.isArray(material) ? geometry.groups : [{start: 0, count: index.length, materialIndex: 0}];
  const groups = given.map(({start, count, materialIndex = 0}) => ({
    start,
    end: Math.min(start + count, index.length),
    of: new ColourOf(geometry, Array.isArray(material) ? material[materialIndex]! : material),
  }));
  const kept = new Uint32Array(groups.reduce((sum, {start, end}) => sum + Math.max(0, end - start), 0));
  const colours = new Uint8Array(4 * kept.length);
  let next = 0;
  for (const {start, end, of} of groups) {
    for (let at = start; at < end; ++at, ++next) {
      kept[next] = at;
      colours.set(of.vertex(index[at]!), 4 * next);
    }
  }
  return {kept, colours};
}

/** Leaves out triangles with numbers that are none. Numbers of triangles are their own, or these. */
function withoutBroken(
  corners: Float32Array,
  colours: Uint8Array,
  numbers?: Uint32Array<ArrayBuffer>,
): [Float32Array, Uint8Array, Uint32Array<ArrayBuffer>] {
  const isWhole = (triangle: number) => corners.subarray(9 * triangle, 9 * triangle + 9).every(Number.isFinite);
  const whole = Uint32Array.from({length: corners.length / 9}, (_, t) => t).filter(isWhole);
  if (whole.length === corners.length / 9) return [corners, colours, numbers ?? whole];
  return [gather(corners, whole, 9), gather(colours, whole, 12), numbers ? gather(numbers, whole, 1) : whole];
}
