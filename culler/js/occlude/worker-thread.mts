// SPDX-License-Identifier: MIT
// The thread of a WorkerScene that culls.
import {
  load, slots, type Boxes, type Numbers, type Occlude, type OccludeError, type ObjectId, type OccluderId, type OccluderMesh,
} from "./occlude.mjs";
import type {Answer, Edit, Question, Refusal, Start} from "./worker_messages.mjs";

/** Serves the WorkerScene at the other end. */
export function serve(port: MessagePort): void {
  let culling: Culling | undefined;
  const answer = async (message: Start | Question) => {
    if (culling !== undefined) return culling.answer(message as Question);
    culling = new Culling(await load((message as Start).source as BufferSource | string | undefined));
    return "started";
  };
  port.onmessage = async ({data}) => {
    try {
      const reply = await answer(data);
      port.postMessage(reply, reply === "started" ? [] : [reply.objects.buffer]);
    } catch (error) {
      const {code = "failed", message} = error as Partial<OccludeError> & Error;
      port.postMessage({code, message} satisfies Refusal);
    }
  };
}

/** A box that grows. */
class Bounds {
  readonly numbers = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

  hold(x: number, y: number, z: number): void {
    [x, y, z].forEach((value, axis) => {
      this.numbers[axis] = Math.min(this.numbers[axis]!, value);
      this.numbers[axis + 3] = Math.max(this.numbers[axis + 3]!, value);
    });
  }

  holdBoxes(boxes: Boxes): void {
    if (!("oriented" in boxes)) {
      for (let i = 0; i < boxes.length; i += 3) this.hold(boxes[i]!, boxes[i + 1]!, boxes[i + 2]!);
      return;
    }
    const {oriented: b} = boxes;
    for (let i = 0; i < b.length; i += 12) {
      const reach = [0, 1, 2].map(axis => [3, 6, 9].reduce((sum, half) => sum + Math.abs(b[i + half + axis]!), 0));
      for (const side of [-1, 1]) this.hold(b[i]! + side * reach[0]!, b[i + 1]! + side * reach[1]!, b[i + 2]! + side * reach[2]!);
    }
  }

  /** A box where matrices place it. */
  holdPlaced(box: Numbers, m: Numbers): void {
    for (let i = 0; i < m.length; i += 16) {
      for (let corner = 0; corner < 8; ++corner) {
        const [x, y, z] = [0, 1, 2].map(axis => box[(corner >> axis) & 1 ? axis + 3 : axis]!) as [number, number, number];
        const at = (row: number) => m[i + row]! * x + m[i + 4 + row]! * y + m[i + 8 + row]! * z + m[i + 12 + row]!;
        this.hold(at(0), at(1), at(2));
      }
    }
  }
}

/** The scene, and what its things are called on the other thread. */
class Culling {
  readonly #scene;
  readonly #view;
  readonly #bounds = new Bounds();
  readonly #meshes: OccluderMesh[] = [];
  readonly #objects: ObjectId[] = [];
  readonly #occluders: {id: OccluderId; mesh: OccluderMesh}[] = [];
  /** The numbers of objects by their slots. */
  readonly #numbers: number[] = [];

  constructor(readonly occlude: Occlude) {
    this.#scene = new occlude.Scene();
    this.#view = new occlude.View();
  }

  answer({edits, camera, options}: Question): Answer {
    for (const edit of edits) this.#do(edit);
    this.#scene.update();
    const frame = this.#scene.cull(camera, this.#view, {...options, toBeHeld: true});
    return {objects: slots(frame.objects).map(slot => this.#numbers[slot]!), bounds: this.#bounds.numbers};
  }

  #do(edit: Edit): void {
    const scene = this.#scene;
    switch (edit.what) {
      case "addObjects": {
        const ids = scene.addObjects(edit.boxes, edit.options), at = slots(ids);
        edit.ids.forEach((number, i) => {
          this.#objects[number] = ids[i]!;
          this.#numbers[at[i]!] = number;
        });
        return this.#bounds.holdBoxes(edit.boxes);
      }
      case "moveObjects":
        scene.moveObjects(this.#objectsOf(edit.ids), edit.boxes);
        return this.#bounds.holdBoxes(edit.boxes);
      case "removeObjects":
        return scene.removeObjects(this.#objectsOf(edit.ids));
      case "enableObjects":
        return scene.enableObjects(this.#objectsOf(edit.ids), edit.isEnabled);
      case "maskObjects":
        return scene.maskObjects(this.#objectsOf(edit.ids), edit.mask);
      case "addMesh":
        this.#meshes[edit.id] = new this.occlude.OccluderMesh(edit.polygons);
        return;
      case "addOccluders": {
        const mesh = this.#meshes[edit.mesh]!;
        const object = edit.object === undefined ? undefined : this.#objects[edit.object]!;
        const ids = scene.addOccluders(mesh, edit.placements, object === undefined ? edit.options : {...edit.options, object});
        edit.ids.forEach((number, i) => (this.#occluders[number] = {id: ids[i]!, mesh}));
        return this.#bounds.holdPlaced(mesh.box, edit.placements);
      }
      case "moveOccluders":
        scene.moveOccluders(this.#occludersOf(edit.ids), edit.placements);
        edit.ids.forEach((number, i) => {
          this.#bounds.holdPlaced(this.#occluders[number]!.mesh.box, Array.from(edit.placements).slice(16 * i, 16 * i + 16));
        });
        return;
      case "removeOccluders":
        return scene.removeOccluders(this.#occludersOf(edit.ids));
      case "enableOccluders":
        return scene.enableOccluders(this.#occludersOf(edit.ids), edit.isEnabled);
    }
  }

  #objectsOf(numbers: readonly number[]): ObjectId[] {
    return numbers.map(number => this.#objects[number]!);
  }
  #occludersOf(numbers: readonly number[]): OccluderId[] {
    return numbers.map(number => this.#occluders[number]!.id);
  }
}
