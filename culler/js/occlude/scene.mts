// SPDX-License-Identifier: MIT
import {cameraOf, type Camera} from "./cameras.mjs";
import {refuse} from "./errors.mjs";
import {cullOptionsOf, flag, frameOf, type CullOptions, type SceneFrame} from "./frames.mjs";
import {idsOf, numberOf, type Ids, type ObjectId, type ObjectIds, type OccluderId, type OccluderIds} from "./ids.mjs";
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import type {OccluderMesh} from "./mesh.mjs";
import {boxesOf, countOfBoxes, fixed, type Boxes, type Numbers} from "./numbers.mjs";
import {Disposable} from "./resource.mjs";
import {asked, type View} from "./view.mjs";

export interface ObjectOptions {
  /** Whether it is moved often: those that are cost time in each update, the others only when they are moved. */
  readonly moves?: boolean;
  /** Whether it is in every frame whose mask it has, wherever it is. */
  readonly alwaysDrawn?: boolean;
  /** Layers: CullOptions.mask. Default: all. */
  readonly mask?: number;
}

export interface OccluderOptions {
  readonly moves?: boolean;
  /** Whether it hides only with the polygons that look counter-clockwise from the eye. */
  readonly oneSided?: boolean;
  readonly mask?: number;
  /** Occluders with the same number, not 0, and all other options the same hide as one mesh does. */
  readonly weld?: number;
  /** The object that draws it, if any: it hides nothing in frames without that object. */
  readonly object?: ObjectId;
}

/** A 4x4 matrix that places a mesh: 16 numbers, column after column, as the `elements` of a Matrix4 of three.js. */
export type Placement = ArrayLike<number>;

/** What became of an object in a frame. */
export type Reason = "drawn" | "always_drawn" | "out_of_view" | "hidden" | "too_small" | "in_no_layer" | "not_in_scene";
const reasons: readonly Reason[] =
  ["drawn", "always_drawn", "out_of_view", "hidden", "too_small", "in_no_layer", "not_in_scene"];

/** A polygon that hides: its number in the mesh of the occluder, and its corners in the scene, three numbers each. */
export interface Hiding {
  readonly occluder: OccluderId;
  readonly polygon: number;
  readonly corners: Float64Array<ArrayBuffer>;
}

/** What became of an object in a frame, and why. */
export interface Fate {
  readonly reason: Reason;
  /** Out of view: beyond this one of SceneFrame.planes. */
  readonly plane?: number;
  /** Hidden: by these polygons together, each once. */
  readonly by?: Hiding[];
}

/** Objects with boxes, and occluders that need not be what is drawn. Changes show at the next update(). */
export class Scene extends Disposable {
  /** @internal */
  constructor(library: Library) {
    super(library, (_, place) => library.c.occlude_scene_create!(place), "occlude_scene_destroy");
  }

  // ---- Objects ----

  /** The box has six numbers, or twelve if it is oriented. */
  addObject(box: Boxes, options: ObjectOptions = {}): ObjectId {
    const count = countOfBoxes(box);
    return count === 1 ? this.addObjects(box, options)[0]! : refuse(`${count} boxes where one is needed`);
  }

