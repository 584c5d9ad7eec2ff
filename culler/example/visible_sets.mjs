// SPDX-License-Identifier: MIT
// What may be seen from an eye, by the visible sets of `occlude bake` (docs/bake.md). Needs nothing else, in a browser or in
// node. Usage: node visible_sets.mjs FILE X Y Z

const header = 64, ofBox = 48

/** A file in an ArrayBuffer. Sets are ascending arrays of numbers. */
export class VisibleSets {
  constructor(buffer) {
    this.bytes = new Uint8Array(buffer)
    this.view = new DataView(buffer)
    const name = String.fromCharCode(...this.bytes.subarray(0, 8))
    if (name !== 'OCCLPVS1' || buffer.byteLength < header || this.#long(8) !== buffer.byteLength) {
      throw new Error('no visible sets, or cut off')
    }
    this.model = this.view.getBigUint64(16, true)
    this.cells = this.view.getUint32(24, true)
    this.items = this.view.getUint32(28, true)
    this.widest = this.view.getFloat64(32, true)
  }

  /** The least corner of a cell and the greatest: six numbers. */
  box(cell) {
    return Array.from({length: 6}, (_, i) => this.view.getFloat64(header + cell * ofBox + 8 * i, true))
  }

  /** The first cell that holds the eye; undefined if there is none. */
  cellAt(eye) {
    let first = 0
    for (let end = this.cells; first < end;) {
      const middle = (first + end) >> 1
      if (this.box(middle)[0] < eye[0] - this.widest) first = middle + 1
      else end = middle
    }
    for (let cell = first; cell < this.cells; ++cell) {
      const box = this.box(cell)
      if (box[0] > eye[0]) return undefined
      if (eye.every((x, i) => box[i] <= x && x <= box[i + 3])) return cell
    }
    return undefined
  }

  /** The items that may be seen from somewhere in the cell: all others are hidden from everywhere in it. */
  visible(cell) { return this.#set(cell) }
  /** The cells of which something may be seen from somewhere in this one. */
  visibleCells(cell) { return this.#set(this.cells + cell) }

  #long(place) { return Number(this.view.getBigUint64(place, true)) }

  #set(number) {
    const changes = new Set()
    for (let back = 1; back !== 0; number -= back) {
      const [from, ...steps] = this.#numbers(number)
      let at = 0
      for (const step of steps) {
        at += step
        if (!changes.delete(at)) changes.add(at)
      }
      back = from
    }
    const ends = [...changes].sort((a, b) => a - b), set = []
    for (let i = 0; i < ends.length; i += 2) {
      for (let item = ends[i]; item < ends[i + 1]; ++item) set.push(item)
    }
    return set
  }

  * #numbers(number) {
    const place = header + this.cells * ofBox + 8 * number
    let value = 0, unit = 1
    for (const byte of this.bytes.subarray(this.#long(place), this.#long(place + 8))) {
      value += byte % 128 * unit
      unit *= 128
      if (byte < 128) {
        yield value
        value = 0
        unit = 1
      }
    }
  }
}

if (typeof process !== 'undefined' && process.argv[1]?.endsWith('visible_sets.mjs')) {
  const {readFileSync} = await import('node:fs')
  const sets = new VisibleSets(new Uint8Array(readFileSync(process.argv[2])).buffer)
  const cell = sets.cellAt(process.argv.slice(3, 6).map(Number))
  console.log(cell === undefined ? 'in no cell' : `cell ${cell}`)
  if (cell !== undefined) {
    console.log(['items', ...sets.visible(cell)].join(' '))
    console.log(['cells', ...sets.visibleCells(cell)].join(' '))
  }
}
