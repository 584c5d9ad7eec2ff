// SPDX-License-Identifier: MIT
// Does by the package what replay.c does by the C interface, and gives the same numbers.

const columns = m => [0, 3, 6, 9].flatMap((from, c) => [...m.slice(from, from + 3), c === 3 ? 1 : 0]);

/** The answers to steps, each [what, ...numbers], and the mean milliseconds of a frame. */
export function replay(occlude, steps) {
  const scene = new occlude.Scene(), view = new occlude.View(), region = new occlude.View();
  const meshes = [], objects = [], occluders = [], answers = [];
  let milliseconds = 0, frames = 0;
  const cameraOf = p => ({eye: p.slice(0, 3), target: p.slice(3, 6)});
  const put = frame => {
    answers.push(frame.objects.length);
    frame.objects.forEach((id, i) => answers.push(Number(id & 0x0fffffffn), frame.sizes[i], frame.distances[i]));
    answers.push(frame.statistics.hidden, frame.statistics.outOfView, frame.statistics.coverTriangles);
  };
  const does = [
    p => objects.push(...scene.addObjects(p.slice(2), {moves: p[0] !== 0, mask: p[1]})),
    p => scene.moveObjects([objects[p[0]]], p.slice(1)),
    p => scene.removeObjects([objects[p[0]]]),
    p => scene.enableObjects([objects[p[0]]], p[1] !== 0),
    p => scene.maskObjects([objects[p[0]]], p[1]),
    p => meshes.push(new occlude.OccluderMesh({vertices: p, indices: Array.from({length: p.length / 3}, (_, i) => i)})),
    p => {
      const object = p[17] >= 0 ? objects[p[17]] : undefined;
      const how = {moves: p[13] !== 0, oneSided: p[14] !== 0, mask: p[15], weld: p[16], object};
      occluders.push(scene.addOccluder(meshes[p[0]], columns(p.slice(1, 13)), how));
    },
    p => scene.moveOccluders([occluders[p[0]]], columns(p.slice(1))),
    p => scene.removeOccluders([occluders[p[0]]]),
    p => scene.enableOccluders([occluders[p[0]]], p[1] !== 0),
    p => scene.replaceOccluder(occluders[p[0]], meshes[p[1]]),
    () => scene.update(),
    p => {
      const start = performance.now();
      const frame = scene.cull(cameraOf(p), view, {mask: p[6], leastSize: p[7], margin: p[8], adaptive: false});
      milliseconds += performance.now() - start;
      ++frames;
      put(frame);
    },
    p => {
      const camera = cameraOf(p), how = {adaptive: false};
      scene.cull(occlude.ahead(camera, p.slice(6), 1), region, {...how, toBeHeld: true});
      const holds = scene.holds(region, camera, how);
      answers.push(Number(holds));
      if (holds) put(scene.cullHeld(camera, region, view, how));
    },
  ];
  for (const [what, ...numbers] of steps) does[what](numbers);
  return {answers: Float64Array.from(answers), milliseconds: milliseconds / frames};
}

/** A file of steps. */
export function bytesOf(steps) {
  const numbers = steps.flatMap(([what, ...rest]) => [what, rest.length, ...rest]);
  return new Uint8Array(Float64Array.from(numbers).buffer);
}
