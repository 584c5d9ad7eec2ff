// SPDX-License-Identifier: MIT
// PLY files: faces with any number of corners, and colours of vertices or faces. The loader of three.js leaves out faces with more than
// four corners.

/** The fans of all faces. */
export interface Ply {
  /** Nine numbers of each triangle. */
  readonly corners: Float32Array<ArrayBuffer>;
  /** Red, green, blue and 255 of each corner: grey, if the file has no colours. */
  readonly colours: Uint8Array<ArrayBuffer>;
  readonly isColoured: boolean;
  /** The number of the face of each triangle. Faces with fewer than three corners do not count. */
  readonly faces: Uint32Array<ArrayBuffer>;
}

/** Throws an Error with the name of the file, if it is no PLY file. */
export function readPly(bytes: Uint8Array<ArrayBuffer>, name: string): Ply {
  try {
    return read(bytes);
  } catch (error) {
    throw new Error(`${name}: ${(error as Error).message}`, {cause: error});
  }
}

function read(bytes: Uint8Array<ArrayBuffer>): Ply {
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, kMostHeader)), end = /\nend_header\r?\n/.exec(start);
  if (!/^ply\r?\n/.test(start) || end === null) throw new Error("this is no PLY file");
  const lines = start.slice(0, end.index).split("\n").map(line => line.trim().split(/\s+/));
  const format = lines.find(([word]) => word === "format")?.[1], data = bytes.subarray(end.index + end[0].length);
  const next = format === "ascii" ? nextOfText(data) : nextOfBytes(data, format === "binary_little_endian");
  const tables = elementsOf(lines).map(element => [element.name, tableOf(element, next)] as const);
  const table = (name: string) => tables.find(([of]) => of === name)?.[1] ?? noTable;
  return fansOf(table("vertex"), table("face"));
}

const kMostHeader = 65536;

interface Property {
  readonly name: string;
  readonly type: string;
  /** Of a list: the type of its length. */
  readonly count: string | undefined;
}
interface Element {
  readonly name: string;
  readonly count: number;
  readonly properties: readonly Property[];
}
/** Takes the next number, of this type. */
type Next = (type: string) => number;
/** Of an element the values of each property that has one, and the lists of each that has lists. */
interface Table {
  readonly values: ReadonlyMap<string, Float64Array>;
  readonly lists: ReadonlyMap<string, readonly (readonly number[])[]>;
  readonly properties: readonly Property[];
}
const noTable: Table = {values: new Map(), lists: new Map(), properties: []};

function elementsOf(lines: readonly string[][]): Element[] {
  const elements: {name: string; count: number; properties: Property[]}[] = [];
  for (const [word, ...words] of lines) {
    if (word === "element") elements.push({name: words[0]!, count: Number(words[1]), properties: []});
    if (word !== "property") continue;
    const isList = words[0] === "list", [type, name] = words.slice(isList ? 2 : 0);
    elements.at(-1)?.properties.push({name: name!, type: type!, count: isList ? words[1] : undefined});
  }
  return elements;
}

function tableOf({count, properties}: Element, next: Next): Table {
  const values = new Map<string, Float64Array>(), lists = new Map<string, number[][]>();
  for (const {name, count: length} of properties) {
    if (length === undefined) values.set(name, new Float64Array(count));
    else lists.set(name, []);
  }
  for (let i = 0; i < count; ++i) {
    for (const {name, type, count: length} of properties) {
      if (length === undefined) values.get(name)![i] = next(type);
      else lists.get(name)!.push(Array.from({length: next(length)}, () => next(type)));
    }
  }
  return {values, lists, properties};
}

function fansOf(vertices: Table, faces: Table): Ply {
  const loops = faces.lists.get("vertex_indices") ?? faces.lists.get("vertex_index") ?? [];
  const triangles = loops.reduce((sum, {length}) => sum + Math.max(0, length - 2), 0);
  const places = ["x", "y", "z"].map(name => vertices.values.get(name) ?? new Float64Array());
  const colourOfVertex = colourIn(vertices), colourOfFace = colourIn(faces);
  const corners = new Float32Array(9 * triangles), colours = new Uint8Array(12 * triangles), numbers = new Uint32Array(triangles);
  let number = -1, at = 0;
  loops.forEach((loop, face) => {
    if (loop.length >= 3) ++number;
    for (let k = 1; k + 1 < loop.length; ++k) {
      numbers[at / 3] = number;
      for (const vertex of [loop[0]!, loop[k]!, loop[k + 1]!]) {
        if (vertex >= places[2]!.length) throw new Error(`a face has vertex ${vertex}, which is not there`);
        corners.set(places.map(values => values[vertex]!), 3 * at);
        colours.set([...(colourOfVertex?.(vertex) ?? colourOfFace?.(face) ?? kGrey), 255], 4 * at);
        ++at;
      }
    }
  });
  return {corners, colours, isColoured: (colourOfVertex ?? colourOfFace) !== undefined, faces: numbers};
}

const kGrey = [200, 200, 200];

/** Where an element has colours: that of its i-th thing, from 0 to 255. */
function colourIn({values, properties}: Table): ((i: number) => number[]) | undefined {
  const parts = ["red", "green", "blue"].map(name => values.get(name));
  if (parts.includes(undefined)) return undefined;
  const {type} = properties.find(({name}) => name === "red")!;
  const share = /^(float|double)/.test(type) ? 255 : /^(u?short|u?int16)$/.test(type) ? 1 / 257 : 1;
  return i => parts.map(part => Math.round(share * part![i]!));
}

function nextOfText(data: Uint8Array): Next {
  const words = new TextDecoder("latin1").decode(data).split(/\s+/).filter(word => word !== "");
  let at = 0;
  return () => {
    if (at === words.length) throw new Error("the file ends early");
    return Number(words[at++]);
  };
}

function nextOfBytes(data: Uint8Array<ArrayBuffer>, isLittle: boolean): Next {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  let at = 0;
  return type => {
    const kind = kinds.get(type);
    if (kind === undefined) throw new Error(`there is no type ${type}`);
    const [size, get] = kind;
    if (at + size > view.byteLength) throw new Error("the file ends early");
    at += size;
    return get(view, at - size, isLittle);
  };
}

type Get = (view: DataView, at: number, isLittle: boolean) => number;
const kinds = new Map<string, readonly [number, Get]>(
  ([
    ["char int8", 1, (view, at) => view.getInt8(at)],
    ["uchar uint8", 1, (view, at) => view.getUint8(at)],
    ["short int16", 2, (view, at, isLittle) => view.getInt16(at, isLittle)],
    ["ushort uint16", 2, (view, at, isLittle) => view.getUint16(at, isLittle)],
    ["int int32", 4, (view, at, isLittle) => view.getInt32(at, isLittle)],
    ["uint uint32", 4, (view, at, isLittle) => view.getUint32(at, isLittle)],
    ["float float32", 4, (view, at, isLittle) => view.getFloat32(at, isLittle)],
    ["double float64", 8, (view, at, isLittle) => view.getFloat64(at, isLittle)],
  ] as [string, number, Get][]).flatMap(([names, size, get]) => names.split(" ").map(name => [name, [size, get]] as const)),
);
