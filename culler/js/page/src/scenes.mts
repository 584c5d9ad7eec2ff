// SPDX-License-Identifier: MIT
// The built-in scenes. Each is kind to cullers in its own way, and has a way to mislead them: what shows shows through gaps, behind
// corners and from afar.
import {Builder, type Colour} from "./builder.mjs";
import type {Place} from "./camera.mjs";
import type {Flight, Model} from "./model.mjs";
import {add, scale, subtract, unit, type Point} from "./points.mjs";
import {random} from "./random.mjs";
import {car, lamp, person, Shape, tree} from "./shapes.mjs";

export interface Scene {
  readonly key: string;
  readonly title: string;
  readonly make: () => Model;
}

export const scenes: readonly Scene[] = [
  {key: "town", title: "Town", make: town},
  {key: "park", title: "Park", make: park},
  {key: "rooms", title: "Rooms", make: rooms},
  {key: "forest", title: "Forest", make: forest},
  {key: "store", title: "Store", make: store},
];

/** A point on the ground. */
type Flat = readonly [number, number];

const up: Point = [0, 0, 1];
const kEyeHeight = 1.7;

/** Somebody who goes from point to point, looking along the way. */
function walk(points: readonly Flat[], speed: number, height = kEyeHeight): Flight {
  const eyes = points.map(([x, y]): Point => [x, y, height]);
  const places: Place[] = [];
  let way = 0;
  // A step is so short that corners are turned in about a second.
  const step = 0.5;
  for (let i = 0; i + 1 < eyes.length; ++i) {
    const along = subtract(eyes[i + 1]!, eyes[i]!), long = Math.hypot(...along), steps = Math.max(1, Math.round(long / step));
    for (let s = 0; s < steps; ++s) {
      const eye = add(eyes[i]!, scale(along, s / steps));
      places.push({eye, target: add(eye, unit(along))});
    }
    way += long;
  }
  return {places: places.map((place, i) => ({...place, target: add(place.eye, headingAt(places, i))})), seconds: way / speed};
}

/** The mean direction of the steps near one. */
function headingAt(places: readonly Place[], i: number): Point {
  const near = 6;
  let sum: Point = [0, 0, -0.02 * (2 * near + 1)];
  for (let k = -near; k <= near; ++k) {
    const {eye, target} = places[Math.min(places.length - 1, Math.max(0, i + k))]!;
    sum = add(sum, subtract(target, eye));
  }
  return unit(sum);
}

const finished = (builder: Builder, name: string, flightIn: () => Flight): Model =>
  builder.model({name, up, isColoured: true, cameras: [], flightIn});

const hut = (at: Point, wall: Colour, roof: Colour, turn: number): Shape =>
  new Shape().box(at, [4, 3, 2.4], wall, turn).gable([at[0], at[1], at[2] + 2.4], [4.4, 3.4, 1.4], roof, wall, turn);

const pick = <T,>(from: readonly T[], next: () => number): T => from[Math.floor(next() * from.length)]!;
const shade = ([r, g, b]: Colour, by: number): Colour => [r * by, g * by, b * by];

/** A floor of tiles, so that no object is as large as the scene. */
function floor(builder: Builder, name: string, [x0, y0]: Flat, [x1, y1]: Flat, tile: number, colour: Colour): void {
  for (let x = x0; x < x1; x += tile) {
    for (let y = y0; y < y1; y += tile) {
      const [right, back] = [Math.min(x + tile, x1), Math.min(y + tile, y1)];
      new Shape().quad([x, y, 0], [right, y, 0], [right, back, 0], [x, back, 0], colour).addTo(builder, name);
    }
  }
}

const walls: readonly Colour[] = [[214, 196, 168], [198, 150, 122], [226, 214, 190], [176, 136, 112], [188, 178, 160], [206, 170, 130]];
const roofs: readonly Colour[] = [[152, 90, 70], [120, 84, 72], [110, 104, 100], [166, 108, 80]];
const clothes: readonly Colour[] = [[52, 110, 160], [190, 70, 60], [220, 190, 90], [70, 130, 100], [230, 228, 220]];
const leaves: readonly Colour[] = [[96, 124, 70], [112, 132, 78], [84, 108, 66]];

