// SPDX-License-Identifier: MIT
// Scenes that are culled in a worker: no frame lacks what shows, however late answers are, while the scene changes.
import assert from "node:assert/strict";
import {test} from "node:test";
import {setTimeout as pause} from "node:timers/promises";
import {Worker} from "node:worker_threads";

import {at, dist, random} from "./common.mjs";

const {startWorker} = await import(`${dist}/worker.mjs`);

/** A worker whose replies are held back by so many milliseconds. */
async function lateWorker(delay, cull) {
  const worker = new Worker(`${dist}/worker-main.mjs`);
  const there = new MessageChannel(), here = new MessageChannel();
  worker.postMessage(there.port2, [there.port2]);
  const relay = here.port2;
  relay.onmessage = ({data}) => there.port1.postMessage(data);
  there.port1.onmessage = async ({data}) => {
    await pause(delay());
    relay.postMessage(data);
  };
  const scene = await startWorker({port: here.port1, cull});
  return {scene, stop: () => (scene.dispose(), there.port1.close(), relay.close(), worker.terminate())};
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Whether the triangle is between the points, borders included. */
function isBetween([a, b, c], eye, point) {
  const ray = minus(point, eye), u = minus(b, a), v = minus(c, a), n = cross(u, v), along = dot(n, ray);
  if (along === 0) return false;
  const t = dot(n, minus(a, eye)) / along;
  if (t <= 1e-9 || t >= 1 - 1e-9) return false;
  const at = minus([0, 1, 2].map(i => eye[i] + t * ray[i]), a), square = dot(n, n);
  const s = dot(cross(at, v), n) / square, r = dot(cross(u, at), n) / square;
  return s >= -1e-9 && r >= -1e-9 && s + r <= 1 + 1e-9;
}

const wall = {vertices: [0, -4, -4, 0, 4, -4, 0, 4, 4, 0, -4, 4], indices: [0, 1, 2, 0, 2, 3]};
const trianglesOf = m => {
  const corner = i => [0, 1, 2].map(row => [0, 1, 2].reduce((sum, k) => sum + m[4 * k + row] * wall.vertices[3 * i + k], m[12 + row]));
  return [[0, 1, 2], [0, 2, 3]].map(loop => loop.map(corner));
};

/** The same world in plain arrays. */
class World {
  boxes = new Map();
  walls = new Map();

  constructor(scene, next) {
    this.scene = scene;
    this.next = next;
    this.mesh = scene.addMesh(wall);
  }
  random(from, to) {
    return from + (to - from) * this.next();
  }
  box() {
    const low = [this.random(-30, 30), this.random(-30, 30), this.random(-3, 2)];
    return [...low, ...low.map(x => x + this.random(0.2, 1.5))];
  }
  pick(map) {
    return [...map.keys()][Math.floor(this.next() * map.size)];
  }
  placement() {
    const angle = this.random(0, 7), c = Math.cos(angle), s = Math.sin(angle), far = this.random(8, 20), a = this.random(0, 7);
    return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, far * Math.cos(a), far * Math.sin(a), 0, 1];
  }
  addBoxes(count) {
    const boxes = Array.from({length: count}, () => this.box());
    this.scene.addObjects(boxes.flat()).forEach((id, i) => this.boxes.set(id, boxes[i]));
  }
  addWall() {
    const m = this.placement();
    this.walls.set(this.scene.addOccluders(this.mesh, m)[0], trianglesOf(m));
  }

  /** One of these changes. */
  edit(...changes) {
    const what = changes[Math.floor(changes.length * this.next())];
    if (what === 0) this.addBoxes(3);
    if (what === 1) {
      const id = this.pick(this.boxes), box = this.box();
      this.scene.moveObjects([id], box);
      this.boxes.set(id, box);
    }
    if (what === 2) {
      const id = this.pick(this.boxes);
      this.scene.removeObjects([id]);
      this.boxes.delete(id);
    }
    if (what === 3) {
      const id = this.pick(this.walls), m = this.placement();
      this.scene.moveOccluders([id], m);
      this.walls.set(id, trianglesOf(m));
    }
    if (what === 4) {
      const id = this.pick(this.walls);
      this.scene.removeOccluders([id]);
      this.walls.delete(id);
      this.addWall();
    }
    if (what === 5) {
      const id = this.pick(this.boxes);
      this.scene.enableObjects([id], false);
      this.scene.enableObjects([id], true);
    }
    if (what === 6) {
      const id = this.pick(this.walls);
      this.scene.enableOccluders([id], false);
      this.walls.set(id, []);
    }
  }

  /** Whether a corner or the middle of a box shows: it is in the picture, and nothing is between it and the eye. */
  shows(box, {eye, target}) {
    const forward = minus(target, eye), length = Math.hypot(...forward), f = forward.map(x => x / length);
    const right = cross(f, [0, 0, 1]), size = Math.hypot(...right), r = right.map(x => x / size), up = cross(r, f);
    const high = Math.tan(Math.PI / 6), wide = (high * 16) / 9, triangles = [...this.walls.values()].flat();
    for (let i = 0; i < 9; ++i) {
      const point = i === 8 ? [0, 1, 2].map(k => (box[k] + box[k + 3]) / 2) : [0, 1, 2].map(k => box[(i >> k) & 1 ? k + 3 : k]);
      const v = minus(point, eye), depth = dot(v, f);
      if (depth <= 0.11 || Math.abs(dot(v, r)) > 0.999 * wide * depth || Math.abs(dot(v, up)) > 0.999 * high * depth) continue;
      if (!triangles.some(triangle => isBetween(triangle, eye, point))) return true;
    }
    return false;
  }
}

