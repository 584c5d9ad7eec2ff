// SPDX-License-Identifier: MIT
// The colours of the reports: they differ in lightness as well, for colour-blind readers.

export type Rgb = readonly [number, number, number];

const rgb = (colour: string): Rgb => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16) / 255) as unknown as Rgb;

export const hiddenColour = rgb("#6f57b5");
export const frustumColour = rgb("#5b8cff");
export const lieColour = rgb("#f08a3c");
export const pickedColour = rgb("#ffc400");
/** By the reader's scheme. */
export const pale = {light: rgb("#c5ccd6"), dark: rgb("#4d545e")};
export const haze = {light: rgb("#e9eef4"), dark: rgb("#161b22")};
export const sky = {light: rgb("#b8d0ec"), dark: rgb("#1d2a3d")};
