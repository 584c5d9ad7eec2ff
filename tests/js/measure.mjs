// SPDX-License-Identifier: MIT
// Milliseconds of a frame, native and on the web, by turns: the table of the package's README. One thread each.
// Usage: node tests/js/measure.mjs FOLDER_OF_JS_REPLAY FOLDER_OF_MODELS [ROUNDS]
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

import {load, random} from "./common.mjs";
import {readModel} from "./model_file.mjs";
import {bytesOf, replay} from "./replay.mjs";

const [programs, models, rounds = "5"] = process.argv.slice(2);
const files = mkdtempSync(join(tmpdir(), "occlude-js-"));
const occlude = await load();
const median = numbers => numbers.sort((a, b) => a - b)[numbers.length >> 1];

/** Both by turns. */
function compare(name, native, web) {
  const times = {native: [], web: []};
  for (let i = 0; i < Number(rounds); ++i) {
    times.native.push(native());
    times.web.push(web());
  }
  const ratios = times.web.map((time, i) => time / times.native[i]);
  const [nativeMs, webMs] = [times.native, times.web].map(each => median(each).toFixed(3));
  console.log(`${name}: native ${nativeMs} ms, web ${webMs} ms, ${median(ratios).toFixed(2)} x`);
}

/** 50,000 objects and 1,500 houses that stand still, and the way around. */
function town() {
  const next = random(6);
  const boxes = Array.from({length: 50000}, () => {
    const low = [1000 * next() - 500, 1000 * next() - 500, 5 * next()];
    return [...low, ...low.map(x => x + 1 + 2 * next())];
  });
  const [a, b, c, d, e, f, g, h] = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1 ? 10 : 0, i & 2 ? 10 : 0, i & 4 ? 1 : 0]);
  const triangles = [a, b, f, a, f, e, b, d, h, b, h, f, d, c, g, d, g, h, c, a, e, c, e, g, e, f, h, e, h, g];
  const houses = Array.from({length: 1500}, () =>
    [6, 0, 1, 0, 0, 0, 1, 0, 0, 0, 5 + 20 * next(), 1000 * next() - 500, 1000 * next() - 500, 0, 0, 0, 3, 0, -1]);
  const frames = Array.from({length: 300}, (_, i) => {
    const angle = i / 50;
    return [12, 300 * Math.cos(angle), 300 * Math.sin(angle), 2, 0, 0, 2, 3, 0, 0];
  });
  return [[0, 0, 3, ...boxes.flat()], [5, ...triangles.flat()], ...houses, [11], ...frames];
}

const steps = town();
writeFileSync(join(files, "steps"), bytesOf(steps));
const run = (program, ...given) => Number(execFileSync(join(programs, program), given, {encoding: "utf8"}));
const native = () => run("js_replay", join(files, "steps"), join(files, "answers"));
compare("50,000 objects, 1,500 houses", native, () => replay(occlude, steps).milliseconds);

for (const model of ["utrecht_centre", "composite_city_temple_hills", "intel_castle", "sponza"]) {
  const ply = join(models, `${model}.ply`);
  if (!existsSync(ply)) continue;
  const native = () => run("js_model", ply, join(models, `${model}_path1.json`), "100", join(files, "model"));
  native();
  const {cameras, ...polygons} = readModel(readFileSync(join(files, "model")));
  const culler = new occlude.Culler(polygons), how = {adaptive: false, margin: occlude.marginFor(360)};
  compare(model, native, () => {
    const view = new occlude.ModelView(), start = performance.now();
    for (const camera of cameras) culler.cull(camera, view, how);
    const time = (performance.now() - start) / cameras.length;
    view.dispose();
    return time;
  });
  culler.dispose();
}
rmSync(files, {recursive: true});
