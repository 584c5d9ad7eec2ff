// SPDX-License-Identifier: MIT
// Pages of tests in Chromium, without a screen.
import assert from "node:assert/strict";
import {spawn} from "node:child_process";
import {once} from "node:events";
import {existsSync, mkdtempSync, readFileSync, rmSync} from "node:fs";
import {createServer} from "node:http";
import {tmpdir} from "node:os";
import {extname, join} from "node:path";

import {dist, need, packageFolder, project} from "./common.mjs";

const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(path => existsSync(path));
export const three = `${packageFolder}/node_modules/three`;
/** Options of a test that needs a browser. */
export const needsBrowser = chromium ? need(three, "three in node_modules") : {skip: "skipped: no Chromium"};

const types = {".html": "text/html", ".mjs": "text/javascript", ".js": "text/javascript", ".wasm": "application/wasm"};
const flags = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-unsafe-webgpu",
  "--use-webgpu-adapter=swiftshader"];

/** What a page of tests/js tells. `folders`: what lies at /NAME/ beside dist and three. */
export async function resultOf(name, folders = {}) {
  const all = {dist, three, ...folders};
  let tell;
  const told = new Promise(resolve => (tell = resolve));
  const server = createServer((request, answer) => {
    const path = decodeURI(new URL(request.url, "http://localhost").pathname);
    if (request.method === "POST") {
      const parts = [];
      request.on("data", part => parts.push(part)).on("end", () => (answer.end(), tell(JSON.parse(Buffer.concat(parts)))));
      return;
    }
    const [, folder, name] = /^\/(\w+)\/(.*)$/.exec(path) ?? [];
    const file = folder in all ? join(all[folder], name) : join(project, "tests/js", path);
    if (!existsSync(file)) return answer.writeHead(404).end();
    answer.writeHead(200, {"content-type": types[extname(file)] ?? "application/octet-stream"}).end(readFileSync(file));
  });
  await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
  const profile = mkdtempSync(join(tmpdir(), "occlude-chromium-"));
  const page = `http://127.0.0.1:${server.address().port}/${name}`;
  const given = [...flags, `--user-data-dir=${profile}`, "--remote-debugging-port=0", page];
  const browser = spawn(chromium, given, {detached: true, stdio: "ignore"}), ended = once(browser, "exit");
  try {
    return await Promise.race([told, ended.then(([code]) => assert.fail(`the browser ended with ${code}`))]);
  } finally {
    if (browser.exitCode === null) process.kill(-browser.pid, "SIGKILL"); // with all that it has started
    await ended;
    server.closeAllConnections();
    server.close();
    rmSync(profile, {recursive: true, force: true});
  }
}
