// SPDX-License-Identifier: MIT
import {refuse} from "./errors.mjs";
import type {Scratch} from "./library.mjs";

declare const named: unique symbol;

/**
 * Name one object, or one occluder, of one scene until it is removed. No two ids that a program ever gets are equal. What an
 * id names, its generation and its scene are in the number, so ids of what was removed, of another scene and of the other
 * kind are refused.
 */
export type ObjectId = bigint & {readonly [named]: "object"};
export type OccluderId = bigint & {readonly [named]: "occluder"};

/** Ids one after another. */
export interface IdArray<Id extends bigint> extends BigUint64Array<ArrayBuffer> {
  [i: number]: Id;
  [Symbol.iterator](): ArrayIterator<Id>;
}
export type ObjectIds = IdArray<ObjectId>;
export type OccluderIds = IdArray<OccluderId>;

/** What takes ids takes an array of them. */
export type Ids<Id extends bigint> = IdArray<Id> | readonly Id[];

/** In the memory of the module. */
export const idsOf = <Id extends bigint>(scratch: Scratch, ids: Ids<Id>): number =>
  scratch.copyOf(ids instanceof BigUint64Array ? ids : BigUint64Array.from(ids as readonly bigint[]));

/** As a parameter of C. */
export const numberOf = (id: bigint): bigint => (typeof id === "bigint" ? id : refuse("an id is a bigint"));

/** What OCCLUDE_SLOT keeps of an id. */
const slotBits = 0x0fffffff;

/**
 * A small number that what is in the scene has to itself: objects apart from occluders. What is added takes the slot of what
 * was removed, so an array of the caller's own that is indexed by slots stays short.
 */
export const slot = (id: ObjectId | OccluderId): number => Number(id & BigInt(slotBits));

/** The same of many, without a bigint for each. */
export function slots(ids: ObjectIds | OccluderIds): Uint32Array<ArrayBuffer> {
  const halves = new Uint32Array(ids.buffer, ids.byteOffset, 2 * ids.length); // the lower one first, as in all browsers
  const result = new Uint32Array(ids.length);
  for (let i = 0; i < result.length; ++i) result[i] = halves[2 * i]! & slotBits;
  return result;
}
