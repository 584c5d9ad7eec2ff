// SPDX-License-Identifier: MIT
// Models that stand still: what is drawn of them, and in which order.
import assert from "node:assert/strict";
import {test} from "node:test";

import {alongX, load, occludeModule, random, wall} from "./common.mjs";

const occlude = await load();
const {hidden} = await occludeModule();

/** The wall, and a smaller one behind it. */
const two = {
  vertices: [...wall.vertices, ...wall.vertices.map((x, i) => x * [2, 0.5, 0.5][i % 3])],
  indices: [0, 1, 2, 3, 4, 5, 6, 7],
  sizes: [4, 4],
};

/** Which polygons of the given order a frame draws. */
function drawnOf(culler, frame) {
  const drawn = [];
  for (let i = 0; i < frame.drawn.length; i += 2) {
    drawn.push(...culler.order.slice(frame.drawn[i], frame.drawn[i] + frame.drawn[i + 1]));
  }
  return drawn.sort((a, b) => a - b);
}

test("the wall hides what is behind it, where they are in leaves of their own", () => {
  const culler = new occlude.Culler(two, {leafSize: 1}), view = new occlude.ModelView();
  const frame = culler.cull(alongX, view);
  assert.deepEqual(drawnOf(culler, frame), [0]);
  assert.deepEqual([...frame.culled].slice(1), [1, hidden]);
  assert.deepEqual([frame.statistics.drawnPolygons, frame.statistics.hiddenPolygons], [1, 1]);
  const away = culler.cull({eye: [0, 0, 0], target: [-1, 0, 0]}, view);
  assert.equal(away.drawn.length, 0);
  assert.equal(away.statistics.outOfViewPolygons, 2);
  for (let i = 0; i < away.culled.length; i += 3) assert.ok(away.culled[i + 2] < away.planes.length / 4);
  const both = new occlude.Culler(two); // in one leaf, which is drawn
  assert.deepEqual(drawnOf(both, both.cull(alongX, view)), [0, 1]);
});

test("every polygon is in one range, in random models of either kind of boxes", () => {
  const next = random(2);
  for (const bounds of ["aabb", "obb"]) {
    const vertices = [], indices = [];
    for (let i = 0; i < 2000; ++i) {
      const middle = [5 + 40 * next(), 40 * next() - 20, 40 * next() - 20];
      for (let k = 0; k < 3; ++k) vertices.push(...middle.map(x => x + 20 * next() - 10)), indices.push(3 * i + k);
    }
    const culler = new occlude.Culler({vertices, indices}, {bounds}), view = new occlude.ModelView();
    let most = 0;
    assert.equal(new Set(culler.order).size, 2000);
    for (let f = 0; f < 20; ++f) {
      const camera = {eye: [f / 10, 0, 0], target: [50, 30 - 3 * f, 0], fovY: 50};
      const {drawn, culled, statistics} = culler.cull(camera, view, {margin: occlude.marginFor(720)});
      const ranges = [];
      for (let i = 0; i < drawn.length; i += 2) ranges.push([drawn[i], drawn[i + 1]]);
      for (let i = 0; i < culled.length; i += 3) ranges.push([culled[i], culled[i + 1]]);
      let end = 0;
      for (const [first, count] of ranges.sort((a, b) => a[0] - b[0])) {
        assert.equal(first, end);
        end += count;
      }
      assert.equal(end, 2000);
      assert.equal(statistics.drawnPolygons + statistics.hiddenPolygons + statistics.outOfViewPolygons, 2000);
      most = Math.max(most, statistics.hiddenPolygons);
    }
    assert.ok(most > 200, `${most} hidden at most`);
    assert.equal(view.holdsFor({eye: [1.9, 0, 0], target: [50, -27, 0], fovY: 50}), true);
    assert.equal(view.holdsFor({eye: [1.9, 0, 0], target: [-50, -27, 0], fovY: 50}), false);
    assert.equal(new occlude.ModelView().holdsFor(alongX), false);
  }
});

test("glass hides nothing, and is hidden", () => {
  const view = new occlude.ModelView();
  const frame = seeThrough => new occlude.Culler({...two, seeThrough}, {leafSize: 1}).cull(alongX, view).statistics.hiddenPolygons;
  assert.deepEqual([frame([0, 0]), frame([1, 0]), frame([0, 1])], [1, 0, 1]);
});
