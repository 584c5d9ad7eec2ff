// SPDX-License-Identifier: MIT
// The model that `occlude inspect` has put into the page, as render/report/src/packed_soup.h writes it.
import {Builder} from "./builder.mjs";
import {moved, type Place} from "./camera.mjs";
import {orbit} from "./flight.mjs";
import type {Flight, Lens, Model} from "./model.mjs";
import {bytesOfPart, hasPart, jsonOfPart, Numbers, unpackVertices} from "./parts.mjs";
import {scale, unit, type Point} from "./points.mjs";
import type {Scene} from "./scenes.mjs";

/** What the command says beside the model, in the coordinates of the file. */
interface Start {
  readonly name: string;
  readonly origin: Point;
  readonly up: Point;
  /** Along the path that was given, if one was. */
  readonly path?: {readonly places: readonly Place[]; readonly seconds: number; readonly lens: Lens};
}

/** The scene that the page was made for; none in a page that was made for all. */
export async function sceneInside(): Promise<Scene | undefined> {
  if (!hasPart("model")) return undefined;
  const [start, bytes] = await Promise.all([jsonOfPart("start") as Promise<Start>, bytesOfPart("model")]);
  return {key: "inside", title: start.name, make: () => modelOf(start, bytes)};
}

/** Bits of what is said of a polygon, below its number of sides. */
const kSeeThrough = 1, kSameFace = 2, kFlagBits = 2;

const kWhite = 0xffffff;

/** The colour of each polygon, 65536 red + 256 green + blue; nothing if all have the same. */
function tintsIn(packed: Numbers, polygons: number): Uint32Array | undefined {
  let before = 0, place = 0;
  const palette = Uint32Array.from({length: packed.next()}, () => (before += packed.next()));
  return palette.length === 0 ? undefined : Uint32Array.from({length: polygons}, () => palette[(place += packed.difference())]!);
}

/** The fans of all polygons. */
function modelOf({name, origin, up, path}: Start, bytes: Uint8Array): Model {
  const packed = new Numbers(bytes), polygons = packed.next();
  const sides = Uint32Array.from({length: polygons}, () => packed.next());
  const triangles = sides.reduce((sum, side) => sum + (side >> kFlagBits) - 2, 0);
  let before = 0;
  const indices = Uint32Array.from({length: triangles + 2 * polygons}, () => (before += packed.difference()));
  const tints = tintsIn(packed, polygons);
  const vertices = new Float32Array(unpackVertices(bytes.subarray(packed.at)).buffer);
  const corners = new Float32Array(9 * triangles), colours = new Uint8Array(12 * triangles), numbers = new Uint32Array(triangles);
  let face = -1, first = 0, triangle = 0;
  sides.forEach((side, polygon) => {
    const tint = tints?.[polygon] ?? kWhite, colour = [tint >> 16, (tint >> 8) & 0xff, tint & 0xff, side & kSeeThrough ? 0 : 255];
    if ((side & kSameFace) === 0) ++face;
    const end = first + (side >> kFlagBits);
    for (let i = first + 1; i + 1 < end; ++i, ++triangle) {
      [first, i, i + 1].forEach((at, k) => corners.set(vertices.subarray(3 * indices[at]!, 3 * indices[at]! + 3), 9 * triangle + 3 * k));
      for (let k = 0; k < 12; k += 4) colours.set(colour, 12 * triangle + k);
      numbers[triangle] = face;
    }
    first = end;
  });
  const builder = new Builder();
  builder.add(name, corners, colours, numbers);
  const level = unit(up);
  const flightIn = (box: Model["box"]): Flight =>
    path ? {places: path.places.map(place => moved(place, scale(origin, -1))), seconds: path.seconds} : orbit(box, level);
  return builder.model({name, origin, up: level, isColoured: tints !== undefined, cameras: [], facet: "polygon", lens: path?.lens, flightIn});
}
