// SPDX-License-Identifier: MIT
// One module, and one file of its types, from what tsc makes of each source.
import {dts} from "rollup-plugin-dts";

const made = "../../build/js/occlude";

export default [
  {input: `${made}.mjs`, output: {file: "dist/occlude.mjs", format: "es"}, external: /^node:/},
  {
    input: `${made}.d.mts`,
    output: {file: "dist/occlude.d.ts", format: "es", banner: '/// <reference lib="esnext.disposable" />'},
    plugins: [dts()],
  },
];
