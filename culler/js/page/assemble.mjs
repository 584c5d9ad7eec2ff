// SPDX-License-Identifier: MIT
// Puts the page together: one file with script, style and module inside, which opens from a disk as well, and beside it what
// decodes compressed models.
import {cpSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";

const [folder] = process.argv.slice(2);
const read = name => readFileSync(new URL(name, import.meta.url), "utf8");
const wasm = readFileSync(new URL("../dist/occlude.wasm", import.meta.url)).toString("base64");
const parts = {
  "page.css": read("page.css"),
  "swatches.css": read("swatches.css"),
  // A script ends where this stands in it.
  "page.js": read("made/page.js").replaceAll("</script", "<\\/script"),
  "occlude.wasm": wasm,
};
const page = read("index.html").replace(/\{\{([\w.]+)\}\}/g, (_, name) => parts[name]);
mkdirSync(folder, {recursive: true});
writeFileSync(`${folder}/index.html`, page);
for (const name of ["draco_wasm_wrapper.js", "draco_decoder.wasm"]) {
  cpSync(new URL(`node_modules/three/examples/jsm/libs/draco/gltf/${name}`, import.meta.url), `${folder}/draco/${name}`);
}
