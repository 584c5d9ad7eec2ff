// SPDX-License-Identifier: MIT
// Pictures of three.js in Chromium, with shadows, glass and things that move: with and without culling they are equal to the pixel.
import assert from "node:assert/strict";
import {execFile} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {createServer} from "node:http";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";
import {promisify} from "node:util";

import {dist, need, packageFolder, project} from "./common.mjs";

const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(path => !need(path, "").skip);
const three = `${packageFolder}/node_modules/three/build`;
const folders = {dist, three, "": `${project}tests/js`};
const types = {html: "text/html", mjs: "text/javascript", js: "text/javascript", wasm: "application/wasm"};

const needed = chromium ? need(three, "three in node_modules") : {skip: "skipped: no Chromium"};
test("a walk of 40 frames", needed, async () => {
  const server = createServer(({url}, answer) => {
    const [, folder, name] = /^\/(?:(dist|three)\/)?([\w.-]+)$/.exec(url) ?? [];
    try {
      const bytes = readFileSync(join(folders[folder ?? ""], name));
      answer.writeHead(200, {"content-type": types[name.split(".").at(-1)]}).end(bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
  const profile = mkdtempSync(join(tmpdir(), "occlude-chromium-"));
  try {
    const flags = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--virtual-time-budget=600000"];
    const page = `http://127.0.0.1:${server.address().port}/pictures.html`;
    const {stdout} = await promisify(execFile)(chromium, [...flags, `--user-data-dir=${profile}`, "--dump-dom", page], {timeout: 300000});
    const [, text] = /<body[^>]*>\s*result (.*) end/.exec(stdout) ?? assert.fail(stdout.slice(-600));
    const result = JSON.parse(text);
    console.log(text);
    assert.deepEqual([result.error, result.frames, result.different], [undefined, 40, 0]);
    assert.ok(result.colours > 100, "there is something in the pictures");
    assert.ok(result.allCalls - result.calls > 50 * result.frames, "something is left out, though all is drawn for shadows");
  } finally {
    server.close();
    rmSync(profile, {recursive: true, force: true});
  }
});
