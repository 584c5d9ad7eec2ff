// SPDX-License-Identifier: MIT
// Structs of C in the memory of the module: the same members in the same order, with the values that the macros of occlude.h
// give them. test/layout.test.mjs has the compiler check each offset, size and value.

type Kind = "u32" | "i32" | "u64" | "f32" | "f64";
type Value = number | bigint | readonly number[];

interface Field {
  readonly kind: Kind;
  readonly initial: Value;
}

const bytesOf = {u32: 4, i32: 4, u64: 8, f32: 4, f64: 8} as const;
const countOf = (field: Field) => (typeof field.initial === "object" ? field.initial.length : 1);

const u32 = (initial = 0): Field => ({kind: "u32", initial});
const i32 = (initial = 0): Field => ({kind: "i32", initial});
const u64 = (initial = 0n): Field => ({kind: "u64", initial});
const f32 = (initial = 0): Field => ({kind: "f32", initial});
const f64 = (initial: number | readonly number[] = 0): Field => ({kind: "f64", initial});

/** What is written to a struct; everything else has its initial value. */
export type Values<Name extends string> = Partial<Record<Name, number | bigint | ArrayLike<number>>>;

export class Struct<Name extends string> {
  readonly offsets = new Map<Name, number>();
  readonly bytes: number;
  /** Whether it begins with its size, which is written by itself. */
  readonly #isSized: boolean;

  constructor(readonly name: string, readonly fields: Readonly<Record<Name, Field>>) {
    let end = 0;
    let alignment = 1;
    for (const [member, field] of this.#members()) {
      const each = bytesOf[field.kind];
      const start = Math.ceil(end / each) * each;
      this.offsets.set(member, start);
      end = start + each * countOf(field);
      alignment = Math.max(alignment, each);
    }
    this.bytes = Math.ceil(end / alignment) * alignment;
    this.#isSized = "size" in fields;
  }

  write(memory: DataView, at: number, values: Values<Name>): void {
    for (const [member, field] of this.#members()) {
      const value = member === "size" && this.#isSized ? this.bytes : (values[member] ?? field.initial);
      const place = at + this.offsets.get(member)!;
      if (typeof value !== "object") {
        write(memory, place, field.kind, value);
      } else {
        for (let i = 0; i < value.length; ++i) write(memory, place + i * bytesOf[field.kind], field.kind, value[i]!);
      }
    }
  }

  /** A member that is one number. A u64 beyond 2^53 is rounded. */
  read(memory: DataView, at: number, member: Name): number {
    const place = at + this.offsets.get(member)!;
    switch (this.fields[member].kind) {
      case "u32":
        return memory.getUint32(place, true);
      case "i32":
        return memory.getInt32(place, true);
      case "u64":
        return Number(memory.getBigUint64(place, true));
      case "f32":
        return memory.getFloat32(place, true);
      case "f64":
        return memory.getFloat64(place, true);
    }
  }

  /** The three numbers of a member that is a point. */
  readPoint(memory: DataView, at: number, member: Name): [number, number, number] {
    const place = at + this.offsets.get(member)!;
    return [0, 8, 16].map(offset => memory.getFloat64(place + offset, true)) as [number, number, number];
  }

  #members(): [Name, Field][] {
    return Object.entries(this.fields) as [Name, Field][];
  }
}

function write(memory: DataView, place: number, kind: Kind, value: number | bigint): void {
  switch (kind) {
    case "u32":
      return memory.setUint32(place, Number(value), true);
    case "i32":
      return memory.setInt32(place, Number(value), true);
    case "u64":
      return memory.setBigUint64(place, BigInt(value), true);
    case "f32":
      return memory.setFloat32(place, Number(value), true);
    case "f64":
      return memory.setFloat64(place, Number(value), true);
  }
}

const nothing3 = [0, 0, 0];
const nothing9 = [0, 0, 0, 0, 0, 0, 0, 0, 0];

