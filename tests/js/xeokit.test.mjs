// SPDX-License-Identifier: MIT
// The example of xeokit in Chromium: a walk through a town while objects change; with and without culling pictures are equal to the pixel.
import assert from "node:assert/strict";
import {test} from "node:test";

import {needsBrowser, resultOf} from "./browser.mjs";
import {need, project} from "./common.mjs";

const example = `${project}culler/js/example/xeokit`;
const needed = need(`${example}/node_modules`, "node_modules in example/xeokit (npm ci --prefix culler/js/example/xeokit)");
test("a walk in xeokit", needsBrowser.skip ? needsBrowser : needed, async () => {
  const result = await resultOf("xeokit.html", {example});
  console.log(JSON.stringify(result));
  assert.deepEqual([result.error, result.frames, result.different], [undefined, 40, 0]);
  assert.ok(result.colours > 50, "there is something in the pictures");
  assert.ok(result.hidden > 0.7 * result.frames * result.objects, "most is hidden or out of view");
  assert.deepEqual([result.hiddenWhenCut, result.leftHidden, result.hiddenAtLast > 100], [0, 0, true]);
});
