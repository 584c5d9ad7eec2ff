// SPDX-License-Identifier: MIT
// Scenes: objects, occluders, views, frames, and why. The example of docs/python.md, and what it leaves out.
import assert from "node:assert/strict";
import {test} from "node:test";

import {alongX, at, cube, load, occludeModule, random, wall} from "./common.mjs";

const occlude = await load();
const {slot, slots} = await occludeModule();

/** Small boxes behind the wall. */
function things(count) {
  const next = random(1);
  const boxes = new Float64Array(6 * count);
  for (let i = 0; i < count; ++i) {
    const low = [20 + 10 * next(), -2 + 4 * next(), -2 + 4 * next()];
    boxes.set([...low, ...low.map(x => x + 0.1)], 6 * i);
  }
  return boxes;
}

/** A scene with the wall and the things. */
function behindWall() {
  const scene = new occlude.Scene();
  const ids = scene.addObjects(things(1000));
  const mesh = new occlude.OccluderMesh(wall);
  const occluder = scene.addOccluder(mesh);
  scene.update();
  return {scene, ids, mesh, occluder, view: new occlude.View()};
}

test("what is behind the wall is hidden, and what moves before it is drawn", () => {
  const {scene, ids, view} = behindWall();
  const bus = scene.addObject([5, -20, 0, 9, -18, 3], {moves: true});
  scene.update();
  const frame = scene.cull(alongX, view, {frontToBack: true});
  assert.equal(frame.statistics.hidden, 1000);
  assert.equal(frame.statistics.outOfView, 1);
  assert.equal(frame.objects.length, 0);
  scene.moveObjects([bus], [5, -1, 0, 9, 1, 3]);
  scene.update();
  const next = scene.cull(alongX, view);
  assert.deepEqual([...next.objects], [bus]);
  assert.ok(next.sizes[0] > 0.5);
  assert.equal(next.distances.length, 1);
  assert.equal(frame.objects.length, 0, "a frame is the caller's own");
  assert.deepEqual(view.visibility([20, 0, 0, 21, 1, 1, -9, 0, 0, -8, 1, 1, 5, 0, 0, 6, 1, 1]), ["occluded", "out_of_view", "visible"]);
  assert.deepEqual(view.visibility({oriented: [20, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]}), ["occluded"]);
  assert.equal(new Set(slots(ids)).size, 1000);
  assert.equal(slots(ids)[7], slot(ids[7]));
});

test("why names what hides, with its corners, and the plane beyond which something is", () => {
  const {scene, ids, occluder, view} = behindWall();
  const aside = scene.addObject([5, -90, 0, 9, -88, 3]), always = scene.addObject([0, 0, 0, 1, 1, 1], {alwaysDrawn: true});
  const masked = scene.addObject([5, 0, 0, 6, 1, 1], {mask: 2}), small = scene.addObject([9, 0, 0, 9.001, 0.001, 0.001]);
  scene.update();
  const frame = scene.cull(alongX, view, {mask: 1, leastSize: 0.01});
  const [hidden, out, drawn, none, tiny] = scene.why([ids[0], aside, always, masked, small], view);
  assert.equal(hidden.reason, "hidden");
  assert.deepEqual(hidden.by.map(({occluder: by, polygon}) => [by, polygon]), [[occluder, 0]]);
  assert.deepEqual([...hidden.by[0].corners], wall.vertices);
  assert.equal(out.reason, "out_of_view");
  const [a, b, c, d] = frame.planes.slice(4 * out.plane, 4 * out.plane + 4);
  for (const x of [5, 9]) for (const y of [-90, -88]) for (const z of [0, 3]) assert.ok(a * x + b * y + c * z + d < 0);
  assert.deepEqual([drawn.reason, none.reason, tiny.reason], ["always_drawn", "in_no_layer", "too_small"]);
  assert.deepEqual(frame.statistics.drawn + frame.statistics.hidden + frame.statistics.outOfView + frame.statistics.tooSmall, 1003);
});

