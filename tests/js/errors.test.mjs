// SPDX-License-Identifier: MIT
// What is refused, with the texts of the C interface, and that it changes nothing.
import assert from "node:assert/strict";
import {test} from "node:test";

import {alongX, at, load, occludeModule, wall} from "./common.mjs";

const occlude = await load();
const {OccludeError} = await occludeModule();

const refuses = (call, code, message) =>
  assert.throws(call, error => {
    assert.ok(error instanceof OccludeError);
    assert.deepEqual([error.code, error.message, error.name], [code, message, "OccludeError"]);
    return true;
  });

test("texts are those of the C interface", () => {
  const scene = new occlude.Scene(), view = new occlude.View();
  const box = scene.addObject([0, 0, 0, 1, 1, 1]);
  const cases = [
    [() => scene.addObjects([0, 0, 0, 1, 1, 1, 0, 0, 0, -1, 1, 1]), "invalid_argument", "box 1: box has min > max"],
    [() => scene.cull({...alongX, fovY: 180}, view), "invalid_argument", "camera: the opening must be from 0.001 to 179 degrees"],
    [() => scene.cull({matrix: at(0, 0, 0)}, view), "invalid_argument", "depth of the camera is not said"],
    [() => new occlude.OccluderMesh({vertices: [0, 0, 0], indices: [0, 0, 1]}), "invalid_argument",
     "polygon 0: corner 2 is vertex 1 of 1"],
    [() => new occlude.Culler({vertices: [], indices: []}), "invalid_argument", "the model has no polygon"],
    [() => scene.why([box], view), "invalid_argument", "the view has no frame"],
  ];
  for (const [call, code, text] of cases) refuses(call, code, text);
  assert.equal(scene.objects, 1);
});

test("ids of what was removed, of another scene and of the other kind are refused, and nothing is done", () => {
  const scene = new occlude.Scene(), other = new occlude.Scene();
  const [gone, stays] = scene.addObjects([0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3]);
  const foreign = other.addObject([0, 0, 0, 1, 1, 1]);
  const occluder = scene.addOccluder(new occlude.OccluderMesh(wall));
  scene.removeObjects([gone]);
  for (const ids of [[stays, gone], [stays, foreign], [stays, occluder], [stays, 0n]]) {
    assert.throws(() => scene.removeObjects(ids), {code: "unknown_id", message: /^object 1: /});
    assert.throws(() => scene.enableObjects(ids, false), {code: "unknown_id"});
    assert.throws(() => scene.moveObjects(ids, [0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1]), {code: "unknown_id"});
  }
  assert.throws(() => scene.removeOccluders([occluder, stays]), {code: "unknown_id"});
  assert.deepEqual([scene.objects, scene.occluders, scene.hasObject(stays)], [1, 1, true]);
});

test("what JavaScript alone can give wrong", () => {
  const scene = new occlude.Scene(), view = new occlude.View();
  const mesh = new occlude.OccluderMesh(wall);
  const refused = [
    [() => scene.addObjects([1, 2, 3]), "boxes: 3 numbers are no multiple of 6"],
    [() => scene.addObject([0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1]), "2 boxes where one is needed"],
    [() => scene.addObject([]), "0 boxes where one is needed"],
    [() => scene.moveObjects([], [0, 0, 0, 1, 1, 1]), "1 boxes of 0 objects"],
    [() => scene.addOccluder(mesh, [1, 2]), "placement: 2 numbers where 16 are needed"],
    [() => scene.addOccluders(mesh, at(0, 0, 0).map((x, i) => (i === 15 ? 2 : x))),
     "placement 0: the last row of the matrix is not 0, 0, 0, 1"],
    [() => scene.cull({eye: [0, 0], target: [1, 0, 0]}, view), "eye: 2 numbers where 3 are needed"],
    [() => scene.cull({...alongX, projection: "fisheye"}, view), 'projection is "fisheye", must be one of perspective, orthographic'],
    [() => new occlude.OccluderMesh({...wall, indices: [0, 1, 2.5, 3]}), "indices: 2.5 is not a whole number from 0 to 4294967295"],
    [() => new occlude.OccluderMesh({...wall, indices: [0, 1, -1, 3]}), "indices: -1 is not a whole number from 0 to 4294967295"],
    [() => new occlude.OccluderMesh({...wall, seeThrough: [0, 1]}), "seeThrough: 2 numbers of 1 polygons"],
    [() => new occlude.Culler(wall, {leafSize: 1.5}), "leafSize: 1.5 is not a whole number from 0 to 4294967295"],
    [() => scene.hasObject(3), "an id is a bigint"],
  ];
  for (const [call, text] of refused) refuses(call, "invalid_argument", text);
  assert.equal(scene.objects, 0);
});

test("what belongs to one module is refused by another", async () => {
  const other = await load();
  const scene = new occlude.Scene();
  assert.throws(() => scene.cull(alongX, new other.View()), {code: "invalid_argument", message: "the View is of another module"});
  assert.throws(() => scene.addOccluder(new other.OccluderMesh(wall)), {code: "invalid_argument"});
  assert.throws(() => new occlude.HeldSceneCull(new other.Scene()), {code: "invalid_argument"});
});
