// SPDX-License-Identifier: MIT
// Scenes that are culled in a worker: the thread that draws pays for the arrival of answers alone.
//
//   import {startWorker} from "occlude/worker";
//   const scene = await startWorker();
import {
  load, OccludeError, type Boxes, type Camera, type HeldCullOptions, type LookAtCamera, type Numbers, type ObjectOptions,
  type Occlude, type OccluderOptions, type Point, type Polygons, type Scene, type View,
} from "./occlude.mjs";
import type {Answer, Edit, Question, Reply, Start} from "./worker_messages.mjs";

declare const named: unique symbol;

/** Name one object, or one occluder, of a WorkerScene: small numbers, for arrays of your own. Those of removed ones are given anew. */
export type WorkerObject = number & {readonly [named]: "object"};
export type WorkerOccluder = number & {readonly [named]: "occluder"};
/** Names one mesh, for good. */
export type WorkerMesh = number & {readonly [named]: "mesh"};

/** As OccluderOptions. */
export interface WorkerOccluderOptions extends Omit<OccluderOptions, "object"> {
  readonly object?: WorkerObject;
}

export interface WorkerOptions {
  /** As of load(). */
  readonly source?: Start["source"];
  /** To a thread that has called serve() of occlude/worker-thread. Default: a worker is started. */
  readonly port?: MessagePort;
  /** Of all culls. */
  readonly cull?: HeldCullOptions;
}

/** What to draw. */
export interface WorkerFrame {
  /** The objects to draw, each once, in no order. */
  readonly objects: Uint32Array<ArrayBuffer>;
  /** Whether no answer holds, so that all objects are drawn: after a jump, and before the first answer. */
  readonly isUnasked: boolean;
}

/** Starts a worker with a scene. */
export async function startWorker(options: WorkerOptions = {}): Promise<WorkerScene> {
  const occlude = await load(options.source as BufferSource | string | undefined);
  const {port, stop} = options.port ? {port: options.port, stop: () => options.port!.close()} : await startThread();
  const started = new Promise<Reply>(resolve => (port.onmessage = ({data}) => resolve(data)));
  port.postMessage({source: options.source} satisfies Start);
  const reply = await started;
  if (reply !== "started") throw errorOf(reply as {code: "failed"; message: string});
  return new WorkerScene(occlude, port, stop, options.cull ?? {});
}

const errorOf = ({code, message}: {code: OccludeError["code"]; message: string}) => new OccludeError(code, message);

async function startThread(): Promise<{port: MessagePort; stop: () => void}> {
  const {port1: port, port2: other} = new MessageChannel();
  const place = new URL("worker-main.mjs", import.meta.url);
  if (typeof Worker === "function") {
    const worker = new Worker(place, {type: "module"});
    worker.postMessage(other, [other]);
    return {port, stop: () => worker.terminate()};
  }
  // @ts-expect-error nothing else needs the types of Node
  const threads = await import("node:worker_threads");
  const worker = new threads.Worker(place);
  worker.postMessage(other, [other]);
  return {port, stop: () => (port.close(), void worker.terminate())};
}

/** An answer that is there: the number of the last edit that it knows of, and where it holds. */
interface Kept {
  readonly known: number;
  readonly view: View;
  readonly objects: Uint32Array<ArrayBuffer>;
}

interface Thing {
  isEnabled: boolean;
  mask: number;
  /** Whether it draws an occluder that stands still. */
  draws: boolean;
}

/** How long a region is asked for beyond the time that answers take, in seconds. */
const ahead = 0.5;
/** The longest. */
const most = 3;
/** By how much the camera may turn while an answer holds, at least and at most, in degrees. */
const leastTurn = 2, mostTurn = 45;

const lengthOf = (a: Point) => Math.hypot(a[0]!, a[1]!, a[2]!);
const minus = (a: Point, b: Point) => [0, 1, 2].map(i => a[i]! - b[i]!);
/** Of the caller's, who may change it. */
const copyOf = (numbers: Numbers): Numbers => (numbers instanceof Float32Array ? numbers.slice() : Float64Array.from(numbers));
const copyOfBoxes = (boxes: Boxes): Boxes => ("oriented" in boxes ? {oriented: copyOf(boxes.oriented)} : copyOf(boxes));

