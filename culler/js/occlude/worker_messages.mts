// SPDX-License-Identifier: MIT
// What the two threads of a WorkerScene tell each other.
import type {Boxes, ErrorCode, HeldCullOptions, LookAtCamera, Numbers, ObjectOptions, OccluderOptions, Polygons} from "./occlude.mjs";

/** Something that is done to the scene. Things are named by numbers that the drawing thread gives. */
export type Edit =
  | {readonly what: "addObjects"; readonly ids: readonly number[]; readonly boxes: Boxes; readonly options: ObjectOptions}
  | {readonly what: "moveObjects"; readonly ids: readonly number[]; readonly boxes: Boxes}
  | {readonly what: "removeObjects"; readonly ids: readonly number[]}
  | {readonly what: "enableObjects"; readonly ids: readonly number[]; readonly isEnabled: boolean}
  | {readonly what: "maskObjects"; readonly ids: readonly number[]; readonly mask: number}
  | {readonly what: "addMesh"; readonly id: number; readonly polygons: Polygons}
  | {
      readonly what: "addOccluders";
      readonly ids: readonly number[];
      readonly mesh: number;
      readonly placements: Numbers;
      readonly options: Omit<OccluderOptions, "object">;
      readonly object: number | undefined;
    }
  | {readonly what: "moveOccluders"; readonly ids: readonly number[]; readonly placements: Numbers}
  | {readonly what: "removeOccluders"; readonly ids: readonly number[]}
  | {readonly what: "enableOccluders"; readonly ids: readonly number[]; readonly isEnabled: boolean};

/** The first message. */
export interface Start {
  readonly source: ArrayBufferLike | ArrayBufferView | WebAssembly.Module | string | undefined;
}

/** Edits since the last question, and the region for which to cull. */
export interface Question {
  readonly edits: readonly Edit[];
  readonly camera: LookAtCamera;
  readonly options: HeldCullOptions;
}

/** What is drawn of a region, and the box of all that is there. The objects are transferred. */
export interface Answer {
  readonly objects: Uint32Array<ArrayBuffer>;
  readonly bounds: readonly number[];
}

/** A start or a question that was refused. */
export interface Refusal {
  readonly code: ErrorCode;
  readonly message: string;
}

export type Reply = "started" | Answer | Refusal;
