// SPDX-License-Identifier: MIT
// What the command puts into a page: parts in base64 and deflated, as render/report/src/deflated.h and bytes.h write them.

/** @param {string} name */
export const hasPart = name => document.getElementById(`part-${name}`) !== null;

/**
 * The bytes of a part of the page.
 * @param {string} name
 */
export async function bytesOfPart(name) {
  const letters = atob(/** @type {HTMLElement} */ (document.getElementById(`part-${name}`)).textContent ?? "");
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {string} name */
export const jsonOfPart = async name => JSON.parse(new TextDecoder().decode(await bytesOfPart(name)));

/** Whole numbers, one after another. */
export class Numbers {
  /**
   * @param {Uint8Array} bytes
   * @param {number} at
   */
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }
  next() {
    let value = 0, unit = 1, byte;
    do {
      byte = /** @type {number} */ (this.bytes[this.at++]);
      value += (byte & 0x7f) * unit;
      unit *= 128;
    } while (byte & 0x80);
    return value;
  }
  difference() {
    const folded = this.next();
    return folded % 2 ? -(folded + 1) / 2 : folded / 2;
  }
  get isAtEnd() {
    return this.at >= this.bytes.length;
  }
}

/**
 * Whole numbers of 32 bits, x, y and z of each vertex: of each axis the differences from the vertex before, first the lowest byte of all,
 * then the next ones.
 * @param {Uint8Array} bytes
 */
export function unpackVertices(bytes) {
  const kBytes = 4, count = bytes.length / (3 * kBytes);
  const points = new Int32Array(3 * count);
  /** @param {number} at */
  const byte = at => /** @type {number} */ (bytes[at]);
  for (let axis = 0; axis < 3; ++axis) {
    let at = kBytes * axis * count, value = 0;
    for (let v = 0; v < count; ++v, ++at) {
      const folded = byte(at) | byte(at + count) << 8 | byte(at + 2 * count) << 16 | byte(at + 3 * count) << 24;
      value += folded & 1 ? ~(folded >>> 1) : folded >>> 1;
      points[3 * v + axis] = value;
    }
  }
  return points;
}
