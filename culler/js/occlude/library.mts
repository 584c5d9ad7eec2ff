// SPDX-License-Identifier: MIT
// One module of WebAssembly: its functions and its memory. Its memory may grow in any call, so nothing keeps a view of it
// over one: what goes in is written, and what comes out is copied, between calls.
import {OccludeError, errorOf} from "./errors.mjs";
import type {Struct, Values} from "./layout.mjs";

/** The functions of C. Pointers and sizes are numbers, ids are bigints. */
export type Exports = Readonly<Record<`occlude_${string}`, (...given: (number | bigint)[]) => number>> & {
  readonly memory: WebAssembly.Memory;
  malloc(bytes: number): number;
  free(place: number): void;
  _initialize(): void;
};

type Task = () => void;

/** Memory for the arguments and the results of one call. */
export interface Scratch {
  /** Room for so many bytes, aligned to 16. */
  room(bytes: number): number;
  struct<Name extends string>(struct: Struct<Name>, values?: Values<Name>): number;
  copyOf(numbers: ArrayBufferView): number;
}

/** Most calls need less than this of scratch memory; what does not fit is allocated. Options, cameras and frames: about 1 KiB. */
const scratchBytes = 65536;

export class Library implements Scratch {
  readonly #scratch: number;
  #used = 0;
  #overflow: number[] = [];
  #view: DataView;
  readonly #laters = new Map<number, (task: Task) => void>();
  #lastLater = 0;

  constructor(readonly c: Exports) {
    c._initialize();
    this.#view = new DataView(c.memory.buffer);
    this.#scratch = this.allocate(scratchBytes);
  }

  /** Throws for a status that is not 0. */
  check(status: number): void {
    if (status !== 0) throw errorOf(status, this.text(this.c.occlude_last_error!()));
  }

  /** The memory as it is now. */
  get memory(): DataView {
    if (this.#view.buffer !== this.c.memory.buffer) this.#view = new DataView(this.c.memory.buffer);
    return this.#view;
  }

  text(place: number): string {
    const bytes = new Uint8Array(this.c.memory.buffer, place >>> 0);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  allocate(bytes: number): number {
    const place = this.c.malloc(bytes) >>> 0;
    if (place === 0) throw new OccludeError("out_of_memory", "out of memory");
    return place;
  }

  /** Gives what `work` gives. The scratch memory that it took is free again afterwards. */
  using<T>(work: (scratch: Scratch) => T): T {
    const used = this.#used;
    const overflow = this.#overflow.length;
    try {
      return work(this);
    } finally {
      this.#used = used;
      for (const place of this.#overflow.splice(overflow)) this.c.free(place);
    }
  }

  room(bytes: number): number {
    const start = this.#used;
    if (start + bytes <= scratchBytes) {
      this.#used = Math.ceil((start + bytes) / 16) * 16;
      return this.#scratch + start;
    }
    const place = this.allocate(bytes);
    this.#overflow.push(place);
    return place;
  }

  struct<Name extends string>(struct: Struct<Name>, values: Values<Name> = {}): number {
    const place = this.room(struct.bytes);
    struct.write(this.memory, place, values);
    return place;
  }

  copyOf(numbers: ArrayBufferView): number {
    const place = this.room(numbers.byteLength);
    const from = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
    new Uint8Array(this.c.memory.buffer, place, numbers.byteLength).set(from);
    return place;
  }

  // Copies of arrays of C.

  words(place: number, count: number): Uint32Array<ArrayBuffer> {
    return new Uint32Array(this.#bytes(place, count, 4));
  }
  ids(place: number, count: number): BigUint64Array<ArrayBuffer> {
    return new BigUint64Array(this.#bytes(place, count, 8));
  }
  floats(place: number, count: number): Float32Array<ArrayBuffer> {
    return new Float32Array(this.#bytes(place, count, 4));
  }
  doubles(place: number, count: number): Float64Array<ArrayBuffer> {
    return new Float64Array(this.#bytes(place, count, 8));
  }

  #bytes(place: number, count: number, each: number): ArrayBuffer {
    return (this.c.memory.buffer as ArrayBuffer).slice(place, place + count * each);
  }

  /** Keeps a function that tasks of held culls are given to; its number is their context. Zero is none. */
  addLater(later: (task: Task) => void): number {
    this.#laters.set(++this.#lastLater, later);
    return this.#lastLater;
  }
  removeLater(context: number): void {
    this.#laters.delete(context);
  }

  /** What C calls with a task. It must not throw through C: what `later` throws is thrown where nothing of C waits. */
  readonly leave = (context: number, task: number, work: number): void => {
    const run = once(() => this.c.occlude_js_run!(task, work));
    try {
      this.#laters.get(context)!(run);
    } catch (error) {
      queueMicrotask(() => {
        throw error;
      });
      run();
    }
  };
}

/** A task of C may be called once. */
function once(task: Task): Task {
  let left: Task | undefined = task;
  return () => {
    const now = left;
    left = undefined;
    now?.();
  };
}
