// SPDX-License-Identifier: MIT
// What the tests of the package share: the package as it was built, and worlds.
import {existsSync, readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";

import {random as numbersOf} from "../../culler/js/page/src/random.mjs";

export const project = fileURLToPath(new URL("../..", import.meta.url));
/** OCCLUDE_JS_PACKAGE: a copy of it with other modules. */
export const packageFolder = process.env.OCCLUDE_JS_PACKAGE ?? `${project}culler/js`;
export const dist = `${packageFolder}/dist`;

/** The module of the package. */
export const occludeModule = () => import(`${dist}/occlude.mjs`);
export const load = async () => (await occludeModule()).load();

/** What a test without this file says when it is skipped: options of node:test. */
export const need = (file, what) => (file && existsSync(file) ? {} : {skip: `skipped: no ${what}`});

/** Numbers from 0 to 1, always the same for the same seed, which is printed. */
export function random(seed) {
  console.log(`seed ${seed}`);
  return numbersOf(seed);
}

/** The box as six polygons. */
export function cube([x0, y0, z0, x1, y1, z1]) {
  const corner = i => [i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0];
  return {
    vertices: [0, 1, 2, 3, 4, 5, 6, 7].flatMap(corner),
    indices: [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5],
    sizes: [4, 4, 4, 4, 4, 4],
  };
}

export const at = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

/** A wall across the x axis, at x = 10. */
export const wall = {vertices: [10, -5, -5, 10, 5, -5, 10, 5, 5, 10, -5, 5], indices: [0, 1, 2, 3], sizes: [4]};
/** From the origin along the x axis. */
export const alongX = {eye: [0, 0, 0], target: [1, 0, 0]};

export const read = file => readFileSync(file, "utf8");
