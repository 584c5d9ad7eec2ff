// SPDX-License-Identifier: MIT
// Random edits of a scene, as steps of replay.mjs, with a frame now and then.

export function randomEdits(next, count) {
  const steps = [];
  const whole = below => Math.floor(next() * below);
  const pick = set => [...set][whole(set.size)];
  const box = () => {
    const low = [0, 0, 0].map(() => 80 * next() - 40);
    return [...low, ...low.map(x => x + 0.1 + 3 * next())];
  };
  const placement = () => {
    const numbers = [1, 0, 0, 0, 1, 0, 0, 0, 1].map(x => x + (next() - 0.5) / 2);
    const angle = 2 * Math.PI * next(), far = 10 + 20 * next();
    return [...numbers, far * Math.cos(angle), far * Math.sin(angle), 4 * next() - 2];
  };
  const soup = triangles => Array.from({length: 9 * triangles}, () => 12 * next() - 6);
  const camera = () => [0, 0, 0, 0, 0, 0].map((_, i) => (i < 3 ? 4 : 30) * (next() - 0.5));
  const objects = new Set(), occluders = new Set();
  let objectCount = 0, occluderCount = 0;
  const addObjects = n => {
    steps.push([0, whole(2), next() < 0.8 ? 3 : 1 + whole(2), ...Array.from({length: n}, box).flat()]);
    for (let i = 0; i < n; ++i) objects.add(objectCount++);
  };
  const addOccluder = () => {
    const object = next() < 0.2 ? pick(objects) : -1;
    steps.push([6, whole(meshes), ...placement(), whole(2), Number(next() < 0.1), 3, next() < 0.1 ? 1 + whole(2) : 0, object]);
    occluders.add(occluderCount++);
  };
  const meshes = 8;
  for (let i = 0; i < meshes; ++i) steps.push([5, ...soup(1 + 6 * i)]);
  addObjects(400);
  for (let i = 0; i < 40; ++i) addOccluder();
  const removed = (set, what) => {
    const i = pick(set);
    set.delete(i);
    steps.push([what, i]);
  };
  const edits = [
    () => objects.size < 600 && addObjects(1 + whole(10)),
    () => steps.push([1, pick(objects), ...box()]),
    () => steps.push([1, pick(objects), ...box()]),
    () => objects.size > 200 && removed(objects, 2),
    () => steps.push([3, pick(objects), whole(2)]),
    () => steps.push([4, pick(objects), 1 + whole(3)]),
    () => occluders.size < 60 && addOccluder(),
    () => steps.push([7, pick(occluders), ...placement()]),
    () => occluders.size > 20 && removed(occluders, 8),
    () => steps.push([9, pick(occluders), whole(2)]),
    () => steps.push([10, pick(occluders), whole(meshes)]),
  ];
  while (steps.length < count) {
    for (let k = whole(80); k > 0; --k) edits[whole(edits.length)]();
    steps.push([11]);
    steps.push([12, ...camera(), 1 + whole(3), next() < 0.2 ? 0.01 : 0, next() < 0.5 ? 1 / 4096 : 0]);
    if (next() < 0.2) steps.push([13, ...camera(), next(), next(), 0]);
  }
  return steps;
}
