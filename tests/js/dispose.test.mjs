// SPDX-License-Identifier: MIT
// Memory: what is disposed of, what is forgotten, and 10,000 frames. Needs --expose-gc.
import assert from "node:assert/strict";
import {test} from "node:test";
import {setTimeout as pause} from "node:timers/promises";

import {alongX, at, cube, load, random, wall} from "./common.mjs";

const occlude = await load();

test("what was disposed of is refused by name; twice is nothing", () => {
  const scene = new occlude.Scene(), view = new occlude.View(), mesh = new occlude.OccluderMesh(wall);
  const culler = new occlude.Culler(wall), held = new occlude.HeldSceneCull(scene);
  for (const each of [view, mesh, culler, held]) each.dispose(), each.dispose();
  assert.throws(() => scene.cull(alongX, view), {code: "disposed", message: "the View was disposed of"});
  assert.throws(() => scene.addOccluder(mesh), {code: "disposed", message: "the OccluderMesh was disposed of"});
  assert.throws(() => held.cull(alongX, 0), {code: "disposed", message: "the HeldSceneCull was disposed of"});
  assert.throws(() => culler.cull(alongX, new occlude.ModelView()), {code: "disposed", message: "the Culler was disposed of"});
  scene.dispose();
  assert.throws(() => scene.update(), {code: "disposed", message: "the Scene was disposed of"});
  assert.equal(typeof Symbol.dispose === "symbol" ? typeof view[Symbol.dispose] : "function", "function");
});

test("occluders keep their mesh, and held culls their scene", () => {
  const scene = new occlude.Scene(), mesh = new occlude.OccluderMesh(wall);
  scene.addObjects([20, 0, 0, 21, 1, 1]);
  scene.addOccluder(mesh);
  mesh.dispose();
  scene.update();
  const held = new occlude.HeldSceneCull(scene);
  scene.dispose();
  assert.equal(held.cull(alongX, 0).statistics.hidden, 1);
  held.dispose();
});

/** A world with everything in it, made, used and left or disposed of. */
function useAll(isDisposed) {
  const scene = new occlude.Scene(), view = new occlude.View(), mesh = new occlude.OccluderMesh(cube([9, -5, -5, 10, 5, 5]));
  const next = random(4);
  const boxes = Float64Array.from({length: 6000}, (_, i) => (i % 6 < 3 ? 20 : 21) + (i % 6 < 3 ? 0 : next()));
  scene.addObjects(boxes);
  scene.addOccluder(mesh);
  scene.update();
  scene.cull(alongX, view);
  const held = new occlude.HeldSceneCull(scene, {later: task => task()});
  for (let i = 0; i < 5; ++i) held.cull(alongX, i / 60);
  const culler = new occlude.Culler(cube([9, -5, -5, 10, 5, 5])), modelView = new occlude.ModelView();
  culler.cull(alongX, modelView);
  if (isDisposed) for (const each of [scene, view, mesh, held, culler, modelView]) each.dispose();
}

test("memory is steady when worlds are made and disposed of", () => {
  for (let i = 0; i < 20; ++i) useAll(true);
  const {memoryBytes} = occlude;
  for (let i = 0; i < 200; ++i) useAll(true);
  assert.equal(occlude.memoryBytes, memoryBytes);
});

test("what is forgotten is freed", {skip: globalThis.gc ? false : "skipped: no --expose-gc"}, async () => {
  const collect = async () => {
    for (let k = 0; k < 5; ++k) globalThis.gc(), await pause(1);
  };
  for (let i = 0; i < 20; ++i) useAll(false), await collect();
  const {memoryBytes} = occlude;
  for (let i = 0; i < 60; ++i) useAll(false), await collect();
  assert.equal(occlude.memoryBytes, memoryBytes);
});

test("memory is steady over 10,000 frames, of a world that changes", () => {
  const scene = new occlude.Scene(), view = new occlude.View(), mesh = new occlude.OccluderMesh(cube([-1, -4, -4, 1, 4, 4]));
  const held = new occlude.HeldSceneCull(scene, {later: task => task()});
  const next = random(5);
  const box = () => {
    const low = [60 * next() - 30, 60 * next() - 30, 10 * next()];
    return [...low, ...low.map(x => x + 1)];
  };
  const ids = scene.addObjects(Array.from({length: 300}, box).flat(), {moves: true});
  const walls = scene.addOccluders(mesh, Array.from({length: 30}, () => at(60 * next() - 30, 60 * next() - 30, 0)).flat());
  let memoryBytes = 0;
  for (let f = 0; f < 10000; ++f) {
    const i = f % ids.length;
    scene.moveObjects([ids[i]], box());
    if (f % 10 === 0) {
      scene.removeObjects([ids[i]]);
      ids[i] = scene.addObject(box(), {moves: true});
      scene.moveOccluders([walls[f % 30]], at(60 * next() - 30, 60 * next() - 30, 0));
    }
    scene.update();
    const camera = {eye: [20 * Math.cos(f / 100), 20 * Math.sin(f / 100), 2], target: [0, 0, 2]};
    scene.cull(camera, view);
    held.cull(camera, f / 60);
    if (f % 100 === 0) assert.equal(scene.why([ids[i]], view).length, 1);
    if (f === 3000) memoryBytes = occlude.memoryBytes;
  }
  assert.equal(occlude.memoryBytes, memoryBytes);
});
