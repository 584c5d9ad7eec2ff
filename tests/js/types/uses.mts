// SPDX-License-Identifier: MIT
// Compiles: what the types allow, and what they refuse.
import {
  hidden, load, OccludeError, slot, slots, type Camera, type Fate, type ObjectId, type ObjectIds, type OccluderId, type SceneFrame,
} from "occlude";
import type {Occlusion} from "occlude/three";
import {startWorker, type WorkerObject} from "occlude/worker";

const occlude = await load();
const scene = new occlude.Scene();
const object: ObjectId = scene.addObject([0, 0, 0, 1, 1, 1], {moves: true});
const objects: ObjectIds = scene.addObjects(new Float32Array(12));
const mesh = new occlude.OccluderMesh({vertices: new Float32Array(9), indices: [0, 1, 2]});
const occluder: OccluderId = scene.addOccluder(mesh, undefined, {object, weld: 1});
const view = new occlude.View();
const camera: Camera = {matrix: new Float32Array(16), depth: "zero_to_w", nearer: "greater"};
const frame: SceneFrame = scene.cull(camera, view, {frontToBack: true, coverSize: [640, 400]});
const first: ObjectId = frame.objects[0]!;
for (const id of frame.objects) scene.hasObject(id);
const numbers: Uint32Array = slots(frame.objects), number: number = slot(first);
const [fate]: Fate[] = scene.why([first, object], view);
const by: OccluderId | undefined = fate?.by?.[0]?.occluder;
const held = new occlude.HeldSceneCull(scene, {later: task => queueMicrotask(task), way: {aside: 1}});
const isHeld: boolean = held.isOfPoint;
const culler = new occlude.Culler({vertices: [0, 0, 0], indices: [0, 0, 0]}, {leafSize: 8, bounds: "obb"});
const drawn: Uint32Array = culler.cull(camera, new occlude.ModelView()).drawn;
const why: number = hidden;
const error: Error = new OccludeError("failed", "");
{
  using other = new occlude.View();
  other.holdsFor(camera);
}
view.dispose();
const inWorker = await startWorker({cull: {margin: occlude.marginFor(720)}});
const things: WorkerObject[] = inWorker.addObjects(new Float32Array(6));
inWorker.addOccluders(inWorker.addMesh({vertices: [], indices: []}), [], {object: things[0]});
const isUnasked: boolean = inWorker.cull(camera, 0).isUnasked;
export type {Occlusion};
export {by, isUnasked, drawn, error, isHeld, number, numbers, objects, why};

// @ts-expect-error an id of the other kind
scene.removeObjects([occluder]);
// @ts-expect-error an id of the other kind
scene.removeOccluders(objects);
// @ts-expect-error a number is no id
scene.hasObject(3);
// @ts-expect-error any bigint is no id
scene.hasObject(3n);
// @ts-expect-error depth must be said
scene.cull({matrix: new Float32Array(16)}, view);
// @ts-expect-error an unknown word
scene.cull({matrix: new Float32Array(16), depth: "z"}, view);
// @ts-expect-error a view of models
scene.cull(camera, new occlude.ModelView());
// @ts-expect-error an option that there is not
scene.cull(camera, view, {frontToback: true});
// @ts-expect-error frames are not changed
frame.sizes = new Float32Array(0);
// @ts-expect-error an id of another scene
inWorker.removeObjects([3]);
// @ts-expect-error what is internal
scene.resource;
