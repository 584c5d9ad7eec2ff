// SPDX-License-Identifier: MIT
// A model that stands still: a grid of towers, and the ranges of its index buffer that a frame draws.
// Run: node example/model.mjs. It prints:
// > 3200 triangles
// > from 3: 162 triangles in 21 draw calls, 3028 hidden
// > from 90: 280 triangles in 39 draw calls, 2250 hidden
// > from 180: 308 triangles in 39 draw calls, 2744 hidden
import {load} from "occlude";

const occlude = await load();
const vertices = [], indices = [];
for (let i = 0; i < 400; ++i) {
  const x = 10 * (i % 20), y = 10 * Math.floor(i / 20), top = 5 + ((7 * i) % 20), first = vertices.length / 3;
  for (const z of [0, top]) vertices.push(x, y, z, x + 7, y, z, x + 7, y + 7, z, x, y + 7, z);
  for (const [a, b] of [[0, 1], [1, 2], [2, 3], [3, 0]]) indices.push(a, b, b + 4, a, b + 4, a + 4);
  for (let k = indices.length - 24; k < indices.length; ++k) indices[k] += first;
}
const culler = new occlude.Culler({vertices, indices});
console.log(`${culler.order.length} triangles`);

// The index buffer in the order of the culler: each range of a frame is a draw call.
const buffer = new Uint32Array(indices.length);
culler.order.forEach((p, i) => buffer.set(indices.slice(3 * p, 3 * p + 3), 3 * i));

const view = new occlude.ModelView();
for (const x of [3, 90, 180]) {
  const {drawn, statistics} = culler.cull({eye: [x, -2, 2], target: [100, 100, 2]}, view, {margin: occlude.marginFor(1080)});
  const triangles = statistics.drawnPolygons, calls = drawn.length / 2;
  console.log(`from ${x}: ${triangles} triangles in ${calls} draw calls, ${statistics.hiddenPolygons} hidden`);
  // for (let i = 0; i < drawn.length; i += 2) gl.drawElements(gl.TRIANGLES, 3 * drawn[i + 1], gl.UNSIGNED_INT, 12 * drawn[i]);
}
