// SPDX-License-Identifier: MIT
// The colours of pages and reports: they differ in lightness as well, for colour-blind readers.

/** @typedef {readonly [number, number, number]} Rgb */

/** @type {(colour: string) => Rgb} */
export const rgb = colour => /** @type {*} */ ([1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16) / 255));

export const hiddenColour = rgb("#6f57b5");
export const frustumColour = rgb("#5b8cff");
/** Hidden, and drawn all the same; or shown, and hidden all the same. */
export const wrongColour = rgb("#f08a3c");
/** What hides something. */
export const occluderColour = rgb("#ffc400");
/** By the reader's scheme. */
export const pale = {light: rgb("#c5ccd6"), dark: rgb("#4d545e")};
export const haze = {light: rgb("#e9eef4"), dark: rgb("#161b22")};
export const sky = {light: rgb("#b8d0ec"), dark: rgb("#1d2a3d")};