export const structs = {
  points: new Struct("occlude_points", {data: u32(), count: u32(), stride: u32(), type: i32()}),
  boxes: new Struct("occlude_boxes", {data: u32(), count: u32(), stride: u32(), type: i32(), kind: i32()}),
  meshData: new Struct("occlude_mesh_data", {
    size: u32(),
    // occlude_points
    "vertices.data": u32(),
    "vertices.count": u32(),
    "vertices.stride": u32(),
    "vertices.type": i32(),
    indices: u32(),
    index_count: u32(),
    polygon_sizes: u32(),
    polygon_count: u32(),
    should_stop: u32(),
    context: u32(),
    executor: u32(),
    see_through: u32(),
  }),
  objectOptions: new Struct("occlude_object_options", {
    size: u32(),
    moves: i32(),
    is_always_drawn: i32(),
    mask: u32(0xffffffff),
    reserved: u32(),
  }),
  placement: new Struct("occlude_placement", {
    x: f64([1, 0, 0]),
    y: f64([0, 1, 0]),
    z: f64([0, 0, 1]),
    origin: f64(nothing3),
  }),
  occluderOptions: new Struct("occlude_occluder_options", {
    size: u32(),
    moves: i32(),
    is_one_sided: i32(),
    mask: u32(0xffffffff),
    weld: u32(),
    "object.number": u64(),
  }),
  matrixCamera: new Struct("occlude_matrix_camera", {
    size: u32(),
    matrix: u32(),
    type: i32(),
    order: i32(),
    depth: i32(),
    nearer: i32(),
    "eyes.radius": f64(),
    "eyes.half_edges": f64(nothing9),
  }),
  lookAtCamera: new Struct("occlude_look_at_camera", {
    size: u32(),
    eye: f64(nothing3),
    target: f64([1, 0, 0]),
    up: f64([0, 0, 1]),
    fov_y_deg: f64(60),
    height: f64(100),
    aspect: f64(16 / 9),
    near_plane: f64(0.1),
    far_plane: f64(),
    projection: i32(),
    reserved: i32(),
    "eyes.radius": f64(),
    "eyes.half_edges": f64(nothing9),
  }),
  aheadOptions: new Struct("occlude_ahead_options", {
    size: u32(),
    aside: f64(0.1),
    up: f64(0.05),
    turn_degrees: f64(),
  }),
  cullOptions: new Struct("occlude_cull_options", {
    size: u32(),
    executor: u32(),
    cover_width: i32(576),
    cover_height: i32(360),
    cover_work: u64(),
    cover_ms: f64(),
    margin: f64(),
    mask: u32(0xffffffff),
    least_size: f32(),
    is_front_to_back: i32(),
    is_to_be_held: i32(),
    is_adaptive: i32(1),
    reserved: i32(),
  }),
  frame: new Struct("occlude_frame", {
    size: u32(),
    count: u32(),
    objects: u32(),
    sizes: u32(),
    distances: u32(),
    planes: u32(),
    plane_count: u32(),
    idle_occluders: u32(),
    idle_occluder_count: u32(),
  }),
  statistics: new Struct("occlude_statistics", {
    size: u32(),
    drawn: u32(),
    out_of_view: u32(),
    hidden: u32(),
    too_small: u32(),
    occluders: u32(),
    nodes_visited: u32(),
    view_tests: u32(),
    cover_tests: u32(),
    cover_groups: u32(),
    cover_groups_left: u32(),
    cover_triangles: u32(),
    cover_work: u64(),
  }),
  hiding: new Struct("occlude_hiding", {"occluder.number": u64(), polygon: u32(), corner_count: u32(), corners: u32()}),
  fate: new Struct("occlude_fate", {reason: i32(), plane: u32(), by_count: u32(), by: u32()}),
  heldOptions: new Struct("occlude_held_options", {
    size: u32(),
    cull: u32(),
    way: u32(),
    later: u32(),
    context: u32(),
    is_repeatable: i32(),
    reserved: i32(),
  }),
  heldCounts: new Struct("occlude_held_counts", {size: u32(), frames: u32(), of_point: u32(), regions: u32(), late: u32()}),
  modelOptions: new Struct("occlude_model_options", {
    cover_width: i32(576),
    cover_height: i32(360),
    cover_work: u64(),
    cover_ms: f64(),
    margin: f64(),
    is_adaptive: i32(1),
    reserved: i32(),
  }),
  modelFrame: new Struct("occlude_model_frame", {
    drawn: u32(),
    drawn_count: u32(),
    culled: u32(),
    culled_count: u32(),
    planes: u32(),
    plane_count: u32(),
    drawn_polygons: u32(),
    out_of_view_polygons: u32(),
    hidden_polygons: u32(),
    unasked_polygons: u32(),
    nodes_visited: u32(),
    view_tests: u32(),
    cover_tests: u32(),
    cover_triangles: u32(),
    cover_work: u64(),
  }),
};