  /** An object for each box. Objects that are near each other are best added together. */
  addObjects(boxes: Boxes, options: ObjectOptions = {}): ObjectIds {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const {place, count} = boxesOf(scratch, boxes);
      const ids = scratch.room(8 * count);
      library.check(library.c.occlude_scene_add_objects!(pointer, place, objectOptionsOf(scratch, options), ids));
      return library.ids(ids, count) as ObjectIds;
    });
  }

  moveObjects(ids: Ids<ObjectId>, boxes: Boxes): void {
    const {library, pointer} = this.resource;
    library.using(scratch => {
      const {place, count} = boxesOf(scratch, boxes);
      if (count !== ids.length) refuse(`${count} boxes of ${ids.length} objects`);
      library.check(library.c.occlude_scene_move_objects!(pointer, idsOf(scratch, ids), place));
    });
  }

  /** All of them are in the scene, else nothing is removed. */
  removeObjects(ids: Ids<ObjectId>): void {
    const {library, pointer} = this.resource;
    library.using(scratch => {
      library.check(library.c.occlude_scene_remove_objects!(pointer, idsOf(scratch, ids), ids.length));
    });
  }

  enableObjects(ids: Ids<ObjectId>, isEnabled: boolean): void {
    this.#change("object", ids, "enable", isEnabled ? 1 : 0);
  }
  maskObjects(ids: Ids<ObjectId>, mask: number): void {
    this.#change("object", ids, "mask", mask);
  }
  hasObject(id: ObjectId): boolean {
    return this.#has("object", id);
  }

  // ---- Occluders ----

  /** Every point of an occluder must be on or inside something opaque that is drawn unless this scene hides it. */
  addOccluder(mesh: OccluderMesh, placement?: Placement, options: OccluderOptions = {}): OccluderId {
    return this.addOccluders(mesh, placement === undefined ? identity : fixed(placement, 16, "placement"), options)[0]!;
  }

  /** An occluder of this mesh for each matrix: 16 numbers each, such as those of an InstancedMesh of three.js. */
  addOccluders(mesh: OccluderMesh, placements: Numbers, options: OccluderOptions = {}): OccluderIds {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const {place, count} = placementsOf(scratch, placements);
      const ids = scratch.room(8 * count);
      const how = occluderOptionsOf(scratch, options);
      library.check(library.c.occlude_scene_add_occluders!(pointer, mesh.pointerFor(library), place, count, how, ids));
      return library.ids(ids, count) as OccluderIds;
    });
  }

  moveOccluders(ids: Ids<OccluderId>, placements: Numbers): void {
    const {library, pointer} = this.resource;
    library.using(scratch => {
      const {place, count} = placementsOf(scratch, placements);
      if (count !== ids.length) refuse(`${count} placements of ${ids.length} occluders`);
      this.#require("occluder", ids, "move", place);
      ids.forEach((id, i) => {
        library.check(library.c.occlude_scene_move_occluder!(pointer, numberOf(id), place + i * structs.placement.bytes));
      });
    });
  }

  /** All of them are in the scene, else nothing is removed. */
  removeOccluders(ids: Ids<OccluderId>): void {
    this.#change("occluder", new Set(ids), "remove");
  }

  /** Gives it another mesh. */
  replaceOccluder(id: OccluderId, mesh: OccluderMesh): void {
    const {library, pointer} = this.resource;
    library.check(library.c.occlude_scene_replace_occluder!(pointer, numberOf(id), mesh.pointerFor(library)));
  }

  enableOccluders(ids: Ids<OccluderId>, isEnabled: boolean): void {
    this.#change("occluder", ids, "enable", isEnabled ? 1 : 0);
  }
  maskOccluders(ids: Ids<OccluderId>, mask: number): void {
    this.#change("occluder", ids, "mask", mask);
  }
  hasOccluder(id: OccluderId): boolean {
    return this.#has("occluder", id);
  }

  // ---- Frames ----

  /** Makes all changes since the last update. */
  update(): void {
    const {library, pointer} = this.resource;
    library.check(library.c.occlude_scene_update!(pointer));
  }

  /** What to draw, for the next frame of the view. What is refused leaves the view its last frame. */
  cull(camera: Camera, view: View, options: CullOptions = {}): SceneFrame {
    const {library, pointer} = this.resource;
    const of = view.pointerFor(library);
    library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      library.check(library.c[`occlude_scene_cull${suffix}`]!(pointer, place, cullOptionsOf(scratch, options), of));
    });
    return frameOf(library, "occlude_view", of);
  }

  /** Whether frames of this camera can be held against the last frame of `held`: see occlude_scene_holds in occlude.h. */
  holds(held: View, camera: Camera, options: CullOptions = {}): boolean {
    const {library, pointer} = this.resource;
    const of = held.pointerFor(library);
    return library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      const how = cullOptionsOf(scratch, options);
      return asked(library, holds => library.c[`occlude_scene_holds${suffix}`]!(pointer, of, place, how, holds));
    });
  }

  /** The next frame of `view`, in which what hid in the last frame of `held` hides. Refused unless holds(). */
  cullHeld(camera: Camera, held: View, view: View, options: CullOptions = {}): SceneFrame {
    const {library, pointer} = this.resource;
    const against = held.pointerFor(library);
    const of = view.pointerFor(library);
    library.using(scratch => {
      const {place, suffix} = cameraOf(scratch, camera);
      const how = cullOptionsOf(scratch, options);
      library.check(library.c[`occlude_scene_cull_held${suffix}`]!(pointer, place, how, against, of));
    });
    return frameOf(library, "occlude_view", of);
  }

  /**
   * What became of these objects in the last frame of the view. Refused before the first frame, if it is of another scene or
   * was held, and if the scene was updated since. Takes the time of some frames.
   */
  why(ids: Ids<ObjectId>, view: View): Fate[] {
    const {library, pointer} = this.resource;
    const of = view.pointerFor(library);
    return library.using(scratch => {
      const fates = scratch.room(ids.length * structs.fate.bytes);
      library.check(library.c.occlude_scene_why!(pointer, of, idsOf(scratch, ids), ids.length, fates));
      return Array.from(ids, (_, i) => fateAt(library, fates + i * structs.fate.bytes));
    });
  }

  /** What is in the scene, disabled ones included. */
  get objects(): number {
    return this.#count("occlude_scene_objects");
  }
  get occluders(): number {
    return this.#count("occlude_scene_occluders");
  }
  /** Bytes of memory held for objects. */
  get objectBytes(): number {
    return this.#count("occlude_scene_object_bytes");
  }

  #count(name: `occlude_scene_${string}`): number {
    const {library, pointer} = this.resource;
    return library.c[name]!(pointer) >>> 0;
  }
  #has(kind: "object" | "occluder", id: bigint): boolean {
    const {library, pointer} = this.resource;
    return library.c[`occlude_scene_has_${kind}`]!(pointer, numberOf(id)) !== 0;
  }

  /** Does this with each of them, or with none if one names nothing. */
  #change(kind: "object" | "occluder", ids: Iterable<bigint>, what: string, ...given: number[]): void {
    const {library, pointer} = this.resource;
    this.#require(kind, ids, what, ...given);
    for (const id of ids) library.check(library.c[`occlude_scene_${what}_${kind}`]!(pointer, id, ...given));
  }
  /** What C says of one that names nothing, it throws. */
  #require(kind: "object" | "occluder", ids: Iterable<bigint>, what: string, ...given: number[]): void {
    const {library, pointer} = this.resource;
    for (const id of ids) {
      if (!this.#has(kind, id)) library.check(library.c[`occlude_scene_${what}_${kind}`]!(pointer, id, ...given));
    }
  }
}

