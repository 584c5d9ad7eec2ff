// SPDX-License-Identifier: MIT
// Culls the frames of a path with the culler of a page, as culls.cpp does natively, and prints the same lines. The last line, on
// standard error, has the mean milliseconds.
// Usage: node culls.js FOLDER_OF_PAGE_SCRIPTS PAGE frusta|cover FRAMES
const fs = require('fs'), path = require('path');
const [scripts, page, method, frames] = process.argv.slice(2);

const html = fs.readFileSync(page, 'latin1');
globalThis.document = {getElementById: id => ({textContent: html.split(`id="${id}">`)[1].split('<')[0]})};
const {LiveCuller, Fate, bytesOfPart, jsonOfPart} = new Function(
    ['geometry.js', 'unpack.js', 'live_culler.js'].map(name => fs.readFileSync(path.join(scripts, name), 'utf8')).join('\n') +
    'return {LiveCuller, Fate, bytesOfPart, jsonOfPart};')();

/** FNV-1a, 32 bits, over the numbers of the polygons that are drawn, ascending. */
function hashOfDrawn(frame, model, isDrawn) {
  isDrawn.fill(0);
  frame.fates.forEach((fate, leaf) => {
    for (let p = model.firstPolygon[leaf]; p < model.firstPolygon[leaf + 1]; ++p) isDrawn[model.numbers[p]] = fate === Fate.drawn;
  });
  let hash = 0x811c9dc5;
  for (let number = 0; number < isDrawn.length; ++number) {
    if (isDrawn[number]) hash = Math.imul(hash ^ number, 0x01000193);
  }
  return hash >>> 0;
}

(async () => {
  const start = await jsonOfPart('start');
  const culler = await LiveCuller.open(await bytesOfPart('module'), await bytesOfPart('model'), start.lens, start.leaf);
  const options = {method, occluders: 8, triangles: Infinity, margin: 1 / 128 / start.height};
  const isDrawn = new Uint8Array(culler.model.polygons);
  let ms = 0;
  for (let f = 0; f < Number(frames); ++f) {
    ms += culler.cull(start.eyes[f], start.targets[f], start.lens.aspect, options);
    const frame = culler.frame();
    const {drawn, culled} = frame.counts;
    console.log(`${f}: ${drawn} drawn, ${culled} culled, ${hashOfDrawn(frame, culler.model, isDrawn)}`);
  }
  console.error(`WebAssembly: ${(ms / frames).toFixed(3)} ms a frame`);
})();
