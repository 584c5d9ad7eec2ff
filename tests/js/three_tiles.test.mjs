// SPDX-License-Identifier: MIT
// The example of 3D Tiles in Chromium: tiles come and go along a walk, and pictures with and without culling are equal to the pixel.
import assert from "node:assert/strict";
import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";

import {needsBrowser, resultOf} from "./browser.mjs";
import {cube, need, project, random} from "./common.mjs";
import {glbOf} from "./gltf.mjs";

/** A box as triangles. */
function meshOf(box) {
  const {vertices, indices} = cube(box);
  const triangles = [0, 1, 2, 3, 4, 5].flatMap(f => [0, 1, 2, 0, 2, 3].map(k => indices[4 * f + k]));
  return {vertices: Float32Array.from(vertices), indices: Uint32Array.from(triangles)};
}

const volumeOf = ([x0, y0, z0, x1, y1, z1]) =>
  ({box: [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2, (x1 - x0) / 2, 0, 0, 0, (y1 - y0) / 2, 0, 0, 0, (z1 - z0) / 2]});

/** A ground, and 100 blocks on it: each a tile with towers, in the place of which one has towers and small things, where it is near. */
function writeTileset(folder, next) {
  const glb = (name, boxes) => writeFileSync(join(folder, name), glbOf(boxes.map(meshOf), next));
  const children = Array.from({length: 100}, (_, i) => {
    const x = 30 * (i % 10) - 150, y = 30 * Math.floor(i / 10) - 150;
    const towers = [[x + 3, y + 3, 0, x + 14, y + 26, 8 + 20 * next()], [x + 16, y + 5, 0, x + 26, y + 24, 8 + 20 * next()]];
    const things = Array.from({length: 20}, () => {
      const [u, v] = [x + 28 * next(), y + 28 * next()];
      return [u, v, 0, u + 0.5 + next(), v + 0.5 + next(), 3 * next()];
    });
    glb(`far${i}.glb`, towers);
    glb(`near${i}.glb`, [...towers, ...things]);
    const boundingVolume = volumeOf([x, y, 0, x + 30, y + 30, 30]);
    const near = {boundingVolume, geometricError: 0, content: {uri: `near${i}.glb`}};
    return {boundingVolume, geometricError: 8, refine: "REPLACE", content: {uri: `far${i}.glb`}, children: [near]};
  });
  glb("ground.glb", [[-160, -160, -1, 160, 160, 0]]);
  const boundingVolume = volumeOf([-160, -160, -1, 160, 160, 30]);
  const root = {boundingVolume, geometricError: 1000, refine: "ADD", content: {uri: "ground.glb"}, children};
  writeFileSync(join(folder, "tileset.json"), JSON.stringify({asset: {version: "1.1"}, geometricError: 2000, root}));
}

const example = `${project}culler/js/example/3d-tiles`;
const needed = need(`${example}/node_modules`, "node_modules in example/3d-tiles (npm ci --prefix culler/js/example/3d-tiles)");
test("a walk through a tileset", needsBrowser.skip ? needsBrowser : needed, async () => {
  const made = mkdtempSync(join(tmpdir(), "occlude-tiles-"));
  try {
    writeTileset(made, random(5));
    const result = await resultOf("tiles.html", {made, example});
    console.log(JSON.stringify(result));
    assert.deepEqual([result.error, result.frames, result.different, result.isRestored], [undefined, 40, 0, true]);
    assert.ok(result.tiles > 20 && result.changes > 10, "tiles come and go");
    assert.ok(result.triangles < 0.7 * result.allTriangles, "a good part is left out");
  } finally {
    rmSync(made, {recursive: true});
  }
});

test("tiles that are hidden are loaded last, and those of other tilesets as they were", needed, async () => {
  const {OcclusionPlugin} = await import(`${example}/occlusion_plugin.mjs`);
  const {Matrix4} = await import(`${example}/node_modules/three/build/three.module.js`);
  const asked = [], hides = {isHidden: ({min}) => (asked.push(min.x), min.x > 5)};
  const tiles = {frameCount: 1, group: {matrixWorld: new Matrix4().makeTranslation(1, 0, 0)}};
  for (const name of ["downloadQueue", "parseQueue"]) tiles[name] = {priorityCallback: (a, b) => a.error - b.error};
  const {priorityCallback} = tiles.downloadQueue;
  const plugin = new OcclusionPlugin(hides, {});
  plugin.init(tiles);
  const tile = (x, error, renderer = tiles) =>
    ({error, internal: {renderer}, engineData: {boundingVolume: {getAABB: box => (box.min.set(x, 0, 0), box.max.set(x, 1, 1))}}});
  const all = [tile(9, 4), tile(1, 1), tile(8, 3), tile(2, 2), tile(9, 2.5, {})];
  // Those that are loaded first come last.
  assert.deepEqual(all.toSorted(tiles.parseQueue.priorityCallback).map(({error}) => error), [3, 4, 1, 2, 2.5]);
  assert.deepEqual(asked.sort(), [10, 2, 3, 9].sort(), "each is asked for once in a frame");
  tiles.frameCount = 2;
  assert.equal(plugin.isHidden(all[0]), true);
  assert.equal(asked.length, 5);
  plugin.dispose();
  assert.equal(tiles.downloadQueue.priorityCallback, priorityCallback);
});
