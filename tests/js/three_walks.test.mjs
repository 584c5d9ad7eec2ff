// SPDX-License-Identifier: MIT
// Walks through models of the shared folder as glTF in Chromium, by three.js, while objects are edited at random: with and without culling
// pictures are equal to the pixel.
import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";

import {needsBrowser, resultOf} from "./browser.mjs";
import {need, random} from "./common.mjs";
import {glbOf, meshesOf, readPly} from "./gltf.mjs";

const data = process.env.OCCLUDE_DATA ?? "";
const frames = 24;

/** Cameras along a path, evenly. */
function walkOf(path) {
  const {keyframes, near, fov_y_deg: fovY} = JSON.parse(readFileSync(path, "utf8"));
  const cameras = Array.from({length: frames}, (_, f) => {
    const along = (f / (frames - 1)) * (keyframes.length - 1), from = Math.min(Math.floor(along), keyframes.length - 2);
    const between = what => [0, 1, 2].map(k => {
      const [a, b] = [keyframes[from][what][k], keyframes[from + 1][what][k]];
      return a + (along - from) * (b - a);
    });
    return {eye: between("eye"), target: between("target")};
  });
  return {size: [320, 180], cameras, near, fovY};
}

for (const [model, path] of [["utrecht_centre", 1], ["sponza", 1], ["composite_city_temple_hills", 1]]) {
  const file = end => (data ? join(data, `${model}${end}`) : "");
  const needed = [needsBrowser, need(file(".ply"), `${model}.ply (OCCLUDE_DATA)`)].find(({skip}) => skip) ?? {};
  test(`a walk through ${model}`, needed, async () => {
    const made = mkdtempSync(join(tmpdir(), "occlude-walk-"));
    try {
      writeFileSync(join(made, "model.glb"), glbOf(meshesOf(readPly(file(".ply")), 400), random(2)));
      writeFileSync(join(made, "walk.json"), JSON.stringify(walkOf(file(`_path${path}.json`))));
      const result = await resultOf("walk.html", {made});
      console.log(model, JSON.stringify(result));
      assert.deepEqual([result.error, result.frames, result.different], [undefined, frames, 0]);
      assert.ok(result.colours > 50, "there is something in the pictures");
      assert.ok(result.triangles < 0.8 * result.allTriangles, "a good part is left out");
    } finally {
      rmSync(made, {recursive: true});
    }
  });
}