for (const [name, delay] of [["at once", () => 0], ["0 to 500 ms late", next => 500 * next()], ["500 ms late", () => 500]]) {
  test(`no frame lacks what shows when answers come ${name}`, async () => {
    const next = random(7), {scene, stop} = await lateWorker(() => delay(next), {margin: 1 / 4096});
    const world = new World(scene, next);
    world.addBoxes(400);
    for (let i = 0; i < 30; ++i) world.addWall();
    let culled = 0, unasked = 0;
    const start = performance.now();
    for (let f = 0; f < 240; ++f) {
      const seconds = (performance.now() - start) / 1000, angle = seconds / 8;
      const eye = [4 * Math.cos(angle), 4 * Math.sin(angle), 0.1 * Math.sin(seconds)];
      const towards = f % 97 > 90 ? angle + 2 : angle + Math.sin(seconds / 3) / 2; // a jump now and then
      const camera = {eye, target: [eye[0] + Math.cos(towards), eye[1] + Math.sin(towards), eye[2]]};
      if (f % 5 === 4) world.edit(0, 1, 2, 5);
      if (f % 60 === 59) world.edit(3, 4, 6);
      const {objects, isUnasked} = scene.cull(camera, seconds);
      const drawn = new Set(objects);
      assert.equal(drawn.size, objects.length);
      for (const id of drawn) assert.ok(world.boxes.has(id));
      for (const [id, box] of world.boxes) {
        if (!drawn.has(id)) assert.ok(!world.shows(box, camera), `frame ${f}: object ${id} shows`);
      }
      culled += world.boxes.size - drawn.size;
      unasked += Number(isUnasked);
      await pause(12);
    }
    console.log(`${name}: ${(culled / 240).toFixed(0)} of ${world.boxes.size} are not drawn in a frame; ${unasked} of 240 frames draw all`);
    assert.ok(culled > 240);
    await stop();
  });
}

test("a worker of its own starts, and errors of edits and of things that are not there are told", async () => {
  const scene = await startWorker();
  const [object] = scene.addObjects([5, 0, 0, 6, 1, 1]);
  const mesh = scene.addMesh({vertices: new Float32Array([10, -5, -5, 10, 5, -5, 10, 5, 5]), indices: [0, 1, 2]});
  scene.addOccluders(mesh, at(0, 0, 0), {object});
  const camera = {eye: [0, 0, 0], target: [1, 0, 0]};
  assert.deepEqual([...scene.cull(camera, 0).objects], [object]);
  for (let i = 0; i < 200 && scene.cull(camera, i / 60).isUnasked; ++i) await pause(10);
  const frame = scene.cull(camera, 9);
  assert.deepEqual([[...frame.objects], frame.isUnasked], [[object], false]);
  scene.enableObjects([object], false);
  assert.deepEqual([...scene.cull(camera, 9.1).objects], []);
  assert.throws(() => scene.removeObjects([77]), {code: "unknown_id", message: "there is no object 77"});
  assert.throws(() => scene.removeOccluders([77]), {code: "unknown_id", message: "there is no occluder 77"});
  scene.addObjects([5, 0, 0, -6, 1, 1]);
  await assert.rejects(async () => {
    for (let i = 0; i < 200; ++i) scene.cull(camera, 10 + i / 60), await pause(10);
  }, {code: "invalid_argument", message: "box 0: box has min > max"});
  scene.dispose();
  assert.throws(() => scene.cull(camera, 20), {code: "disposed"});
});
