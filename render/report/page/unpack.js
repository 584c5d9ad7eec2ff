// SPDX-License-Identifier: MIT
// A walk as parts of the page have it: as page_model.h and page_frames.h of render/report/src write them.

/** first[i] is the sum of the numbers before the i-th; the last element is the sum of all. */
function runningSums(bytes, of = n => n) {
  const numbers = new Numbers(bytes), sums = [0];
  while (!numbers.isAtEnd) sums.push(sums[sums.length - 1] + of(numbers.next()));
  return Uint32Array.from(sums);
}

/** The index of the last element of ascending `sums` that is at most `value`, skipping empty ranges. */
function rangeOf(sums, value) {
  let low = 0, high = sums.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (sums[middle] <= value) low = middle;
    else high = middle;
  }
  return low;
}

/** A model: leaves of polygons, polygons of triangles, and triangles with corners of their own. */
class Model {
  constructor(scene, parts) {
    this.low = scene.low;
    this.step = scene.step;
    this.steps = scene.steps;
    this.firstPolygon = runningSums(parts.leaves);               // of each leaf
    this.firstTriangle = runningSums(parts.sides, sides => (sides >> 1) - 2);  // of each polygon
    this.leaves = this.firstPolygon.length - 1;
    this.polygons = this.firstTriangle.length - 1;
    this.triangles = this.firstTriangle[this.polygons];
    this.readNumbers(parts.numbers);
    this.readVain(parts.vain ?? new Uint8Array(this.polygons));
    this.readTriangles(unpackVertices(parts.vertices), new Numbers(parts.sides), new Numbers(parts.corners));
  }
  readNumbers(bytes) {
    const numbers = new Numbers(bytes);
    this.numbers = new Uint32Array(this.polygons);  // in the model file
    for (let p = 0, number = 0; p < this.polygons; ++p) this.numbers[p] = number += numbers.difference();
  }
  /** In how many of the frames each polygon was drawn though it is hidden. */
  readVain(bytes) {
    const numbers = new Numbers(bytes);
    this.vain = new Uint32Array(this.polygons);
    this.mostVain = 0;
    for (let p = 0; p < this.polygons; ++p) {
      this.vain[p] = numbers.next();
      this.mostVain = Math.max(this.mostVain, this.vain[p]);
    }
  }
  readTriangles(points, sides, corners) {
    this.corners = new Int32Array(9 * this.triangles);  // x, y and z of each corner of each triangle
    this.cornerLeaves = new Uint32Array(3 * this.triangles);  // twice the leaf, and 1 more of what is see-through
    let unused = 0, at = 0, leaf = 0, seeThrough = 0;
    const nextCorner = () => {
      const back = corners.next();
      return back === 0 ? unused++ : unused - back;
    };
    const put = vertex => {
      this.corners[3 * at] = points[3 * vertex];
      this.corners[3 * at + 1] = points[3 * vertex + 1];
      this.corners[3 * at + 2] = points[3 * vertex + 2];
      this.cornerLeaves[at++] = 2 * leaf + seeThrough;
    };
    for (let p = 0; p < this.polygons; ++p) {
      while (this.firstPolygon[leaf + 1] <= p) ++leaf;
      const side = sides.next(), first = nextCorner();
      seeThrough = side & 1;
      for (let k = side >> 1, before = nextCorner(); k > 2; --k) {
        const corner = nextCorner();
        put(first);
        put(before);
        put(corner);
        before = corner;
      }
    }
  }
  leafOf(polygon) {
    return rangeOf(this.firstPolygon, polygon);
  }
  polygonOf(triangle) {
    return rangeOf(this.firstTriangle, triangle);
  }
  /** A point of the grid in the model's own coordinates. */
  point(corner) {
    return [0, 1, 2].map(axis => this.low[axis] + this.step * corner[axis]);
  }
  /** The first corner of a polygon. */
  cornerOf(polygon) {
    const at = 9 * this.firstTriangle[polygon];
    return this.point([this.corners[at], this.corners[at + 1], this.corners[at + 2]]);
  }
  /** The polygons of a leaf. */
  polygonsIn(leaf) {
    const first = this.firstPolygon[leaf];
    return Array.from({length: this.firstPolygon[leaf + 1] - first}, (_, i) => first + i);
  }
  /** The box of each leaf: six numbers on the grid, the least of each axis and then the most. */
  get leafBoxes() {
    return this.boxes ??= this.findLeafBoxes();
  }
  findLeafBoxes() {
    const boxes = new Int32Array(6 * this.leaves);
    for (let leaf = 0; leaf < this.leaves; ++leaf) {
      const begin = 9 * this.firstTriangle[this.firstPolygon[leaf]], end = 9 * this.firstTriangle[this.firstPolygon[leaf + 1]];
      for (let axis = 0; axis < 3; ++axis) {
        let low = Infinity, high = -Infinity;
        for (let at = begin + axis; at < end; at += 3) {
          if (this.corners[at] < low) low = this.corners[at];
          if (this.corners[at] > high) high = this.corners[at];
        }
        boxes[6 * leaf + axis] = begin < end ? low : 0x7fffffff;
        boxes[6 * leaf + 3 + axis] = begin < end ? high : -0x80000000;
      }
    }
    return boxes;
  }
  /** The box of some leaves: its least and its greatest corner; null if the page has none of their polygons. */
  boxOf(first, end) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], {leafBoxes} = this;
    for (let leaf = first; leaf < end; ++leaf) {
      for (let axis = 0; axis < 3; ++axis) {
        const at = 6 * leaf + axis;
        if (leafBoxes[at] < low[axis]) low[axis] = leafBoxes[at];
        if (leafBoxes[at + 3] > high[axis]) high[axis] = leafBoxes[at + 3];
      }
    }
    return low[0] <= high[0] ? [this.point(low), this.point(high)] : null;
  }
}