/**
 * As Scene, but for one camera, and culled in a worker for regions ahead of the camera: an answer is used while it holds.
 * - No frame is wrong, however late answers are. What has been added or changed since an answer was asked for is drawn. An answer
 *   is used no more once something that hid in it has been moved, disabled or removed, or disabled with the object that draws it.
 * - Occluders that move hide nothing.
 * - What a frame costs does not depend on how much there is, but for what has changed and while no answer holds.
 * - An edit that is refused makes the frames after it throw its error.
 */
export class WorkerScene {
  readonly #port: MessagePort;
  readonly #stop: () => void;
  readonly #options: HeldCullOptions;
  readonly #occlude: Occlude;
  /** As large as the scene of the worker, and nothing else: its views tell where answers hold. */
  readonly #extent: Scene;

  readonly #things = new Map<WorkerObject, Thing>();
  readonly #occluders = new Set<WorkerOccluder>();
  readonly #moving = new Set<WorkerOccluder>();
  readonly #free: {objects: WorkerObject[]; occluders: WorkerOccluder[]} = {objects: [], occluders: []};
  #objectCount = 0;
  #occluderCount = 0;
  #meshCount = 0;

  /** Those that the worker was not told. */
  #edits: Edit[] = [];
  /** The numbers of the last edit, and of the last that takes away what hides. */
  #last = 0;
  #uncovered = 0;
  /** The last edit of each object that has changed since the oldest answer that is kept. */
  readonly #changed = new Map<WorkerObject, number>();

  /** The newest comes first. */
  #kept: Kept[] = [];
  /** A question that is put once the frame is over. */
  #asking: ReturnType<typeof setTimeout> | undefined;
  #asked: {readonly known: number; readonly camera: LookAtCamera; readonly at: number} | undefined;
  #lastAsked = -Infinity;
  #latency = 0;
  #before: {readonly eye: Point; readonly direction: Point; readonly seconds: number} | undefined;
  #velocity: Point = [0, 0, 0];
  #turning = 0;
  #failure: OccludeError | undefined;

  /** @internal */
  constructor(occlude: Occlude, port: MessagePort, stop: () => void, options: HeldCullOptions) {
    this.#occlude = occlude;
    this.#port = port;
    this.#stop = stop;
    this.#options = options;
    this.#extent = new occlude.Scene();
    port.onmessage = ({data}: {data: Answer | {code: "failed"; message: string}}) => {
      if ("code" in data) this.#failure = errorOf(data);
      else this.#take(data);
    };
  }

  // ---- Objects ----

