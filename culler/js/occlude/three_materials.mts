// SPDX-License-Identifier: MIT
// Which meshes of three.js are drawn where their vertices are, and which of these hide what is behind them.
import * as THREE from "three";

import {isHooked} from "./three_batches.mjs";

/** From which sides a mesh hides; "none": it is hidden alone; "own": nobody knows what it draws. */
export type Hiding = THREE.Side | "none" | "own";

/** Materials are asked once while this is kept, for an update. */
export type Asked = Map<THREE.Material, Hiding>;

export function hidingOf(mesh: THREE.Mesh, asked: Asked): Hiding {
  if (!isPlain(mesh)) return "own";
  const {geometry, material} = mesh;
  if (Array.isArray(material)) return hidingOfGroups(geometry, material.map(each => hidingOfMaterial(each, asked)));
  const hiding = hidingOfMaterial(material, asked);
  return hiding === "own" || isWhole(geometry) ? hiding : "none";
}

/** With several materials a mesh hides only if one of them draws all of it. */
function hidingOfGroups(geometry: THREE.BufferGeometry, hidings: readonly Hiding[]): Hiding {
  if (hidings.includes("own")) return "own";
  const {groups: [group, ...others]} = geometry;
  const isOne = group !== undefined && others.length === 0 && group.start === 0 && group.count >= lengthOf(geometry);
  return isOne && isWhole(geometry) ? (hidings[group.materialIndex ?? 0] ?? "none") : "none";
}

const lengthOf = ({index, attributes}: THREE.BufferGeometry) => index?.count ?? attributes.position!.count;

const isWhole = ({drawRange}: THREE.BufferGeometry) => drawRange.start === 0 && drawRange.count === Infinity;

/** Whether the mesh draws the triangles of its geometry where they are: what is called when it is drawn may do anything. */
function isPlain(mesh: THREE.Mesh): boolean {
  const {geometry} = mesh, {count = 1} = mesh as {count?: number};
  const isMoved = mesh instanceof THREE.SkinnedMesh || hasAny(geometry.morphAttributes);
  const isCounted = count !== 1 && !(mesh instanceof THREE.InstancedMesh);
  const isFed = geometry instanceof THREE.InstancedBufferGeometry || (geometry as {indirect?: object | null}).indirect;
  const standard = mesh instanceof THREE.BatchedMesh ? THREE.BatchedMesh : THREE.Mesh;
  const isStandard = mesh.onBeforeRender === standard.prototype.onBeforeRender || isHooked(mesh);
  return !isMoved && !isCounted && !isFed && isStandard && geometry.attributes.position !== undefined;
}

function hasAny(attributes: object): boolean {
  for (const _ in attributes) return true;
  return false;
}

function hidingOfMaterial(material: THREE.Material, asked: Asked): Hiding {
  let hiding = asked.get(material);
  if (hiding === undefined) {
    hiding = !isSimple(material) ? "own" : isOpaque(material) ? material.side : "none";
    asked.set(material, hiding);
  }
  return hiding;
}

const defaultCompile = THREE.Material.prototype.onBeforeCompile;
/** Nodes that may move what is drawn, or its depth. */
const moving = ["positionNode", "vertexNode", "geometryNode", "depthNode", "fragmentNode", "outputNode", "mrtNode", "contextNode"];

/** Whether what is drawn is where its vertices are, behind what hides it, and does nothing else. */
function isSimple(material: THREE.Material): boolean {
  const {displacementMap, wireframe} = material as {displacementMap?: THREE.Texture | null; wireframe?: boolean};
  const hasOwnShader = material instanceof THREE.ShaderMaterial || material.onBeforeCompile !== defaultCompile;
  const isDrawnBehind = material.depthTest && material.depthFunc === THREE.LessEqualDepth && !material.polygonOffset;
  const isMoved = nodesOf(material).some(name => moving.includes(name));
  return !hasOwnShader && !isMoved && !displacementMap && !wireframe && isDrawnBehind && !material.stencilWrite;
}

/** The nodes that a material of WebGPURenderer has. */
function nodesOf(material: THREE.Material): string[] {
  if (!(material as {isNodeMaterial?: boolean}).isNodeMaterial) return none;
  return Object.entries(material).flatMap(([name, value]) => (name.endsWith("Node") && value ? [name] : []));
}
const none: string[] = [];

/** Whether every pixel is drawn. A node of any kind may leave some out. */
function isOpaque(material: THREE.Material): boolean {
  const {transmission = 0} = material as THREE.Material & {transmission?: number};
  const isTested = material.alphaTest !== 0 || material.alphaHash || material.alphaToCoverage;
  const isSolid = !material.transparent && !isTested && transmission === 0;
  const isNormal = material.blending === THREE.NormalBlending || material.blending === THREE.NoBlending;
  const isDrawn = material.visible && material.depthWrite && material.colorWrite && !material.clippingPlanes?.length;
  return isSolid && isNormal && isDrawn && nodesOf(material).length === 0;
}
