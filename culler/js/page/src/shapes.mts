// SPDX-License-Identifier: MIT
// Simple things of which scenes are built. All sizes are in metres, z is up.
import type {Builder, Colour} from "./builder.mjs";
import type {Point} from "./points.mjs";

/** Triangles of one object that is being made. */
export class Shape {
  readonly #corners: number[] = [];
  readonly #colours: number[] = [];

  triangle(a: Point, b: Point, c: Point, colour: Colour): this {
    this.#corners.push(...a, ...b, ...c);
    for (let corner = 0; corner < 3; ++corner) this.#colours.push(...colour, 255);
    return this;
  }
  quad(a: Point, b: Point, c: Point, d: Point, colour: Colour): this {
    return this.triangle(a, b, c, colour).triangle(a, c, d, colour);
  }

  /** Stands on `at`, turned about z: `size` is how wide, deep and high it is. */
  box(at: Point, [width, depth, height]: Point, colour: Colour, turn = 0): this {
    const [x, y, z] = [width / 2, depth / 2, height];
    const corner = (i: number, up: number): Point => placed(at, [i === 0 || i === 3 ? -x : x, i < 2 ? -y : y, up], turn);
    for (let i = 0; i < 4; ++i) {
      const next = (i + 1) % 4;
      this.quad(corner(i, 0), corner(next, 0), corner(next, z), corner(i, z), colour);
    }
    this.quad(corner(0, z), corner(1, z), corner(2, z), corner(3, z), colour);
    return this.quad(corner(3, 0), corner(2, 0), corner(1, 0), corner(0, 0), colour);
  }

  /** A prism, or with radius 0 above a pyramid, of so many sides. */
  prism(at: Point, below: number, above: number, height: number, sides: number, colour: Colour): this {
    const corner = (i: number, radius: number, up: number): Point => {
      const angle = (2 * Math.PI * i) / sides;
      return placed(at, [radius * Math.cos(angle), radius * Math.sin(angle), up], 0);
    };
    const top = placed(at, [0, 0, height], 0);
    for (let i = 0; i < sides; ++i) {
      const a = corner(i, below, 0), b = corner(i + 1, below, 0);
      if (above === 0) this.triangle(a, b, top, colour);
      else {
        const c = corner(i + 1, above, height), d = corner(i, above, height);
        this.quad(a, b, c, d, colour).triangle(d, c, top, colour);
      }
    }
    return this;
  }

  /** A roof with its ridge along the width. */
  gable(at: Point, [width, depth, height]: Point, colour: Colour, ends: Colour, turn = 0): this {
    const [x, y] = [width / 2, depth / 2];
    const at3 = (p: Point) => placed(at, p, turn);
    const [a, b, c, d] = [at3([-x, -y, 0]), at3([x, -y, 0]), at3([x, y, 0]), at3([-x, y, 0])];
    const [e, f] = [at3([-x, 0, height]), at3([x, 0, height])];
    return this.quad(a, b, f, e, colour).quad(c, d, e, f, colour).triangle(b, c, f, ends).triangle(d, a, e, ends);
  }

  addTo(builder: Builder, name: string): void {
    builder.add(name, Float32Array.from(this.#corners), Uint8Array.from(this.#colours));
  }
}

function placed(at: Point, [x, y, z]: Point, turn: number): Point {
  const c = Math.cos(turn), s = Math.sin(turn);
  return [at[0] + c * x - s * y, at[1] + s * x + c * y, at[2] + z];
}

/** A somebody: legs, body and head. */
export const person = (at: Point, colour: Colour): Shape =>
  new Shape()
    .prism(at, 0.14, 0.18, 0.85, 6, [58, 62, 78])
    .prism([at[0], at[1], at[2] + 0.85], 0.24, 0.18, 0.6, 6, colour)
    .prism([at[0], at[1], at[2] + 1.48], 0.1, 0.12, 0.24, 6, [222, 176, 140]);

export const tree = (at: Point, height: number, colour: Colour): Shape =>
  new Shape()
    .prism(at, 0.025 * height, 0.018 * height, 0.45 * height, 6, [104, 82, 62])
    .prism([at[0], at[1], at[2] + 0.3 * height], 0.2 * height, 0, 0.4 * height, 7, colour)
    .prism([at[0], at[1], at[2] + 0.52 * height], 0.15 * height, 0, 0.48 * height, 7, colour);

export const lamp = (at: Point): Shape =>
  new Shape().prism(at, 0.05, 0.04, 3.6, 5, [70, 76, 84]).prism([at[0], at[1], at[2] + 3.6], 0.16, 0, 0.3, 5, [240, 222, 160]);

export const car = (at: Point, colour: Colour, turn: number): Shape =>
  new Shape()
    .box([at[0], at[1], at[2] + 0.3], [4.2, 1.7, 0.55], colour, turn)
    .box([at[0], at[1], at[2] + 0.85], [2.2, 1.5, 0.5], [70, 86, 100], turn)
    .box([at[0], at[1], at[2]], [3.4, 1.72, 0.3], [40, 42, 46], turn);
