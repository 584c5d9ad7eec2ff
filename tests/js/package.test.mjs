// SPDX-License-Identifier: MIT
// What would be published: which files, how large they are, that its types and its examples compile and run.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";
import {gzipSync} from "node:zlib";

import {dist, need, packageFolder, read} from "./common.mjs";

const compiler = `${packageFolder}/node_modules/typescript/bin/tsc`;

test("the module is at most 200 KB, compressed, and has no names of functions in it", () => {
  const bytes = readFileSync(`${dist}/occlude.wasm`);
  assert.ok(gzipSync(bytes, {level: 9}).length <= 200000, `${gzipSync(bytes, {level: 9}).length} bytes`);
  const sections = WebAssembly.Module.customSections(new WebAssembly.Module(bytes), "name");
  assert.equal(sections.length, 0);
});

test("the module exports nothing that the package has no use for", async () => {
  const names = WebAssembly.Module.exports(new WebAssembly.Module(readFileSync(`${dist}/occlude.wasm`))).map(({name}) => name);
  const code = read(`${dist}/occlude.mjs`);
  // As they are written, or put together of parts: `occlude_scene_${what}_${kind}`.
  const said = [...code.matchAll(/occlude_[a-z_]+|\$\{\w+\}_[a-z_]+/g)].map(([name]) => name.replace(/^\$\{\w+\}/, ""));
  const parts = /^occlude_scene_(enable|mask|remove|has|move)_(object|occluder)s?$/;
  const isSaid = (name, part) => name === part || name === `${part}_look_at` || (part.startsWith("_") && name.endsWith(part));
  const isUsed = name => parts.test(name) || said.some(part => isSaid(name, part));
  assert.deepEqual(names.filter(name => name.startsWith("occlude_") && !isUsed(name)), []);
});

const needsNpm = need(`${packageFolder}/node_modules`, "node_modules");
test("npm pack gives the module, its types, its licence and its page, and nothing else", needsNpm, () => {
  const [{files}] = JSON.parse(execFileSync("npm", ["pack", "--dry-run", "--json", "--offline"], {cwd: packageFolder, encoding: "utf8"}));
  const names = files.map(({path}) => path).sort();
  const modules = ["occlude", "worker", "worker-main", "worker-thread", "three"];
  const built = modules.flatMap(name => [`dist/${name}.d.mts`, `dist/${name}.mjs`]);
  assert.deepEqual(names, ["LICENSE", "README.md", "package.json", "dist/occlude.wasm", ...built].sort());
});

test("the lock names no place from which packages came", () => {
  assert.doesNotMatch(read(`${packageFolder}/package-lock.json`), /"resolved"/);
});

test("types allow what is right and refuse what is wrong", need(compiler, "TypeScript in node_modules"), () => {
  const folder = mkdtempSync(join(tmpdir(), "occlude-types-"));
  try {
    mkdirSync(join(folder, "node_modules"));
    symlinkSync(packageFolder, join(folder, "node_modules", "occlude"));
    const uses = join(folder, "uses.mts");
    symlinkSync(new URL("types/uses.mts", import.meta.url).pathname, uses);
    const options = ["--strict", "--noEmit", "--module", "nodenext", "--target", "es2022", "--lib", "es2023,esnext.disposable,dom"];
    const run = spawnSync(process.execPath, [compiler, ...options, "--preserveSymlinks", uses], {cwd: folder, encoding: "utf8"});
    assert.equal(run.status, 0, run.stdout);
  } finally {
    rmSync(folder, {recursive: true});
  }
});

const examples = `${packageFolder}/example`;
for (const name of existsSync(examples) ? readdirSync(examples) : []) {
  if (!name.endsWith(".mjs")) continue;
  test(`the example ${name} runs, and prints what it says`, () => {
    const wanted = [...read(`${examples}/${name}`).matchAll(/^\/\/ > (.*)$/gm)].map(([, line]) => line);
    const printed = execFileSync(process.execPath, [`${examples}/${name}`], {encoding: "utf8"}).trimEnd().split("\n");
    assert.deepEqual(printed, wanted);
  });
}
