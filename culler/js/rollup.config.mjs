// SPDX-License-Identifier: MIT
// A module for each that is imported by its name, and one file of its types, from what tsc makes of each source.
import {dts} from "rollup-plugin-dts";

const made = "../../build/js";
// These are there once, and beside the others.
const parts = /^(node:|three$|\.\/(occlude|worker-thread)\.mjs$)/;
const paths = id => (id.endsWith(".mjs") ? `./${id.split("/").at(-1)}` : id);

const moduleOf = name => {
  const external = id => parts.test(id) && id !== `./${name}.mjs`;
  const output = {format: "es", paths};
  return [
    {input: `${made}/${name}.mjs`, output: {...output, file: `dist/${name}.mjs`}, external},
    {
      input: `${made}/${name}.d.mts`,
      output: {...output, file: `dist/${name}.d.mts`, banner: '/// <reference lib="esnext.disposable" />'},
      external,
      plugins: [dts()],
    },
  ];
};

export default ["occlude", "worker", "worker-thread", "worker-main", "three"].flatMap(moduleOf);