function town(): Model {
  const next = random(7), builder = new Builder();
  const blocks = 7, pitch = 34, street = 9, middle = (blocks * pitch) / 2;
  floor(builder, "Ground", [-middle - 20, -middle - 20], [middle + 20, middle + 20], 34, [150, 146, 138]);
  for (let bx = 0; bx < blocks; ++bx) {
    for (let by = 0; by < blocks; ++by) {
      const left = bx * pitch - middle + street / 2, front = by * pitch - middle + street / 2, side = pitch - street;
      if ((bx === 3 && by === 3) || next() < 0.05) {
        square(builder, [left + side / 2, front + side / 2], side, next);
        continue;
      }
      // Houses around a yard, with gaps between some of them.
      const plots = 3, wide = side / plots;
      for (let i = 0; i < plots; ++i) {
        for (let k = 0; k < plots; ++k) {
          if (i === 1 && k === 1) continue;
          const at: Point = [left + (i + 0.5) * wide, front + (k + 0.5) * wide, 0];
          house(builder, at, wide - (next() < 0.4 ? 0.9 : 0), i !== 1 ? 0 : Math.PI / 2, next);
        }
      }
      tree([left + side / 2, front + side / 2, 0], 5 + 3 * next(), pick(leaves, next)).addTo(builder, "Tree in a yard");
    }
  }
  for (let i = 0; i < 300; ++i) {
    const along = (next() - 0.5) * 2 * middle, lane = Math.floor(next() * (blocks + 1)) * pitch - middle;
    const aside = (next() < 0.5 ? -1 : 1) * (2.4 + 1.4 * next());
    const isX = next() < 0.5;
    const at: Point = isX ? [along, lane + aside, 0] : [lane + aside, along, 0];
    if (next() < 0.45) person(at, pick(clothes, next)).addTo(builder, "Passer-by");
    else if (next() < 0.5) car(at, pick(clothes, next), isX ? 0 : Math.PI / 2).addTo(builder, "Car");
    else lamp(at).addTo(builder, "Lamp");
  }
  const c = (i: number) => i * pitch - middle;
  const round = [[1, 1], [1, 3], [4, 3], [4, 6], [6, 6], [6, 2], [2, 2], [2, 1], [1, 1]] as const;
  return finished(builder, "Town", () => walk(round.map(([i, k]) => [c(i), c(k)]), 7));
}

function house(builder: Builder, at: Point, wide: number, turn: number, next: () => number): void {
  const storeys = 2 + Math.floor(3 * next()), high = 3 * storeys, wall = pick(walls, next), roof = pick(roofs, next);
  new Shape().box(at, [wide, wide, high], wall, turn)
    .gable([at[0], at[1], high], [wide, wide, 2 + 2 * next()], roof, shade(wall, 0.92), turn)
    .box([at[0] + 1.5, at[1] + 1, high + 0.6], [0.7, 0.7, 2.6], shade(roof, 0.8), turn).addTo(builder, "House");
  const openings = new Shape();
  for (let s = 0; s < storeys; ++s) {
    for (let w = 0; w < 3; ++w) {
      for (let side = 0; side < 4; ++side) {
        const angle = (side * Math.PI) / 2, across = (w - 1) * (wide / 3.4), out = wide / 2 + 0.03;
        const isDoor = s === 0 && w === 1;
        const low = isDoor ? 0 : 3 * s + 0.9, high = low + (isDoor ? 2.1 : 1.4);
        const corner = (beside: number, z: number): Point => {
          const far = across + beside;
          return [at[0] + Math.cos(angle) * out - Math.sin(angle) * far, at[1] + Math.sin(angle) * out + Math.cos(angle) * far, z];
        };
        const colour: Colour = isDoor ? [110, 78, 58] : [74, 92, 108];
        openings.quad(corner(-0.5, low), corner(0.5, low), corner(0.5, high), corner(-0.5, high), colour);
      }
    }
  }
  openings.addTo(builder, "Windows and doors");
}

function square(builder: Builder, [x, y]: Flat, side: number, next: () => number): void {
  for (let i = 0; i < 14; ++i) {
    const at: Point = [x + (next() - 0.5) * side, y + (next() - 0.5) * side, 0];
    tree(at, 5 + 4 * next(), pick(leaves, next)).addTo(builder, "Tree");
  }
  new Shape().prism([x, y, 0], 3, 3, 0.7, 16, [170, 166, 158])
    .prism([x, y, 0.7], 0.6, 0.4, 2.4, 8, [190, 186, 176]).addTo(builder, "Fountain");
}