test("objects and occluders come, go, are disabled, masked, placed and replaced", () => {
  const {scene, ids, mesh, occluder, view} = behindWall();
  const hidden = options => (scene.update(), scene.cull(alongX, view, options).statistics.hidden);
  assert.equal(hidden(), 1000);
  scene.removeObjects(ids.slice(0, 100));
  assert.equal(hidden(), 900);
  assert.equal(scene.hasObject(ids[0]), false);
  scene.enableObjects(ids.slice(100, 200), false);
  assert.equal(hidden(), 800);
  scene.maskObjects(ids.slice(200, 300), 4);
  assert.equal(hidden({mask: 3}), 700);
  scene.enableOccluders([occluder], false);
  assert.equal(hidden(), 0);
  scene.enableOccluders([occluder], true);
  scene.maskOccluders([occluder], 4);
  assert.equal(hidden({mask: 3}), 0);
  scene.maskOccluders([occluder], 0xffffffff);
  scene.moveOccluders([occluder], at(100, 0, 0));
  assert.equal(hidden(), 0);
  scene.moveOccluders([occluder], at(0, 0, 0));
  assert.equal(hidden(), 800);
  scene.replaceOccluder(occluder, new occlude.OccluderMesh({...wall, vertices: wall.vertices.map((x, i) => (i % 3 ? x / 100 : x))}));
  assert.ok(hidden() < 100);
  const [first, second] = scene.addOccluders(mesh, [...at(0, 0, 0), ...at(1, 0, 0)], {weld: 1});
  assert.equal(hidden(), 800);
  scene.removeOccluders([first, second, occluder]);
  assert.deepEqual([hidden(), scene.occluders, scene.objects, scene.hasOccluder(first)], [0, 0, 900, false]);
  assert.ok(scene.objectBytes > 0);
});

test("an occluder hides nothing in frames without the object that draws it", () => {
  const {scene, mesh, occluder, view} = behindWall();
  scene.removeOccluders([occluder]);
  const house = scene.addObject([10, -5, -5, 10, 5, 5]);
  scene.addOccluder(mesh, undefined, {object: house});
  scene.update();
  assert.equal(scene.cull(alongX, view).statistics.hidden, 1000);
  scene.enableObjects([house], false);
  scene.update();
  assert.equal(scene.cull(alongX, view).statistics.hidden, 0);
});

test("a one-sided occluder hides from its front alone", () => {
  const {scene, mesh, occluder, view} = behindWall();
  scene.removeOccluders([occluder]);
  const [both] = scene.addOccluders(mesh, at(0, 0, 0), {oneSided: true});
  scene.update();
  const front = scene.cull(alongX, view).statistics.hidden;
  scene.moveOccluders([both], [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]); // turned by 180 degrees about x: the same side
  scene.update();
  assert.equal(scene.cull(alongX, view).statistics.hidden, front);
  scene.replaceOccluder(both, new occlude.OccluderMesh({...wall, indices: [3, 2, 1, 0]}));
  scene.update();
  assert.deepEqual([front, scene.cull(alongX, view).statistics.hidden].sort((a, b) => a - b), [0, 1000]);
});

test("matrices, eyes and several views", () => {
  const {scene, view} = behindWall();
  const matrix = [0, 0, 1, 1, -1, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, -0.2, 0];
  const other = new occlude.View();
  assert.equal(scene.cull({matrix, depth: "minus_w_to_w"}, view).statistics.hidden, 1000);
  assert.equal(scene.cull({matrix: new Float32Array(matrix), depth: "minus_w_to_w", eyes: {radius: 0.03}}, other).statistics.hidden, 1000);
  assert.equal(scene.cull({...alongX, eyes: {halfEdges: [[0, 40, 0], [0, 0, 0], [0, 0, 0]]}}, other).statistics.hidden, 0);
  const made = occlude.matrixOf({...alongX, far: 100}, "zero_to_w", "greater");
  assert.equal(scene.cull(made, other).statistics.hidden, 1000);
  assert.deepEqual([made.depth, made.nearer, made.matrix.length], ["zero_to_w", "greater", 16]);
  assert.ok(occlude.marginFor(1080) > 0 && occlude.marginFor(1080) < occlude.marginFor(360));
  assert.equal(scene.cull(alongX, view, {margin: occlude.marginFor(360)}).statistics.hidden, 1000);
});

