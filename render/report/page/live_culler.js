// SPDX-License-Identifier: MIT
// The real culler, in this page: the module that render/live/live.cpp becomes.

/** What the module asks of its surroundings: little more than the time. */
const surroundings = memory => ({
  env: {emscripten_notify_memory_growth: () => {}},
  wasi_snapshot_preview1: {
    clock_time_get: (clock, precision, place) => {
      new DataView(memory().buffer).setBigUint64(place >>> 0, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    proc_exit: code => {
      throw new Error(`the culler has given up (${code})`);
    },
  },
});

class LiveCuller {
  /** Prepares the model, for which `code` and `packedModel` are bytes. */
  static async open(code, packedModel, lens, leafSize) {
    let culler;
    const {instance} = await WebAssembly.instantiate(code, surroundings(() => culler.module.memory));
    culler = new LiveCuller(instance.exports);
    culler.prepare(packedModel, lens, leafSize);
    return culler;
  }

  constructor(module) {
    this.module = module;
    module._initialize();
  }

  prepare(packedModel, lens, leafSize) {
    const {module} = this;
    const room = module.occlude_input(packedModel.length) >>> 0;
    new Uint8Array(module.memory.buffer, room, packedModel.length).set(packedModel);
    this.require(module.occlude_open(leafSize));
    module.occlude_lens(lens.projection !== 'orthographic', lens.fov_y_deg, lens.height, lens.near, lens.far ?? Infinity, ...lens.up);
    const corner = isFar => [0, 1, 2].map(axis => module.occlude_grid_corner(isFar, axis));
    const parts = Object.fromEntries(['vertices', 'leaves', 'sides', 'corners', 'numbers'].map((name, i) => {
      module.occlude_model(i);
      return [name, this.output()];
    }));
    this.model = new Model({low: corner(false), step: module.occlude_grid_step(), steps: corner(true)}, parts);
  }

  /** Culls the next frame; returns its milliseconds. `options` has method, occluders, budget (ms), margin (of the height). */
  cull(eye, target, aspect, {method, occluders, budget, margin}) {
    const start = performance.now();
    const isDone = this.module.occlude_cull(...eye, ...target, aspect, method === 'cover', occluders, budget, margin);
    const ms = performance.now() - start;
    this.require(isDone);
    return ms;
  }

  /** The frame that was culled last, as Frames has it, and how many polygons became what. */
  frame() {
    this.module.occlude_frame(true);
    const outlines = this.outlines(new Numbers(this.output()));
    this.module.occlude_frame(false);
    const frame = new Frames({outlines}, this.output(), this.model.leaves).at(0);
    const drawn = this.module.occlude_drawn(), inView = this.module.occlude_in_view();
    return {...frame, counts: {drawn, culled: inView - drawn, outOfView: this.model.polygons - inView}};
  }

  // The rest is how.

  outlines(numbers) {
    const list = of => Array.from({length: numbers.next()}, of);
    return list(() => {
      const points = list(() => this.model.point([numbers.next(), numbers.next(), numbers.next()]));
      return {points, polygons: list(() => numbers.next())};
    });
  }
  output() {
    const start = this.module.occlude_output() >>> 0;
    return new Uint8Array(this.module.memory.buffer.slice(start, start + this.module.occlude_output_size()));
  }
  require(isDone) {
    if (!isDone) throw new Error(new TextDecoder().decode(this.output()));
  }
}