function park(): Model {
  const next = random(11), builder = new Builder();
  floor(builder, "Lawn", [-90, -60], [90, 60], 15, [132, 148, 100]);
  // Two rows of palings along the way: gaps of two centimetres.
  for (const y of [-4, 4, 20, -20]) {
    for (let x = -85; x < 85; x += 2.5) {
      const panel = new Shape();
      for (let i = 0; i < 16; ++i) panel.box([x + i * (2.5 / 16), y, 0], [2.5 / 16 - 0.02, 0.04, 2.3 + 0.1 * (i % 2)], [176, 150, 118]);
      panel.addTo(builder, "Palings");
    }
  }
  for (let i = 0; i < 500; ++i) {
    const at: Point = [(next() - 0.5) * 168, (5 + 13 * next()) * (next() < 0.5 ? -1 : 1), 0];
    if (next() < 0.6) person(at, pick(clothes, next)).addTo(builder, "Visitor");
    else new Shape().box(at, [1.6, 0.5, 0.5], [150, 110, 80], 3 * next()).addTo(builder, "Bench");
  }
  for (let i = 0; i < 260; ++i) {
    const at: Point = [(next() - 0.5) * 170, (24 + 32 * next()) * (next() < 0.5 ? -1 : 1), 0];
    tree(at, 6 + 6 * next(), pick(leaves, next)).addTo(builder, "Tree");
  }
  return finished(builder, "Park", () => {
    const flight = walk([[-80, 0], [80, 0]], 5);
    const glance = ({eye}: Place, i: number): Place => {
      const angle = 0.9 * Math.sin(i / 14);
      return {eye, target: add(eye, [Math.cos(angle), Math.sin(angle), -0.03])};
    };
    return {...flight, places: flight.places.map(glance)};
  });
}

function rooms(): Model {
  const next = random(5), builder = new Builder();
  const count = 9, pitch = 6, height = 3, wall: Colour = [222, 212, 194];
  const size = count * pitch, middle = (i: number) => (i + 0.5) * pitch;
  /** Rooms through which the way leads. */
  const isWay = (i: number, k: number) => ((i === 2 || i === 6) && k >= 2 && k <= 6) || ((k === 2 || k === 6) && i >= 2 && i <= 6);
  floor(builder, "Floor", [0, 0], [size, size], pitch, [160, 130, 100]);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < count; ++k) {
      const [x, y] = [i * pitch, k * pitch];
      new Shape().quad([x, y, height], [x, y + pitch, height], [x + pitch, y + pitch, height], [x + pitch, y, height], [236, 232, 224])
        .addTo(builder, "Ceiling");
      if (i > 0) partition([x, y + pitch / 2], Math.PI / 2, isWay(i, k) && isWay(i - 1, k));
      if (k > 0) partition([x + pitch / 2, y], 0, isWay(i, k) && isWay(i, k - 1));
      for (let f = 0; f < 5; ++f) {
        const at: Point = [x + 0.8 + 4.4 * next(), y + 0.8 + 4.4 * next(), 0];
        if (isWay(i, k) && (Math.abs(at[0] - middle(i)) < 0.9 || Math.abs(at[1] - middle(k)) < 0.9)) continue;
        if (next() < 0.25) person(at, pick(clothes, next)).addTo(builder, "Somebody");
        else new Shape().box(at, [0.5 + next(), 0.5, 0.45 + 1.3 * next() ** 2], pick(walls, next), 6 * next()).addTo(builder, "Furniture");
      }
    }
  }
  const corners: readonly Flat[] = [[0, 0], [size, 0], [size, size], [0, size]];
  corners.forEach(([x, y], i) => {
    const [toX, toY] = corners[(i + 1) % 4]!;
    new Shape().quad([x, y, 0], [toX, toY, 0], [toX, toY, height], [x, y, height], wall).addTo(builder, "Outer wall");
  });
  const round: readonly Flat[] = [[2, 2], [6, 2], [6, 6], [2, 6], [2, 2]];
  return finished(builder, "Rooms", () => walk(round.map(([i, k]) => [middle(i), middle(k)]), 3, 1.6));

  /** A wall between two rooms, with a doorway whose door stands a hand's width open, or none. */
  function partition([x, y]: Flat, turn: number, isOpen: boolean): void {
    const door = 1, side = (pitch - door) / 2;
    const at = (far: number, z = 0): Point => [x + Math.cos(turn) * far, y + Math.sin(turn) * far, z];
    new Shape().box(at(-door / 2 - side / 2), [side, 0.12, height], wall, turn)
      .box(at(door / 2 + side / 2), [side, 0.12, height], wall, turn)
      .box(at(0, 2.1), [door, 0.12, height - 2.1], wall, turn).addTo(builder, "Wall");
    if (isOpen) return;
    // It turns about its hinge, at one side of the doorway.
    const heading = turn + 0.02 + 0.12 * next(), hinge = at(-door / 2);
    const leaf: Point = [hinge[0] + (Math.cos(heading) * door) / 2, hinge[1] + (Math.sin(heading) * door) / 2, 0];
    new Shape().box(leaf, [door - 0.01, 0.05, 2.09], [150, 104, 74], heading).addTo(builder, "Door");
  }
}

