// SPDX-License-Identifier: MIT
// Whether a ray reaches a triangle: proved, never by rounding. Coordinates are single-precision numbers and thus exact doubles; a sign is
// believed only where the error of its determinant, as bounded by Shewchuk, cannot change it.
import {cornerOf, isSeeThrough, triangleCount, type Model} from "./model.mjs";
import {add, cross, dot, scale, subtract, type Point} from "./points.mjs";

/** A segment that crosses one triangle and certainly misses all others that hide. */
export interface Proof {
  readonly from: Point;
  readonly to: Point;
  readonly triangle: number;
  /** How many triangles it was held against. */
  readonly missed: number;
}

/**
 * Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997: the first bound of orient3d, (7 + 56 e) e
 * with e = 2^-53, times what the determinant would be if nothing cancelled.
 */
const kOrientError = (7 + 56 * 2 ** -53) * 2 ** -53;

/** On which side of the plane through a, b and c the point is: -1 or 1, and 0 where that is not certain. */
export function side(a: Point, b: Point, c: Point, point: Point): -1 | 0 | 1 {
  const u = subtract(a, point), v = subtract(b, point), w = subtract(c, point);
  let sum = 0, most = 0;
  for (let i = 0; i < 3; ++i) {
    const j = (i + 1) % 3, k = (i + 2) % 3;
    const one = v[j]! * w[k]!, other = v[k]! * w[j]!;
    sum += u[i]! * (one - other);
    most += Math.abs(u[i]!) * (Math.abs(one) + Math.abs(other));
  }
  const error = kOrientError * most;
  return sum > error ? 1 : sum < -error ? -1 : 0;
}

/** Whether the segment crosses the inside of the triangle, or misses the triangle; undefined where that is not certain. */
export function crosses(from: Point, to: Point, a: Point, b: Point, c: Point): boolean | undefined {
  if (isApart(from, to, a, b, c)) return false;
  const before = side(a, b, c, from), behind = side(a, b, c, to);
  if (before !== 0 && before === behind) return false;
  const edges = [side(from, to, a, b), side(from, to, b, c), side(from, to, c, a)];
  if (edges.includes(1) && edges.includes(-1)) return false;
  return before * behind === -1 && !edges.includes(0) ? true : undefined;
}

/** Whether their boxes share no point. */
function isApart(from: Point, to: Point, a: Point, b: Point, c: Point): boolean {
  for (let i = 0; i < 3; ++i) {
    const low = Math.min(from[i]!, to[i]!), high = Math.max(from[i]!, to[i]!);
    if (Math.max(a[i]!, b[i]!, c[i]!) < low || Math.min(a[i]!, b[i]!, c[i]!) > high) return true;
  }
  return false;
}

/** By how much of its length the segment goes on behind the triangle. */
const kBehind = 2 ** -24;

/** Proves that the eye sees the triangle along this direction, if that can be. */
export function prove(model: Model, eye: Point, direction: Point, triangle: number): Proof | undefined {
  const corners = (t: number): [Point, Point, Point] => [cornerOf(model, t, 0), cornerOf(model, t, 1), cornerOf(model, t, 2)];
  const [a, b, c] = corners(triangle);
  const normal = cross(subtract(b, a), subtract(c, a));
  const far = dot(normal, subtract(a, eye)) / dot(normal, direction);
  const to = add(eye, scale(direction, far * (1 + kBehind)));
  if (!(far > 0) || crosses(eye, to, a, b, c) !== true) return undefined;
  const count = triangleCount(model);
  let missed = 0;
  for (let t = 0; t < count; ++t) {
    if (t === triangle || isSeeThrough(model, t)) continue;
    if (crosses(eye, to, ...corners(t)) !== false) return undefined;
    ++missed;
  }
  return {from: eye, to, triangle, missed};
}
