// SPDX-License-Identifier: MIT
import {OccludeError} from "./errors.mjs";
import type {Library, Scratch} from "./library.mjs";

/** Something of C that is destroyed when its last user has let go of it. */
export class Resource {
  #users = 1;

  constructor(readonly library: Library, readonly pointer: number, readonly destroy: () => void) {}

  keep(): void {
    ++this.#users;
  }
  release(): void {
    if (--this.#users === 0) this.destroy();
  }
}

// What was not disposed of is released some time after nothing refers to it any more.
const net = new FinalizationRegistry<Resource>(resource => resource.release());

/** What has memory in the module, until it is disposed of. */
export class Disposable {
  #resource: Resource | undefined;

  static {
    // Where the language has it: `using view = new occlude.View()`.
    if (typeof Symbol.dispose === "symbol") this.prototype[Symbol.dispose] = this.prototype.dispose;
  }

  /** @internal `forget` is called once it is destroyed, or if it cannot be made. */
  constructor(library: Library, create: (scratch: Scratch, place: number) => number, destroy: `occlude_${string}`,
              forget: () => void = () => {}) {
    let pointer: number;
    try {
      pointer = library.using(scratch => {
        const place = scratch.room(4);
        library.check(create(scratch, place));
        return library.memory.getUint32(place, true);
      });
    } catch (error) {
      forget();
      throw error;
    }
    this.#resource = new Resource(library, pointer, () => {
      library.c[destroy]!(pointer);
      forget();
    });
    net.register(this, this.#resource, this);
  }

  /** @internal */
  get resource(): Resource {
    if (this.#resource === undefined) throw new OccludeError("disposed", `the ${this.constructor.name} was disposed of`);
    return this.#resource;
  }

  /** @internal What C calls it. Refused is one of another module. */
  pointerFor(library: Library): number {
    const {resource} = this;
    if (resource.library === library) return resource.pointer;
    throw new OccludeError("invalid_argument", `the ${this.constructor.name} is of another module`);
  }

  /** Frees its memory at once. Everything but another dispose() throws afterwards. */
  dispose(): void {
    if (this.#resource === undefined) return;
    net.unregister(this);
    this.#resource.release();
    this.#resource = undefined;
  }
}

export interface Disposable {
  [Symbol.dispose](): void;
}