/** What a click on a polygon tells, of some frames of a walk. */
class Details {
  constructor(bytes) {
    this.bytes = bytes;
    this.starts = new Map();  // by the number of the frame
    for (let numbers = new Numbers(bytes), frame = 0; !numbers.isAtEnd;) {
      frame += numbers.next();
      const length = numbers.next();
      this.starts.set(frame, {first: numbers.at, end: numbers.at + length});
      numbers.at += length;
    }
  }
  /** The frame with details that is nearest to frame i. */
  nearest(i) {
    return [...this.starts.keys()].reduce((best, frame) => Math.abs(frame - i) < Math.abs(best - i) ? frame : best, Infinity);
  }
  /**
   * The planes that culled each subtree of a frame that was not culled by a cover, in their order, and the distances from
   * them; and by the place of each hidden polygon that was drawn: why, and the number of what hides it alone, or -1.
   */
  at(i) {
    if (!this.starts.has(i)) return null;
    const {first, end} = this.starts.get(i), numbers = new Numbers(this.bytes, first), count = numbers.next();
    const planes = Array.from({length: count}, () => numbers.next());
    const distances = this.floats(numbers.at, count);
    numbers.at += 4 * count;
    const missed = new Map();
    for (let place = 0; numbers.at < end;) {
      place += numbers.next();
      const length = numbers.next(), answer = {reason: numbers.next(), occluder: numbers.next() - 1};
      for (const last = place + length; place < last; ++place) missed.set(place, answer);
    }
    return {planes, distances, missed};
  }
  /** First the lowest byte of all, then the next ones. */
  floats(at, count) {
    const {bytes} = this, bits = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
      for (let k = 0; k < 4; ++k) bits[i] |= bytes[at + k * count + i] << 8 * k;
    }
    return new Float32Array(bits.buffer);
  }
}

/** What may become of a leaf. From Fate.hidden on: hidden by the hider of colour fate - Fate.hidden. */
const Fate = {drawn: 0, outOfView: 1, covered: 2, hidden: 3};

/** The frames of a walk that the viewer shows. */
class Frames {
  constructor(scene, bytes, leaves) {
    this.outlines = scene.outlines;
    this.leaves = leaves;
    this.bytes = bytes;
    this.starts = [];
    for (const numbers = new Numbers(bytes); !numbers.isAtEnd;) {
      const length = numbers.next();
      this.starts.push(numbers.at);
      numbers.at += length;
    }
  }
  get count() {
    return this.starts.length;
  }
  /** Its occluders, its hiders by their colours, the fate of each leaf, and the culled subtrees as ranges of leaves. */
  at(i) {
    const numbers = new Numbers(this.bytes, this.starts[i]);
    const occluders = Array.from({length: numbers.next()}, () => ({outline: this.outlines[numbers.next()], hidden: numbers.next()}));
    const hiders = new Map();
    for (let n = numbers.next(); n > 0; --n) {
      const colour = numbers.next();
      const both = [occluders[numbers.next()], occluders[numbers.next() - 1]];
      hiders.set(colour, both.filter(occluder => occluder));
    }
    const fates = new Uint16Array(this.leaves), culled = [];
    for (let leaf = 0; leaf < this.leaves;) {
      const fate = numbers.next(), end = leaf + numbers.next();
      fates.fill(fate, leaf, end);
      if (fate !== Fate.drawn) culled.push({fate, first: leaf, end});
      leaf = end;
    }
    return {occluders, hiders, fates, culled};
  }
}
