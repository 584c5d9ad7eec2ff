// SPDX-License-Identifier: MIT
// The two versions of three.js before the current one: the same tests, and pictures.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, symlinkSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";

import {needsBrowser, resultOf} from "./browser.mjs";
import {dist, need, packageFolder, project, read} from "./common.mjs";

const folderOf = version => `${packageFolder}/node_modules/three-${version}`;

for (const version of [185, 186]) {
  test(`scenes of three.js 0.${version}`, need(folderOf(version), `three-${version} in node_modules`), () => {
    assert.equal(JSON.parse(read(`${folderOf(version)}/package.json`)).version.split(".")[1], String(version));
    const copy = mkdtempSync(join(tmpdir(), "occlude-three-"));
    try {
      cpSync(dist, join(copy, "dist"), {recursive: true});
      mkdirSync(join(copy, "node_modules"));
      symlinkSync(folderOf(version), join(copy, "node_modules", "three"));
      const environment = {...process.env, OCCLUDE_JS_PACKAGE: copy, NODE_TEST_CONTEXT: undefined};
      const options = {env: environment, encoding: "utf8"};
      const run = spawnSync(process.execPath, ["--test", "--test-reporter=tap", `${project}tests/js/three.test.mjs`], options);
      assert.equal(run.status, 0, run.stdout);
      assert.match(run.stdout, /^# skipped 0$/m);
    } finally {
      rmSync(copy, {recursive: true});
    }
  });

  const needed = existsSync(folderOf(version)) ? needsBrowser : need(folderOf(version), `three-${version} in node_modules`);
  for (const renderer of ["webgl", "webgpu"]) {
    test(`pictures of three.js 0.${version}: ${renderer}`, needed, async () => {
      const result = await resultOf(`pictures.html?${renderer}&8`, {three: folderOf(version)});
      console.log(version, JSON.stringify(result));
      assert.deepEqual([result.error, result.frames, result.different], [undefined, 8, 0]);
      assert.ok(result.hidden > 8 * 300, "most is left out");
    });
  }
}