  addObject(box: Boxes, options: ObjectOptions = {}): WorkerObject {
    return this.addObjects(box, options)[0]!;
  }
  addObjects(boxes: Boxes, options: ObjectOptions = {}): WorkerObject[] {
    const count = "oriented" in boxes ? boxes.oriented.length / 12 : boxes.length / 6;
    const ids = Array.from({length: count}, () => this.#free.objects.pop() ?? (this.#objectCount++ as WorkerObject));
    for (const id of ids) this.#things.set(id, {isEnabled: true, mask: options.mask ?? 0xffffffff, draws: false});
    this.#edit({what: "addObjects", ids, boxes: copyOfBoxes(boxes), options}, ids);
    return ids;
  }
  moveObjects(ids: readonly WorkerObject[], boxes: Boxes): void {
    this.#thingsOf(ids);
    this.#edit({what: "moveObjects", ids: [...ids], boxes: copyOfBoxes(boxes)}, ids);
  }
  removeObjects(ids: readonly WorkerObject[]): void {
    const draws = this.#thingsOf(ids).some(thing => thing.draws);
    this.#edit({what: "removeObjects", ids: [...ids]}, ids, draws);
    for (const id of ids) if (this.#things.delete(id)) this.#free.objects.push(id);
  }
  enableObjects(ids: readonly WorkerObject[], isEnabled: boolean): void {
    const things = this.#thingsOf(ids);
    for (const thing of things) thing.isEnabled = isEnabled;
    this.#edit({what: "enableObjects", ids: [...ids], isEnabled}, ids, things.some(thing => thing.draws));
  }
  maskObjects(ids: readonly WorkerObject[], mask: number): void {
    const things = this.#thingsOf(ids);
    for (const thing of things) thing.mask = mask;
    this.#edit({what: "maskObjects", ids: [...ids], mask}, ids, things.some(thing => thing.draws));
  }

  // ---- Occluders ----

  addMesh(polygons: Polygons): WorkerMesh {
    const id = this.#meshCount++ as WorkerMesh;
    const {vertices, ...rest} = polygons;
    this.#edit({what: "addMesh", id, polygons: {...structuredClone(rest), vertices: copyOf(vertices)}});
    return id;
  }
  /** An occluder of this mesh for each matrix. */
  addOccluders(mesh: WorkerMesh, placements: Numbers, {object, ...options}: WorkerOccluderOptions = {}): WorkerOccluder[] {
    if (object !== undefined) for (const thing of this.#thingsOf([object])) thing.draws ||= !options.moves;
    const next = () => this.#free.occluders.pop() ?? (this.#occluderCount++ as WorkerOccluder);
    const ids = Array.from({length: placements.length / 16}, next);
    for (const id of ids) {
      this.#occluders.add(id);
      if (options.moves) this.#moving.add(id);
    }
    this.#edit({what: "addOccluders", ids, mesh, placements: copyOf(placements), options, object});
    return ids;
  }
  moveOccluders(ids: readonly WorkerOccluder[], placements: Numbers): void {
    this.#uncover(ids, {what: "moveOccluders", ids: [...ids], placements: copyOf(placements)});
  }
  removeOccluders(ids: readonly WorkerOccluder[]): void {
    this.#uncover(ids, {what: "removeOccluders", ids: [...ids]});
    for (const id of ids) {
      this.#moving.delete(id);
      if (this.#occluders.delete(id)) this.#free.occluders.push(id);
    }
  }
  enableOccluders(ids: readonly WorkerOccluder[], isEnabled: boolean): void {
    this.#uncover(ids, {what: "enableOccluders", ids: [...ids], isEnabled});
  }

  // ---- Frames ----

  /** What to draw for the next frame, at this time: seconds by any clock, from which speeds are found. */
  cull(camera: Camera, seconds: number): WorkerFrame {
    if (this.#failure) throw this.#failure;
    this.#see(camera, seconds);
    const at = this.#kept.findIndex(({known, view}) => known >= this.#uncovered && view.holdsFor(camera));
    this.#keep(at < 0 ? this.#kept.slice(0, 1) : this.#kept.slice(0, at + 1));
    this.#askIfWorth(camera, seconds, at !== 0);
    return at < 0 ? {objects: this.#all(), isUnasked: true} : {objects: this.#drawnOf(this.#kept[at]!), isUnasked: false};
  }

  /** Ends the worker. */
  dispose(): void {
    this.#stop();
    clearTimeout(this.#asking);
    this.#keep([]);
    this.#extent.dispose();
    this.#failure = new OccludeError("disposed", "the WorkerScene was disposed of");
  }

  #thingsOf(ids: readonly WorkerObject[]): Thing[] {
    return ids.map(id => {
      const thing = this.#things.get(id);
      if (thing === undefined) throw new OccludeError("unknown_id", `there is no object ${id}`);
      return thing;
    });
  }

  #edit(edit: Edit, changed: readonly WorkerObject[] = [], isUncovering = false): void {
    this.#edits.push(edit);
    ++this.#last;
    for (const id of changed) this.#changed.set(id, this.#last);
    if (isUncovering) this.#uncovered = this.#last;
  }
  #uncover(ids: readonly WorkerOccluder[], edit: Edit): void {
    for (const id of ids) {
      if (!this.#occluders.has(id)) throw new OccludeError("unknown_id", `there is no occluder ${id}`);
    }
    this.#edit(edit, [], ids.some(id => !this.#moving.has(id)));
  }

  #isInLayer({isEnabled, mask}: Thing): boolean {
    return isEnabled && ((mask & (this.#options.mask ?? 0xffffffff)) >>> 0) !== 0;
  }
  #all(): Uint32Array<ArrayBuffer> {
    return Uint32Array.from([...this.#things].filter(([, thing]) => this.#isInLayer(thing)).map(([id]) => id));
  }
  #drawnOf({known, objects}: Kept): Uint32Array<ArrayBuffer> {
    const changed = new Set<number>();
    for (const [id, number] of this.#changed) if (number > known) changed.add(id);
    if (changed.size === 0) return objects;
    const drawn: number[] = [];
    for (const id of objects) if (!changed.has(id)) drawn.push(id);
    for (const id of changed) {
      const thing = this.#things.get(id as WorkerObject);
      if (thing && this.#isInLayer(thing)) drawn.push(id);
    }
    return Uint32Array.from(drawn);
  }

  /** Finds how the camera moves. */
  #see(camera: Camera, seconds: number): void {
    const {eye, target} = "matrix" in camera ? this.#occlude.ahead(camera, [0, 0, 0], 0) : camera;
    const now = {eye: Array.from(eye), direction: minus(target, eye), seconds}, before = this.#before;
    const time = before ? seconds - before.seconds : 0;
    if (before && time > 0) {
      this.#velocity = minus(now.eye, before.eye).map(x => x / time);
      const {direction: a} = before, {direction: b} = now;
      const cosine = (a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!) / (lengthOf(a) * lengthOf(b));
      this.#turning = (Math.acos(Math.min(1, cosine)) * 180) / Math.PI / time;
    }
    this.#before = now;
  }

  /** Lets go of all others, and of changes that none of these lacks. */
  #keep(kept: Kept[]): void {
    for (const each of this.#kept) if (!kept.includes(each)) each.view.dispose();
    this.#kept = kept;
    const oldest = Math.min(...kept.map(({known}) => known), this.#asked?.known ?? this.#last);
    for (const [id, number] of this.#changed) if (number <= oldest) this.#changed.delete(id);
  }

  #askIfWorth(camera: Camera, seconds: number, isNeeded: boolean): void {
    const isChanged = this.#last > (this.#kept[0]?.known ?? -1);
    const span = Math.min(most, ahead + 2 * this.#latency);
    const isOld = seconds - this.#lastAsked >= span / 4 || seconds < this.#lastAsked;
    if (this.#asking !== undefined || this.#asked !== undefined || !(isNeeded || isChanged || isOld)) return;
    const region = this.#regionOf(camera, span);
    // A worker that is woken may take the processor from the thread that draws.
    this.#asking = setTimeout(() => this.#ask(region));
    this.#lastAsked = seconds;
  }
  #regionOf(camera: Camera, span: number): LookAtCamera {
    const turnDegrees = Math.min(mostTurn, leastTurn + span * this.#turning);
    try {
      return this.#occlude.ahead(camera, this.#velocity, span, {turnDegrees});
    } catch {
      return this.#occlude.ahead(camera, [0, 0, 0], 0); // the picture would be too wide, or the way too long
    }
  }
  #ask(camera: LookAtCamera): void {
    this.#asking = undefined;
    const options = {...this.#options, margin: (this.#options.margin ?? 0) * stretchOf(camera)};
    this.#port.postMessage({edits: this.#edits, camera, options} satisfies Question);
    this.#edits = [];
    this.#asked = {known: this.#last, camera, at: performance.now()};
  }

  #take({objects, bounds}: Answer): void {
    const {known, camera, at} = this.#asked!;
    this.#asked = undefined;
    this.#latency = (performance.now() - at) / 1000;
    const view = new this.#occlude.View();
    const box = this.#extent.addObjects(bounds[0]! <= bounds[3]! ? bounds : []);
    this.#extent.update();
    this.#extent.cull(camera, view, {toBeHeld: true});
    this.#extent.removeObjects(box);
    this.#keep([{known, view, objects}, ...this.#kept.slice(0, 1)]);
  }
}

/** By how much more a move in the picture may be in the wider one of the region: see View::holds_for() in culler.h. */
function stretchOf({projection, fovY = 60, aspect = 16 / 9}: LookAtCamera): number {
  if (projection === "orthographic") return 1;
  const up = Math.tan((fovY * Math.PI) / 360);
  return 1 + up * up * (1 + aspect * aspect);
}
