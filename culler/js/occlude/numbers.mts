// SPDX-License-Identifier: MIT
// Arrays of the caller, as C takes them.
import {refuse} from "./errors.mjs";
import {structs} from "./layout.mjs";
import type {Scratch} from "./library.mjs";

/** A point or a direction. */
export type Point = ArrayLike<number>;
/** Numbers one after another. A Float32Array is read as it is, everything else as numbers in double precision. */
export type Numbers = ArrayLike<number>;
/**
 * Boxes, one after another: six numbers each, the least x, y, z and then the greatest; or oriented, twelve numbers each, the
 * centre and then three half edges.
 */
export type Boxes = Numbers | {readonly oriented: Numbers};
/** Whole numbers from 0 to 2^32 - 1. */
export type Indices = ArrayLike<number>;

const isFloat = 1, isDouble = 0;

/** Numbers in the memory of the module, `each` for one element. */
export function numbersOf(scratch: Scratch, numbers: Numbers, each: number, name: string) {
  const count = countOf(numbers, each, name);
  if (numbers instanceof Float32Array) return {data: scratch.copyOf(numbers), count, type: isFloat};
  const doubles = numbers instanceof Float64Array ? numbers : Float64Array.from(numbers);
  return {data: scratch.copyOf(doubles), count, type: isDouble};
}

const countOf = (numbers: Numbers, each: number, name: string) =>
  numbers.length % each === 0 ? numbers.length / each : refuse(`${name}: ${numbers.length} numbers are no multiple of ${each}`);

export const countOfBoxes = (boxes: Boxes) =>
  "oriented" in boxes ? countOf(boxes.oriented, 12, "boxes") : countOf(boxes, 6, "boxes");

/** An occlude_boxes, and how many there are. */
export function boxesOf(scratch: Scratch, boxes: Boxes) {
  const isOriented = "oriented" in boxes;
  const numbers = numbersOf(scratch, isOriented ? boxes.oriented : boxes, isOriented ? 12 : 6, "boxes");
  return {place: scratch.struct(structs.boxes, {...numbers, kind: Number(isOriented)}), count: numbers.count};
}

/** A point, or anything else of so many numbers. */
export function fixed(numbers: ArrayLike<number>, count: number, name: string): ArrayLike<number> {
  if (numbers.length !== count) refuse(`${name}: ${numbers.length} numbers where ${count} are needed`);
  return numbers;
}
export const pointOf = (point: Point, name: string) => fixed(point, 3, name);

/** Whole numbers of 32 bits in the memory of the module. */
export function wordsOf(scratch: Scratch, numbers: Indices, name: string): number {
  if (numbers instanceof Uint32Array) return scratch.copyOf(numbers);
  const words = Uint32Array.from(numbers);
  for (let i = 0; i < words.length; ++i) wholeOf(numbers[i]!, name);
  return scratch.copyOf(words);
}

/** A whole number of 32 bits. */
export function wholeOf(number: number, name: string): number {
  return number >>> 0 === number ? number : refuse(`${name}: ${number} is not a whole number from 0 to 4294967295`);
}

/** The place of a word in a list: what C calls it. */
export function choiceOf<Word extends string>(word: Word, words: readonly Word[], name: string): number {
  const place = words.indexOf(word);
  return place >= 0 ? place : refuse(`${name} is ${JSON.stringify(word)}, must be one of ${words.join(", ")}`);
}
