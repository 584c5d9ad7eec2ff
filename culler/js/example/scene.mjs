// SPDX-License-Identifier: MIT
// A row of houses, with things in the courts behind it, and a bus that drives along behind one of them.
// Run: node example/scene.mjs. It prints:
// > at 0.0 s: 2 of 43 drawn, 41 hidden
// > at 1.0 s: 3 of 43 drawn, 40 hidden
// > the bus is drawn now
// > thing 5 is hidden by 2 polygons
import {load} from "occlude";

const occlude = await load();
const scene = new occlude.Scene();

// Each house is an object with a box, and its walls are an occluder: a mesh that lies inside of what is drawn.
const walls = new occlude.OccluderMesh({
  vertices: [0, 0, 0, 0, 19, 0, 0, 19, 9, 0, 0, 9],
  indices: [0, 1, 2, 0, 2, 3],
});
for (const y of [-20, 1]) {
  const house = scene.addObject([10, y, 0, 18, y + 19, 9]);
  scene.addOccluder(walls, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, y, 0, 1], {object: house});
}
const boxes = new Float32Array(6 * 40);
for (let i = 0; i < 40; ++i) boxes.set([22 + i, 4, 0, 22.5 + i, 5, 2], 6 * i);
const things = scene.addObjects(boxes);
const bus = scene.addObject([25, 6, 0, 37, 8.5, 3], {moves: true});

const view = new occlude.View(); // one for each camera
const camera = {eye: [-15, 0, 2], target: [0, 0, 2]};
let frame;
for (const seconds of [0, 1]) {
  scene.moveObjects([bus], [25, 6 - 8 * seconds, 0, 37, 8.5 - 8 * seconds, 3]);
  scene.update();
  frame = scene.cull(camera, view, {frontToBack: true});
  const {drawn, hidden} = frame.statistics;
  console.log(`at ${seconds.toFixed(1)} s: ${drawn} of ${scene.objects} drawn, ${hidden} hidden`);
}
if (frame.objects.includes(bus)) console.log("the bus is drawn now");
const [fate] = scene.why([things[5]], view);
console.log(`thing 5 is ${fate.reason} by ${fate.by.length} polygons`);