test("a budget of little work hides less, and nothing visible", () => {
  const {scene, mesh, view} = behindWall();
  for (let i = 0; i < 50; ++i) scene.addOccluder(mesh, at(0, 40 * (i % 2 ? i : -i), 0));
  scene.update();
  const {statistics} = scene.cull({...alongX, fovY: 150}, view, {adaptive: false});
  const few = scene.cull({...alongX, fovY: 150}, view, {coverWork: 1, adaptive: false}).statistics;
  assert.ok(few.coverWork < statistics.coverWork);
  assert.ok(few.hidden <= statistics.hidden);
  assert.equal(scene.cull(alongX, view, {coverSize: [1024, 512], coverMs: 100}).statistics.hidden, 1000);
});

test("a frame ahead holds for the cameras near the way, and frames can be held against it", () => {
  const {scene, view} = behindWall();
  const near = {eye: [0.5, 0, 0], target: [1.5, 0, 0]}, region = new occlude.View();
  const ahead = occlude.ahead(near, [1, 0, 0], 1);
  assert.deepEqual(ahead.eye.map(x => Math.round(10 * x)), [10, 0, 0]);
  assert.equal(region.holdsFor(near), false);
  scene.cull(ahead, region, {toBeHeld: true});
  assert.equal(region.holdsFor(near), true);
  assert.equal(region.holdsFor({eye: [0, 9, 0], target: [1, 9, 0]}), false);
  assert.equal(scene.holds(region, near), true);
  const held = scene.cullHeld(near, region, view);
  assert.equal(held.statistics.hidden + held.statistics.outOfView, 1000);
  assert.ok(held.statistics.hidden > 900);
  assert.throws(() => scene.cullHeld({eye: [0, 9, 0], target: [1, 9, 0]}, region, view), {code: "invalid_argument"});
});

test("held culls: what shows is in every frame, most are held, and tasks are run when there is time", () => {
  const {scene} = behindWall();
  const shows = scene.addObject([9, -0.5, -0.5, 9.5, 0.5, 0.5]);
  scene.update();
  for (const mode of ["needed", "later", "at once", "never"]) {
    const tasks = [];
    const later = {needed: undefined, later: task => tasks.push(task), "at once": task => task(), never: () => {}}[mode];
    const held = new occlude.HeldSceneCull(scene, {later, way: {aside: 0.2}});
    let hidden = 0;
    for (let i = 0; i < 120; ++i) {
      const {objects, statistics} = held.cull({eye: [i / 40, 0, 0], target: [20, 0, 0]}, i / 60);
      assert.ok(objects.includes(shows), `${mode}: frame ${i}`);
      assert.equal(statistics.drawn + statistics.outOfView + statistics.hidden, 1001);
      hidden += statistics.hidden;
      for (const task of tasks.splice(0)) task();
    }
    const {frames, ofPoint, regions} = held.statistics;
    assert.deepEqual([frames, hidden > 0], [120, true]);
    if (mode === "never") assert.deepEqual([ofPoint, held.isOfPoint], [120, true]);
    else assert.ok(ofPoint < 60 && regions > 0, `${mode}: ${ofPoint} of point`);
    held.dispose();
    for (const task of tasks) task(); // of what was destroyed: nothing
  }
});

test("the same frames when regions are repeatable", () => {
  const walk = () => {
    const {scene} = behindWall();
    const held = new occlude.HeldSceneCull(scene, {repeatable: true});
    return Array.from({length: 60}, (_, i) => held.cull({eye: [i / 40, i / 90, 0], target: [20, 0, 0]}, i / 60).objects.length);
  };
  assert.deepEqual(walk(), walk());
});

test("faces", () => {
  const arrow = [0, 0, 0, 2, 2, 0, 0, 1, 0, -2, 2, 0]; // concave at its third corner
  assert.equal(occlude.isFan([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 3]), true);
  assert.equal(occlude.isFan(arrow, [1, 2, 3, 0]), false);
  assert.equal(occlude.triangulate(arrow, [1, 2, 3, 0]).length, 6);
});

test("meshes", () => {
  const mesh = new occlude.OccluderMesh({...cube([1, 2, 3, 4, 5, 6]), seeThrough: [true, false, 0, 0, 0, 0]});
  assert.equal(mesh.size, 6);
  assert.deepEqual([...mesh.box], [1, 2, 3, 4, 5, 6]);
  assert.equal(new occlude.OccluderMesh({vertices: [], indices: []}).size, 0);
  assert.match(occlude.version, /^\d+\.\d+\.\d+$/);
});
