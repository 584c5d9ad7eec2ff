// SPDX-License-Identifier: MIT
// Reads the visible sets of `occlude bake` (docs/bake.md), in a browser or in node. Needs nothing else.
const header = 64, ofBox = 48
function require(holds) {
  if (!holds) throw new Error('no visible sets, or damaged')
}
/** A file in an ArrayBuffer. Sets are ascending arrays of numbers. A cell that there is not throws RangeError, what is no set Error. */
export class VisibleSets {
  /** Reads the header alone. */
  constructor(buffer) {
    this.bytes = new Uint8Array(buffer)
    this.view = new DataView(buffer)
    const size = buffer.byteLength
    require(size >= header && String.fromCharCode(...this.bytes.subarray(0, 8)) === 'OCCLPVS1' && this.#long(8) === size)
    this.model = this.view.getBigUint64(16, true)
    this.cells = this.view.getUint32(24, true)
    this.items = this.view.getUint32(28, true)
    require(header + this.cells * (ofBox + 16) + 8 <= size)
  }
  /** Reads all. Throws Error if any byte is damaged. */
  check() {
    let low = 0x84222325, high = 0xcbf29ce4
    this.bytes.forEach((byte, at) => {
      if (at >= 40 && at < 48) return
      const mixed = (low ^ byte) >>> 0, product = mixed * 0x1b3
      high = (high * 0x1b3 + mixed * 2 ** 8 + Math.floor(product / 2 ** 32)) % 2 ** 32
      low = product % 2 ** 32
    })
    require(this.view.getUint32(40, true) === low && this.view.getUint32(44, true) === high)
  }
  /** The least corner of a cell and the greatest: six numbers. */
  box(cell) {
    return Array.from({length: 6}, (_, i) => this.view.getFloat64(header + this.#known(cell) * ofBox + 8 * i, true))
  }
  /** The first cell that holds the eye; undefined if there is none. */
  cellAt(eye) {
    let first = 0
    for (let end = this.cells; first < end;) {
      const middle = Math.floor((first + end) / 2)
      if (this.box(middle)[0] < eye[0] - this.view.getFloat64(32, true)) first = middle + 1
      else end = middle
    }
    for (let cell = first; cell < this.cells; ++cell) {
      const box = this.box(cell)
      if (box[0] > eye[0]) return undefined
      if (eye.every((x, i) => box[i] <= x && x <= box[i + 3])) return cell
    }
    return undefined
  }
  /** The items that may be seen from somewhere in the cell: all others are hidden from everywhere in it. With another cell,
      whether something of that one may be seen. */
  visible(cell, other) {
    return other === undefined ? this.#set(0, this.#known(cell), this.items) : this.visibleCells(cell).includes(this.#known(other))
  }
  /** The cells of which something may be seen from somewhere in this one. */
  visibleCells(cell) { return this.#set(this.cells, this.#known(cell), this.cells) }

  #long(place) { return Number(this.view.getBigUint64(place, true)) }
  #known(cell) {
    if (!(Number.isInteger(cell) && cell >= 0 && cell < this.cells)) throw new RangeError('no such cell')
    return cell
  }
  /** The set of a cell, by the sets from which it differs; those of its kind begin with the set `first`. */
  #set(first, cell, size) {
    const changes = new Set()
    for (let others = 0, back = -1; back !== 0; ++others) {
      const numbers = this.#numbers(first + cell)
      let at = 0
      back = numbers[0]
      for (const step of numbers.slice(1)) {
        at += step
        if (!changes.delete(at)) changes.add(at)
      }
      require(at <= size && numbers.length % 2 === 1 && back <= cell && others <= 8)
      cell -= back
    }
    const ends = [...changes].sort((a, b) => a - b), set = []
    for (let i = 0; i < ends.length; i += 2) {
      for (let item = ends[i]; item < ends[i + 1]; ++item) set.push(item)
    }
    return set
  }
  #numbers(set) {
    const place = header + this.cells * ofBox + 8 * set, numbers = []
    const begin = this.#long(place), end = this.#long(place + 8)
    require(begin < end && end <= this.bytes.length && this.bytes[end - 1] < 128)
    let value = 0, unit = 1
    for (const byte of this.bytes.subarray(begin, end)) {
      value += byte % 128 * unit
      unit *= 128
      require(unit <= 2 ** 35)
      if (byte < 128) {
        numbers.push(value);
        [value, unit] = [0, 1]
      }
    }
    return numbers
  }
}