const objectOptionsOf = (scratch: Scratch, options: ObjectOptions): number =>
  scratch.struct(structs.objectOptions, {
    moves: flag(options.moves),
    is_always_drawn: flag(options.alwaysDrawn),
    mask: options.mask,
  });

const occluderOptionsOf = (scratch: Scratch, options: OccluderOptions): number =>
  scratch.struct(structs.occluderOptions, {
    moves: flag(options.moves),
    is_one_sided: flag(options.oneSided),
    mask: options.mask,
    weld: options.weld,
    "object.number": options.object,
  });

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** occlude_placements of matrices, whose last row is 0, 0, 0, 1. */
function placementsOf(scratch: Scratch, matrices: Numbers) {
  if (matrices.length % 16 !== 0) refuse(`placements: ${matrices.length} numbers are no multiple of 16`);
  const count = matrices.length / 16;
  const columns = new Float64Array(12 * count);
  for (let i = 0; i < count; ++i) {
    for (let column = 0; column < 4; ++column) {
      for (let row = 0; row < 3; ++row) columns[12 * i + 3 * column + row] = matrices[16 * i + 4 * column + row]!;
      if (matrices[16 * i + 4 * column + 3] !== identity[4 * column + 3]) {
        refuse(`placement ${i}: the last row of the matrix is not 0, 0, 0, 1`);
      }
    }
  }
  return {place: scratch.copyOf(columns), count};
}

function fateAt(library: Library, at: number): Fate {
  const {memory} = library;
  const of = (member: keyof typeof structs.fate.fields) => structs.fate.read(memory, at, member);
  const reason = reasons[of("reason")]!;
  if (reason === "out_of_view") return {reason, plane: of("plane")};
  if (reason !== "hidden") return {reason};
  const by = Array.from({length: of("by_count")}, (_, i) => hidingAt(library, of("by") + i * structs.hiding.bytes));
  return {reason, by};
}

function hidingAt(library: Library, at: number): Hiding {
  const of = (member: keyof typeof structs.hiding.fields) => structs.hiding.read(library.memory, at, member);
  return {
    occluder: library.ids(at + structs.hiding.offsets.get("occluder.number")!, 1)[0]! as OccluderId,
    polygon: of("polygon"),
    corners: library.doubles(of("corners"), 3 * of("corner_count")),
  };
}
