// SPDX-License-Identifier: MIT
// Where the module comes from, and what it asks of its surroundings.
import {Library, type Exports} from "./library.mjs";

/** The bytes of occlude.wasm, the module compiled, or where it lies. */
export type Source = BufferSource | WebAssembly.Module | URL | string;

/** Compiles and starts the module, from beside this file unless a source is given. */
export async function loadLibrary(source: Source = new URL("occlude.wasm", import.meta.url)): Promise<Library> {
  const code = typeof source === "string" || source instanceof URL ? await bytesAt(source) : source;
  let library: Library;
  const memory = () => new DataView((instance.exports as unknown as Exports).memory.buffer);
  const surroundings = {
    // Whatever has a view of the memory asks for it anew.
    env: {emscripten_notify_memory_growth: () => {}},
    occlude: {later: (context: number, task: number, work: number) => library.leave(context, task, work)},
    wasi_snapshot_preview1: {
      clock_time_get: (_clock: number, _precision: bigint, place: number) => {
        memory().setBigUint64(place >>> 0, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      proc_exit: (code: number) => {
        throw new Error(`the module has given up (${code})`);
      },
    },
  };
  const module = code instanceof WebAssembly.Module ? code : await WebAssembly.compile(code);
  const instance = await WebAssembly.instantiate(module, surroundings);
  library = new Library(instance.exports as unknown as Exports);
  return library;
}

async function bytesAt(place: URL | string): Promise<BufferSource> {
  if (String(place).startsWith("file:")) {
    // @ts-expect-error nothing else needs the types of Node
    const {readFile} = await import("node:fs/promises"); // fetch() of Node reads no files
    return readFile(new URL(place));
  }
  const answer = await fetch(place);
  if (!answer.ok) throw new Error(`${place}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}
