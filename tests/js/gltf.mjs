// SPDX-License-Identifier: MIT
// Models of the shared folder as glTF: many meshes, as an application would have them.
import {readFileSync} from "node:fs";

/** Of a PLY that is little-endian, with three floats for each vertex, and triangles alone. */
export function readPly(file) {
  const bytes = readFileSync(file), head = bytes.subarray(0, 4096).toString("latin1");
  const count = what => Number(new RegExp(`element ${what} (\\d+)`).exec(head)[1]);
  const start = head.indexOf("end_header\n") + "end_header\n".length, vertexBytes = 12 * count("vertex");
  const vertices = new Float32Array(bytes.buffer.slice(bytes.byteOffset + start, bytes.byteOffset + start + vertexBytes));
  const indices = new Uint32Array(3 * count("face"));
  for (let i = 0, at = start + vertexBytes; i < indices.length; i += 3, at += 13) {
    for (let k = 0; k < 3; ++k) indices[i + k] = bytes.readUInt32LE(at + 1 + 4 * k);
  }
  return {vertices, indices};
}

/** For each vertex one of those that it hangs together with, the same for all of these. */
function componentsOf({vertices, indices}) {
  const parent = Uint32Array.from({length: vertices.length / 3}, (_, i) => i);
  const find = i => {
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (let i = 0; i < indices.length; ++i) parent[find(indices[i])] = find(indices[i - (i % 3)]);
  return parent.map((_, i) => find(i));
}

/** What hangs together, in groups of at most about so many triangles that are near each other: loops of three vertices. */
function groupsOf(model, most) {
  const {vertices, indices} = model, component = componentsOf(model), loops = new Map();
  for (let i = 0; i < indices.length; ++i) {
    const of = component[indices[i]];
    if (!loops.has(of)) loops.set(of, []);
    loops.get(of).push(indices[i]);
  }
  const split = parts => {
    if (parts.length === 1 || parts.reduce((sum, [, loop]) => sum + loop.length, 0) <= 3 * most) return [parts.flatMap(([, loop]) => loop)];
    const at = axis => ([v]) => vertices[3 * v + axis];
    const extent = axis => parts.map(at(axis)).reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
    const [x, y] = [extent(0), extent(1)].map(([low, high]) => high - low), place = at(x > y ? 0 : 1);
    const sorted = parts.toSorted((a, b) => place(a) - place(b)), half = parts.length >> 1;
    return [...split(sorted.slice(0, half)), ...split(sorted.slice(half))];
  };
  return split([...loops]);
}

/** The model as about so many meshes. */
export function meshesOf(model, wanted) {
  return groupsOf(model, model.indices.length / 3 / wanted).map(loop => {
    const numbers = new Map(), used = [];
    const indices = Uint32Array.from(loop, v => {
      if (!numbers.has(v)) numbers.set(v, numbers.size), used.push(v);
      return numbers.get(v);
    });
    return {vertices: Float32Array.from(used.flatMap(v => [...model.vertices.subarray(3 * v, 3 * v + 3)])), indices};
  });
}

/** A .glb with a node for each mesh, each in its own colour, and z upwards. */
export function glbOf(meshes, next) {
  const parts = [], views = [], accessors = [];
  const add = (array, target, accessor) => {
    views.push({buffer: 0, byteOffset: parts.reduce((sum, part) => sum + part.byteLength, 0), byteLength: array.byteLength, target});
    parts.push(Buffer.from(array.buffer, array.byteOffset, array.byteLength));
    return accessors.push({bufferView: views.length - 1, ...accessor}) - 1;
  };
  const primitives = meshes.map(({vertices, indices}, material) => {
    const at = k => vertices.filter((_, i) => i % 3 === k);
    const [min, max] = [Math.min, Math.max].map(pick => [0, 1, 2].map(k => at(k).reduce((a, b) => pick(a, b))));
    const position = add(vertices, 34962, {componentType: 5126, count: vertices.length / 3, type: "VEC3", min, max});
    const loop = add(indices, 34963, {componentType: 5125, count: indices.length, type: "SCALAR"});
    return {attributes: {POSITION: position}, indices: loop, material};
  });
  const json = {
    asset: {version: "2.0"},
    scene: 0,
    scenes: [{nodes: [0]}],
    nodes: [{rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2], children: meshes.map((_, i) => i + 1)}, ...meshes.map((_, mesh) => ({mesh}))],
    meshes: primitives.map(primitive => ({primitives: [primitive]})),
    materials: meshes.map(() => {
      const pbrMetallicRoughness = {baseColorFactor: [next(), next(), next(), 1], metallicFactor: 0};
      return {doubleSided: true, pbrMetallicRoughness};
    }),
    buffers: [{byteLength: parts.reduce((sum, part) => sum + part.byteLength, 0)}],
    bufferViews: views,
    accessors,
  };
  const chunk = (bytes, type, filler) => {
    const body = Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]), head = Buffer.alloc(8);
    head.writeUInt32LE(body.length, 0);
    head.write(type, 4, "latin1");
    return Buffer.concat([head, body]);
  };
  const body = Buffer.concat([chunk(Buffer.from(JSON.stringify(json)), "JSON", " "), chunk(Buffer.concat(parts), "BIN\0", 0)]);
  const head = Buffer.alloc(12);
  head.write("glTF", 0, "latin1");
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([head, body]);
}