function forest(): Model {
  const next = random(3), builder = new Builder();
  const heightAt = (x: number, y: number) => 5 * Math.sin(x / 45) * Math.cos(y / 38) + 36 * Math.max(0, Math.abs(y) / 90 - 0.35) ** 2;
  const tile = 20;
  for (let x = -160; x < 160; x += tile) {
    for (let y = -160; y < 160; y += tile) {
      const part = new Shape(), step = tile / 4;
      for (let i = 0; i < 4; ++i) {
        for (let k = 0; k < 4; ++k) {
          const p = (a: number, b: number): Point => [x + a * step, y + b * step, heightAt(x + a * step, y + b * step)];
          part.quad(p(i, k), p(i + 1, k), p(i + 1, k + 1), p(i, k + 1), [128 + 8 * ((i + k) % 2), 134, 92]);
        }
      }
      part.addTo(builder, "Ground");
    }
  }
  const isOnWay = (x: number, y: number, near: number) => Math.abs(y - 18 * Math.sin(x / 30)) < near;
  for (let i = 0; i < 1900; ++i) {
    const x = (next() - 0.5) * 310, y = (next() - 0.5) * 310;
    if (isOnWay(x, y, 3)) continue;
    tree([x, y, heightAt(x, y) - 0.2], 7 + 9 * next(), pick(leaves, next)).addTo(builder, "Tree");
  }
  for (let i = 0; i < 160; ++i) {
    const x = (next() - 0.5) * 300, y = (next() - 0.5) * 300, at: Point = [x, y, heightAt(x, y) - 0.1];
    if (isOnWay(x, y, 5)) continue;
    if (next() < 0.5) person(at, pick(clothes, next)).addTo(builder, "Walker");
    else hut(at, pick(walls, next), pick(roofs, next), 6 * next()).addTo(builder, "Hut");
  }
  return finished(builder, "Forest", () => {
    const points = Array.from({length: 53}, (_, i): Flat => [-130 + 5 * i, 18 * Math.sin((-130 + 5 * i) / 30)]);
    const flight = walk(points, 7, 0);
    const lift = (p: Point, [x, y]: Point): Point => add(p, [0, 0, heightAt(x, y) + 1.7]);
    return {...flight, places: flight.places.map(({eye, target}) => ({eye: lift(eye, eye), target: lift(target, eye)}))};
  });
}

function store(): Model {
  const next = random(9), builder = new Builder();
  const aisles = 12, bays = 22, deep = 1.1, aisle = 2.6, wide = 2.7;
  const [length, width] = [bays * wide, aisles * (2 * deep + aisle)];
  const middleOf = (a: number) => a * (2 * deep + aisle) + 2 * deep + aisle / 2;
  floor(builder, "Floor", [-6, -4], [length + 6, width + 4], 12, [150, 152, 156]);
  for (let a = 0; a < aisles; ++a) {
    for (const side of [0, 1]) {
      const y = a * (2 * deep + aisle) + side * (deep + 0.06) + deep / 2;
      for (let b = 0; b < bays; ++b) {
        const x = (b + 0.5) * wide, rack = new Shape();
        for (let level = 0; level < 4; ++level) {
          rack.box([x, y, 0.1 + 1.3 * level], [wide, deep, 0.08], [74, 104, 134]);
          boxes(x, y, 0.18 + 1.3 * level);
        }
        for (const side of [-1, 1]) rack.box([x - wide / 2, y + side * (deep / 2 - 0.05), 0], [0.08, 0.08, 5.2], [200, 120, 60]);
        rack.addTo(builder, "Rack");
      }
    }
  }
  for (let i = 0; i < 60; ++i) {
    const at: Point = [next() * length, middleOf(Math.floor(next() * aisles)) + (next() < 0.5 ? -0.95 : 0.95), 0];
    person(at, pick(clothes, next)).addTo(builder, "Worker");
  }
  const [first, second, third] = [3, 6, 8].map(middleOf) as [number, number, number], [front, back] = [-3, length + 3];
  const way: Flat[] = [[front, first], [back, first], [back, second], [front, second], [front, third], [back, third]];
  return finished(builder, "Store", () => walk(way, 4));

  /** Side by side on one level of a rack, with gaps of a finger's width, and some missing. */
  function boxes(x: number, rowY: number, z: number): void {
    const stack = new Shape();
    for (let left = -wide / 2 + 0.1; left < wide / 2 - 0.6;) {
      const size = 0.45 + 0.35 * next();
      const colour: Colour = [186 - 40 * next(), 150 - 20 * next(), 104];
      if (next() > 0.08) stack.box([x + left + size / 2, rowY, z], [size, deep - 0.1, 0.8 + 0.34 * next()], colour);
      left += size + 0.015 + 0.03 * next();
    }
    stack.addTo(builder, "Boxes");
  }
}
