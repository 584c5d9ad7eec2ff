// SPDX-License-Identifier: MIT
// The package culls as the native library does, to the bit: OCCLUDE_JS_NATIVE is the folder of js_replay and js_model.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";

import {load, need, random} from "./common.mjs";
import {randomEdits} from "./edits.mjs";
import {readModel} from "./model_file.mjs";
import {bytesOf, replay} from "./replay.mjs";

const folder = process.env.OCCLUDE_JS_NATIVE ?? "";
const program = name => (folder ? join(folder, name) : "");
const doublesOf = file => new Float64Array(new Uint8Array(readFileSync(file)).buffer);

/** Does it with a folder for files. */
function withFiles(work) {
  const files = mkdtempSync(join(tmpdir(), "occlude-js-"));
  try {
    return work(name => join(files, name));
  } finally {
    rmSync(files, {recursive: true});
  }
}

const needsReplay = need(program("js_replay"), "js_replay (OCCLUDE_JS_NATIVE)");
test("100,000 random edits: each frame is that of the native library", needsReplay, async () => {
  const occlude = await load();
  const steps = randomEdits(random(3), 100000);
  const {answers} = replay(occlude, steps);
  assert.ok(steps.filter(([what]) => what === 12).length > 2000);
  const native = withFiles(file => {
    writeFileSync(file("steps"), bytesOf(steps));
    execFileSync(program("js_replay"), [file("steps"), file("answers")]);
    return doublesOf(file("answers"));
  });
  assert.ok(answers.length > 100000);
  assert.equal(Buffer.compare(Buffer.from(answers.buffer), Buffer.from(native.buffer)), 0);
});

const models = ["utrecht_centre", "intel_castle", "sponza", "composite_city_temple_hills"];
const data = process.env.OCCLUDE_DATA ?? "";

for (const model of models) {
  const file = end => (data ? join(data, `${model}${end}`) : "");
  const needed = [need(program("js_model"), "js_model (OCCLUDE_JS_NATIVE)"), need(file(".ply"), `${model}.ply (OCCLUDE_DATA)`)];
  const options = needed.find(({skip}) => skip) ?? {};
  test(`300 frames of ${model}: what is culled is what the native library culls`, options, async () => {
    const occlude = await load();
    const {vertices, indices, sizes, seeThrough, cameras, hashes} = withFiles(made => {
      execFileSync(program("js_model"), [file(".ply"), file("_path1.json"), "300", made("model")]);
      return readModel(readFileSync(made("model")));
    });
    const culler = new occlude.Culler({vertices, indices, sizes, seeThrough}), view = new occlude.ModelView();
    assert.equal(hashes.length, 300);
    cameras.forEach((camera, f) => {
      const frame = culler.cull(camera, view, {adaptive: false, margin: occlude.marginFor(360)});
      assert.equal(hashOfDrawn(culler, frame), hashes[f], `frame ${f}`);
    });
  });
}

/** FNV-1a of the numbers of the polygons that are drawn, ascending. */
function hashOfDrawn(culler, {drawn}) {
  const isDrawn = new Uint8Array(culler.order.length);
  for (let i = 0; i < drawn.length; i += 2) {
    for (let p = drawn[i]; p < drawn[i] + drawn[i + 1]; ++p) isDrawn[culler.order[p]] = 1;
  }
  let hash = 0x811c9dc5;
  for (let p = 0; p < isDrawn.length; ++p) {
    if (isDrawn[p]) hash = Math.imul(hash ^ p, 0x01000193) >>> 0;
  }
  return hash;
}
