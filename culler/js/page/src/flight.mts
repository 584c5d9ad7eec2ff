// SPDX-License-Identifier: MIT
import {levelAxes} from "./axes.mjs";
import type {Place} from "./camera.mjs";
import type {Flight, Model} from "./model.mjs";
import {add, dot, mix, scale, subtract, type Point} from "./points.mjs";

/** A share of the way, from 0 to 1. */
export function placeOf({places}: Flight, share: number): Place {
  const at = share * (places.length - 1), first = Math.min(places.length - 2, Math.max(0, Math.floor(at))), rest = at - first;
  const a = places[first]!, b = places[first + 1]!;
  return {eye: mix(a.eye, b.eye, rest), target: mix(a.target, b.target, rest)};
}

/** Round the model, looking at it, once in so many seconds, so high that one looks into a court. */
export function orbit({low, high, size}: Model["box"], up: Point): Flight {
  const middle = mix(low, high, 0.5), {east, north} = levelAxes(up), steps = 180;
  const above = Math.min(Math.max(0.25 * size, 1.3 * Math.abs(dot(subtract(high, low), up))), 0.45 * size);
  const places = Array.from({length: steps + 1}, (_, i): Place => {
    const angle = (2 * Math.PI * i) / steps, out = add(scale(east, Math.cos(angle)), scale(north, Math.sin(angle)));
    return {eye: add(middle, add(scale(out, 0.62 * size), scale(up, above))), target: middle};
  });
  return {places, seconds: 40};
}
