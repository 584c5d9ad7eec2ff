// SPDX-License-Identifier: MIT
// Pictures of three.js in Chromium, with shadows, glass, batches and things that move: with and without culling they are equal to the
// pixel.
import assert from "node:assert/strict";
import {test} from "node:test";

import {needsBrowser, resultOf} from "./browser.mjs";

for (const [renderer, frames] of [["webgl", 40], ["reversed", 16], ["logarithmic", 16], ["webgpu", 16], ["webgpu_reversed", 16],
                                  ["webgpu_by_webgl", 16]]) {
  test(`a walk of ${frames} frames: ${renderer}`, needsBrowser, async context => {
    const result = await resultOf(`pictures.html?${renderer}&${frames}`);
    console.log(renderer, JSON.stringify(result));
    assert.deepEqual([result.error, result.frames, result.different], [undefined, frames, 0]);
    assert.equal(result.isReversed, renderer.endsWith("reversed"));
    assert.ok(result.colours > 100, "there is something in the pictures");
    assert.ok(result.allTriangles - result.triangles > 10000 * frames, "something is left out, though all is drawn for shadows");
    if (/^webgpu(_reversed)?$/.test(renderer) && result.kind !== "WebGPU") context.skip("skipped: no WebGPU in this browser");
  });
}
