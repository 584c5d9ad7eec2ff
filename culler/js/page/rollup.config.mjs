// SPDX-License-Identifier: MIT
// One module of all that the page needs, from what tsc makes of its sources.
import {nodeResolve} from "@rollup/plugin-node-resolve";
import terser from "@rollup/plugin-terser";

export default {
  input: "made/main.mjs",
  external: [/^node:/],
  output: {file: "made/page.js", format: "es", inlineDynamicImports: true},
  plugins: [nodeResolve(), terser()],
};
