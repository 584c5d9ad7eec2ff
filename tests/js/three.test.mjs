// SPDX-License-Identifier: MIT
// Scenes of three.js: which meshes a renderer is told to leave out, found without one, and held against rays.
import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {test as check} from "node:test";

import {dist, load, need, packageFolder, random} from "./common.mjs";

const module = `${packageFolder}/node_modules/three/build/three.module.js`;
const needed = need(module, "three in node_modules");
const test = (name, work) => check(name, needed, work);
const THREE = existsSync(module) ? await import(module) : {};
const {Occlusion} = existsSync(module) ? await import(`${dist}/three.mjs`) : {};
const occlude = await load();

/** Asks as WebGLRenderer does: each visible object once for the picture, and then again for the map of a shadow. */
function render(scene, camera, renderer = {clippingPlanes: []}) {
  const drawn = new Set(), shadows = new Set(), instances = new Map(), shadowInstances = new Map();
  const visit = (object, found) => {
    if (!object.visible) return;
    if (object.layers.test(camera.layers)) {
      if (object.isLOD && object.autoUpdate) object.update(camera);
      if (object.isMesh) found.add(object);
    }
    for (const child of object.children) visit(child, found);
  };
  const instancesOf = batch => new Set(batch._indirectTexture.image.data.subarray(0, batch._multiDrawCount));
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  scene.onBeforeRender(renderer, scene, camera);
  visit(scene, drawn);
  visit(scene, shadows);
  for (const object of shadows) {
    if (!object.isBatchedMesh) continue;
    object.onBeforeShadow(renderer, object, camera, camera.clone(), object.geometry, object.material);
    shadowInstances.set(object, instancesOf(object));
    object.onAfterShadow(renderer, object, camera, camera.clone(), object.geometry, object.material);
  }
  for (const object of drawn) {
    object.onBeforeRender(renderer, scene, camera, object.geometry, object.material);
    if (object.isBatchedMesh) instances.set(object, instancesOf(object));
    object.onAfterRender(renderer, scene, camera, object.geometry, object.material);
  }
  scene.onAfterRender(renderer, scene, camera);
  return {drawn, shadows, instances, shadowInstances};
}

const cubes = () => new THREE.BoxGeometry(1, 1, 1);
const mesh = (material = {}, size = [1, 1, 1], place = [0, 0, -20]) => {
  const made = new THREE.Mesh(cubes(), new THREE.MeshBasicMaterial(material));
  made.scale.set(...size);
  made.position.set(...place);
  return made;
};
/** From the origin along -z, at a wall at z = -10, with a cube behind it. */
function behindWall(material) {
  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(60, 16 / 9, 0.1, 100);
  const wall = mesh(material, [10, 10, 0.5], [0, 0, -10]), thing = mesh();
  scene.add(wall, thing);
  return {scene, camera, wall, thing, occlusion: new Occlusion(occlude, scene)};
}

test("what is behind is left out of the picture, and of nothing else", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  assert.equal(render(scene, camera).drawn.size, 2, "before the first update");
  occlusion.update(camera);
  const {drawn, shadows} = render(scene, camera);
  assert.deepEqual([drawn.has(wall), drawn.has(thing), shadows.has(thing)], [true, false, true]);
  assert.equal(occlusion.hiddenFrom(camera), 1);
  assert.equal(thing.layers.test(camera.layers), true, "for picking");
  assert.equal(render(scene, camera.clone()).drawn.size, 2, "another camera");
  assert.equal(render(scene, camera, {clippingPlanes: [new THREE.Plane()]}).drawn.size, 2);
  camera.position.x = 18;
  assert.equal(render(scene, camera).drawn.size, 2, "a camera that has moved");
  occlusion.update(camera);
  assert.ok(render(scene, camera).drawn.has(thing));
  scene.overrideMaterial = new THREE.MeshBasicMaterial({transparent: true});
  assert.equal(render(scene, camera).drawn.size, 2);
});

test("transparent and tested materials hide nothing, and are hidden", () => {
  for (const material of [{transparent: true}, {alphaTest: 0.5}, {depthWrite: false}, {colorWrite: false}, {visible: false},
                          {alphaHash: true}, {clippingPlanes: [new THREE.Plane()]}, {blending: THREE.AdditiveBlending}]) {
    const {scene, camera, thing, occlusion} = behindWall(material);
    occlusion.update(camera);
    assert.ok(render(scene, camera).drawn.has(thing), Object.keys(material)[0]);
  }
  const {scene, camera, occlusion} = behindWall(), glass = mesh({transparent: true, opacity: 0.5});
  scene.add(glass);
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.has(glass), false);
});

test("sides: a wall that is drawn from its back alone hides from there", () => {
  for (const [side, isHidden] of [[THREE.FrontSide, true], [THREE.BackSide, false], [THREE.DoubleSide, true]]) {
    const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(60, 1, 0.1, 100), thing = mesh();
    const plane = new THREE.Mesh(new THREE.PlaneGeometry(20, 20), new THREE.MeshBasicMaterial({side}));
    plane.position.z = -10; // its front looks along z, to the camera
    scene.add(plane, thing);
    const occlusion = new Occlusion(occlude, scene);
    occlusion.update(camera);
    assert.equal(!render(scene, camera).drawn.has(thing), isHidden);
    plane.scale.x = -1; // mirrored: three.js still draws the same side
    occlusion.update(camera);
    assert.equal(!render(scene, camera).drawn.has(thing), isHidden);
    plane.rotation.y = Math.PI;
    occlusion.update(camera);
    assert.equal(!render(scene, camera).drawn.has(thing), side !== THREE.FrontSide);
  }
});

test("what may reach out of its box, or shows through, is always drawn", () => {
  const {scene, camera, occlusion} = behindWall();
  const skinned = new THREE.SkinnedMesh(cubes(), new THREE.MeshBasicMaterial());
  const morphing = new THREE.Mesh(cubes(), new THREE.MeshBasicMaterial());
  morphing.geometry.morphAttributes.position = [morphing.geometry.getAttribute("position")];
  const own = new THREE.Mesh(cubes(), new THREE.ShaderMaterial()), patched = mesh();
  patched.material.onBeforeCompile = () => {};
  const billboard = mesh();
  billboard.onBeforeRender = () => billboard.matrixWorld.setPosition(0, 0, -2);
  const counted = mesh(), fed = new THREE.Mesh(new THREE.InstancedBufferGeometry().copy(cubes()), new THREE.MeshBasicMaterial());
  counted.count = 3; // of WebGPURenderer
  const moved = mesh();
  Object.assign(moved.material, {isNodeMaterial: true, depthNode: {}});
  const ways = [{depthTest: false}, {wireframe: true}, {polygonOffset: true}, {stencilWrite: true}];
  const all = [skinned, morphing, own, patched, billboard, counted, fed, moved, ...ways.map(way => mesh(way))];
  for (const each of all) each.position.z = -20, scene.add(each);
  occlusion.update(camera);
  const {drawn} = render(scene, camera);
  assert.deepEqual(all.map(each => drawn.has(each)), all.map(() => true));
});

test("groups come, go and move; geometries and instances change; layers", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  const isHidden = () => (occlusion.update(camera), !render(scene, camera).drawn.has(thing));
  const group = new THREE.Group();
  scene.add(group);
  group.add(thing);
  assert.equal(isHidden(), true);
  group.position.x = 15;
  assert.equal(isHidden(), false);
  group.position.x = 0;
  assert.equal(isHidden(), true);
  wall.visible = false;
  assert.equal(isHidden(), false);
  wall.visible = true;
  assert.equal(isHidden(), true);
  wall.layers.set(1);
  assert.equal(isHidden(), false);
  camera.layers.enable(1);
  assert.equal(isHidden(), true);
  wall.layers = new THREE.Layers();
  assert.equal(isHidden(), true);
  wall.material.transparent = true;
  assert.equal(isHidden(), false);
  wall.material.transparent = false;
  const position = wall.geometry.getAttribute("position");
  for (let i = 0; i < position.count; ++i) position.setX(i, position.getX(i) + 9);
  position.needsUpdate = true;
  assert.equal(isHidden(), false);
  scene.remove(wall);
  const bricks = new THREE.InstancedMesh(cubes(), new THREE.MeshBasicMaterial(), 4);
  for (let i = 0; i < 4; ++i) bricks.setMatrixAt(i, new THREE.Matrix4().makeScale(3, 8, 1).setPosition(3 * i - 4.5, 0, -10));
  scene.add(bricks);
  assert.equal(isHidden(), false, "a seam is left between the two in the middle");
  for (let i = 0; i < 4; ++i) bricks.setMatrixAt(i, new THREE.Matrix4().makeScale(9, 8, 1).setPosition(3 * i - 4.5, 0, -10));
  bricks.instanceMatrix.needsUpdate = true;
  assert.equal(isHidden(), true);
  const many = new THREE.InstancedMesh(cubes(), new THREE.MeshBasicMaterial(), 2);
  for (let i = 0; i < 2; ++i) many.setMatrixAt(i, new THREE.Matrix4().setPosition(i, 0, -20));
  scene.add(many);
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.has(many), false);
});

test("nothing hides that is drawn in part, or not at all", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  const isHidden = () => (occlusion.update(camera), !render(scene, camera).drawn.has(thing));
  const {geometry, material} = wall;
  geometry.setDrawRange(0, 6);
  assert.equal(isHidden(), false);
  geometry.setDrawRange(0, Infinity);
  assert.equal(isHidden(), true);
  wall.material = [material];
  assert.equal(isHidden(), false, "a box has a group for each side");
  geometry.clearGroups();
  geometry.addGroup(0, 36, 0);
  assert.equal(isHidden(), true);
  geometry.groups[0].count = 30;
  assert.equal(isHidden(), false);
  geometry.groups[0].count = 36;
  geometry.groups[0].materialIndex = 1;
  assert.equal(isHidden(), false);
  wall.material = material;
  assert.equal(isHidden(), true);
  const other = geometry.getAttribute("position").clone();
  other.array.fill(0);
  geometry.setAttribute("position", other);
  assert.equal(isHidden(), false, "another buffer of the same size and version");
  wall.geometry = cubes();
  assert.equal(isHidden(), true);
  wall.matrixAutoUpdate = false;
  wall.matrix.elements[3] = 0.1;
  wall.matrixWorldNeedsUpdate = true;
  assert.equal(isHidden(), false, "a matrix that is nothing that places");
  wall.matrix.elements[3] = 0;
  wall.matrixWorldNeedsUpdate = true;
  assert.equal(isHidden(), true);
  for (const [group, isHiding] of [["isClippingGroup", false], ["isBundleGroup", false], ["isGroup", true]]) {
    const made = new THREE.Group();
    made[group] = true;
    scene.add(made);
    made.add(wall);
    assert.equal(isHidden(), isHiding, group);
  }
});

/** A batch of cubes: a wall at z = -10, and five behind it. */
function batchBehindWall() {
  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(60, 16 / 9, 0.1, 100);
  const batch = new THREE.BatchedMesh(20, 1000, 2000, new THREE.MeshBasicMaterial());
  const cube = batch.addGeometry(cubes()), ball = batch.addGeometry(new THREE.SphereGeometry(0.5, 8, 6));
  const add = (geometry, matrix) => {
    const id = batch.addInstance(geometry);
    batch.setMatrixAt(id, matrix);
    return id;
  };
  const wall = add(cube, new THREE.Matrix4().makeScale(12, 12, 1).setPosition(0, 0, -10));
  const things = [0, 1, 2, 3, 4].map(i => add(i % 2 ? ball : cube, new THREE.Matrix4().setPosition(i - 2, 0, -20)));
  scene.add(batch);
  return {scene, camera, batch, cube, ball, add, wall, things, occlusion: new Occlusion(occlude, scene)};
}

test("geometries that are freed once the renderer has them: what was seen before that is kept", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  const isHidden = () => (occlusion.update(camera), !render(scene, camera).drawn.has(thing));
  assert.equal(isHidden(), true);
  delete wall.geometry.getAttribute("position").array;
  wall.geometry.index.array = null;
  assert.equal(isHidden(), true);
  wall.position.y = 30;
  assert.equal(isHidden(), false);
  wall.position.y = 0;
  wall.material.transparent = true;
  assert.equal(isHidden(), false);
  wall.material.transparent = false;
  assert.equal(isHidden(), true);
  wall.visible = false;
  assert.equal(isHidden(), false);
  wall.visible = true;
  assert.equal(isHidden(), false, "nobody can tell any more what it is");
  assert.equal(render(scene, camera).drawn.has(wall), true);
});

test("boxes of what is still to be loaded", () => {
  const {scene, camera, occlusion} = behindWall();
  const at = (x, z) => new THREE.Box3(new THREE.Vector3(x, 0, z), new THREE.Vector3(x + 1, 1, z + 1));
  assert.equal(occlusion.isHidden(at(0, -20), camera), false, "before the first update");
  occlusion.update(camera);
  const hidden = [[0, -20], [0, -5], [0, 5], [18, -20]].map(([x, z]) => occlusion.isHidden(at(x, z), camera));
  assert.deepEqual(hidden, [true, false, true, false]);
  assert.equal(render(scene, camera).drawn.size, 1);
});

test("batched meshes hide by each instance, and each is hidden", () => {
  const {scene, camera, batch, cube, add, wall, things, occlusion} = batchBehindWall();
  const drawnAfter = change => {
    change();
    occlusion.update(camera);
    return [...render(scene, camera).instances.get(batch) ?? []].sort();
  };
  const all = [wall, ...things];
  assert.deepEqual([...render(scene, camera).instances.get(batch)].sort(), all, "before the first update");
  assert.deepEqual(drawnAfter(() => {}), [wall]);
  assert.equal(occlusion.hiddenFrom(camera), 5);
  const {instances, shadowInstances} = render(scene, camera);
  assert.deepEqual([[...instances.get(batch)], [...shadowInstances.get(batch)].sort()], [[wall], all]);
  assert.deepEqual(all.map(id => batch.getVisibleAt(id)), all.map(() => true), "for the application nothing is changed");
  assert.deepEqual([...render(scene, camera.clone()).instances.get(batch)].sort(), all, "another camera");
  assert.deepEqual(drawnAfter(() => batch.setVisibleAt(things[1], false)), [wall]);
  assert.equal(batch.getVisibleAt(things[1]), false);
  assert.deepEqual(drawnAfter(() => batch.setVisibleAt(wall, false)), things.filter((_, i) => i !== 1), "the wall is invisible");
  drawnAfter(() => batch.setVisibleAt(wall, true));
  batch.setVisibleAt(things[2], false);
  assert.deepEqual([[...render(scene, camera).instances.get(batch)], batch.getVisibleAt(things[2])], [[wall], false], "changed since");
  batch.setVisibleAt(things[2], true);
  assert.deepEqual(drawnAfter(() => batch.setVisibleAt(wall, true).setVisibleAt(things[1], true)), [wall]);
  assert.deepEqual(drawnAfter(() => batch.setMatrixAt(things[0], new THREE.Matrix4().setPosition(0, 2, -5))), [wall, things[0]]);
  assert.deepEqual(drawnAfter(() => batch.deleteInstance(wall)), things);
  let other;
  assert.deepEqual(drawnAfter(() => (other = add(cube, new THREE.Matrix4().setPosition(0, 0, -30)))), things);
  assert.equal(other, wall, "ids are given anew");
  assert.deepEqual(drawnAfter(() => batch.setMatrixAt(other, new THREE.Matrix4().makeScale(12, 12, 1).setPosition(0, 0, -10))),
    [other, things[0]]);
  assert.deepEqual(drawnAfter(() => batch.position.setZ(-40)), [other, things[0]]);
  assert.deepEqual(drawnAfter(() => (batch.position.z = 90)), [], "all of it is behind the eye");
  assert.ok(!render(scene, camera).drawn.has(batch), "as a whole");
  assert.deepEqual(drawnAfter(() => (batch.position.z = 0)), [other, things[0]]);
});

test("batched meshes: geometries that change", () => {
  const {scene, camera, batch, cube, ball, wall, things, occlusion} = batchBehindWall();
  const drawnAfter = change => {
    change();
    occlusion.update(camera);
    return [...render(scene, camera).instances.get(batch) ?? []].sort();
  };
  assert.deepEqual(drawnAfter(() => {}), [wall]);
  const flat = new THREE.BoxGeometry(1, 0.01, 1);
  assert.deepEqual(drawnAfter(() => batch.setGeometryAt(cube, flat)), [wall, things[1], things[3]], "flat ones behind it are hidden");
  assert.deepEqual(drawnAfter(() => batch.setGeometryAt(cube, cubes())), [wall]);
  assert.deepEqual(drawnAfter(() => batch.setGeometryIdAt(wall, ball).setMatrixAt(wall, new THREE.Matrix4().setPosition(0, 4, -10))),
    [wall, ...things], "a ball aside hides nothing");
  assert.deepEqual(drawnAfter(() => batch.setGeometryIdAt(wall, cube).setMatrixAt(wall, new THREE.Matrix4().makeScale(12, 12, 1)
    .setPosition(0, 0, -10))), [wall]);
  assert.deepEqual(drawnAfter(() => batch.addGeometry(new THREE.ConeGeometry(1, 2, 5))), [wall]);
  assert.deepEqual(drawnAfter(() => batch.deleteGeometry(ball)), [wall]);
  assert.deepEqual(drawnAfter(() => batch.optimize()), [wall]);
  assert.deepEqual(drawnAfter(() => batch.setVisibleAt(wall, false)), things.filter((_, i) => i % 2 === 0));
});

test("a batch whose drawing throws, or that the application draws by itself, is as it was", () => {
  const {scene, camera, batch, wall, things, occlusion} = batchBehindWall();
  occlusion.update(camera);
  scene.onBeforeRender({clippingPlanes: []}, scene, camera);
  batch.onBeforeRender({}, scene, camera, batch.geometry, batch.material);
  assert.equal(batch.getVisibleAt(things[0]), false, "while it is drawn");
  occlusion.update(camera);
  assert.equal(batch.getVisibleAt(things[0]), true);
  batch.onAfterRender = () => {};
  assert.equal(render(scene, camera).instances.get(batch).size, 6, "nobody would make them visible again");
  const {onBeforeRender} = THREE.BatchedMesh.prototype;
  batch.onBeforeRender = (...given) => onBeforeRender.apply(batch, given);
  occlusion.update(camera);
  assert.equal(render(scene, camera).instances.get(batch).size, 6);
  delete batch.onBeforeRender, delete batch.onAfterRender;
  occlusion.update(camera);
  assert.deepEqual([...render(scene, camera).instances.get(batch)], [wall]);
  scene.remove(batch);
  occlusion.update(camera);
  assert.equal(Object.hasOwn(batch, "onBeforeRender") || Object.hasOwn(batch, "onAfterRender"), false);
});

test("levels of detail are those of the camera", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  scene.remove(wall);
  const lod = new THREE.LOD();
  lod.position.z = -10;
  wall.position.z = 0;
  lod.addLevel(wall, 0);
  lod.addLevel(mesh({}, [0.1, 0.1, 0.1], [0, 0, 0]), 50);
  scene.add(lod);
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.has(thing), false);
  camera.position.z = 60;
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.has(thing), true);
});

test("orthographic cameras, reversed depth, WebGPU's depth, several cameras at once", () => {
  const {scene, thing, occlusion} = behindWall();
  const cameras = [new THREE.OrthographicCamera(-8, 8, 5, -5, 0.1, 100), new THREE.PerspectiveCamera(60, 2, 0.1, 100)];
  for (const camera of [...cameras]) {
    const gpu = camera.clone();
    gpu.coordinateSystem = THREE.WebGPUCoordinateSystem;
    const reversed = gpu.clone();
    reversed.coordinateSystem = THREE.WebGPUCoordinateSystem;
    reversed._reversedDepth = true;
    for (const each of [gpu, reversed]) each.updateProjectionMatrix(), cameras.push(each);
  }
  const aside = new THREE.PerspectiveCamera(60, 2, 0.1, 100);
  aside.position.set(30, 0, -20);
  aside.lookAt(0, 0, -20);
  for (const camera of [...cameras, aside]) occlusion.update(camera);
  for (const camera of cameras) assert.equal(render(scene, camera).drawn.has(thing), false);
  assert.equal(render(scene, aside).drawn.has(thing), true);
});

test("dispose leaves all as it was", () => {
  const scene = new THREE.Scene(), calls = [];
  const before = () => calls.push("before");
  scene.onBeforeRender = before;
  const {batch, things} = batchBehindWall();
  scene.add(mesh({}, [10, 10, 1], [0, 0, -10]), mesh(), batch);
  const camera = new THREE.PerspectiveCamera(), occlusion = new Occlusion(occlude, scene);
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.size, 2);
  assert.deepEqual(calls, ["before"]);
  occlusion.dispose();
  const {drawn, instances} = render(scene, camera);
  assert.deepEqual([drawn.size, instances.get(batch).size], [3, things.length + 1]);
  assert.equal(scene.onBeforeRender, before);
  scene.traverse(object => {
    assert.deepEqual(Object.keys(object.layers), ["mask"]);
    assert.equal(Object.hasOwn(object, "onBeforeRender") || Object.hasOwn(object, "onAfterRender"), object === scene);
  });
});

test("layers that several meshes share are left alone", () => {
  const {scene, camera, wall, thing, occlusion} = behindWall();
  thing.layers = wall.layers;
  occlusion.update(camera);
  assert.equal(render(scene, camera).drawn.size, 2);
});

test("in random scenes that change, no ray finds what is left out", () => {
  const next = random(8), scene = new THREE.Scene(), occlusion = new Occlusion(occlude, scene), raycaster = new THREE.Raycaster();
  const shapes = [cubes(), new THREE.SphereGeometry(0.7, 12, 8), new THREE.ConeGeometry(0.6, 2, 9), new THREE.PlaneGeometry(3, 3)];
  const place = object => {
    object.position.set(40 * next() - 20, 20 * next() - 10, 40 * next() - 20);
    object.rotation.set(6 * next(), 6 * next(), 6 * next());
    object.scale.setScalar(0.5 + 4 * next() * next());
  };
  const sides = [THREE.FrontSide, THREE.BackSide, THREE.DoubleSide];
  const add = () => {
    const pick = list => list[Math.floor(next() * list.length)];
    const made = new THREE.Mesh(pick(shapes), new THREE.MeshBasicMaterial({side: pick(sides), transparent: next() < 0.1}));
    place(made);
    scene.add(made);
  };
  for (let i = 0; i < 300; ++i) add();
  const batch = new THREE.BatchedMesh(150, 4000, 9000, new THREE.MeshBasicMaterial()), placed = new THREE.Object3D();
  const geometries = shapes.map(each => batch.addGeometry(each));
  const placeInstance = id => {
    place(placed);
    placed.updateMatrix();
    batch.setMatrixAt(id, placed.matrix);
  };
  const addInstance = () => placeInstance(batch.addInstance(geometries[Math.floor(next() * geometries.length)]));
  for (let i = 0; i < 150; ++i) addInstance();
  scene.add(batch);
  let hidden = 0;
  const camera = new THREE.PerspectiveCamera(70, 1.5, 0.1, 200);
  for (let f = 0; f < 12; ++f) {
    place(camera);
    camera.scale.setScalar(1);
    for (let i = 0; i < 10; ++i) place(scene.children[Math.floor(next() * 300)]);
    scene.remove(scene.children.find(each => each !== batch));
    add();
    for (let i = 0; i < 10; ++i) placeInstance(Math.floor(next() * 75));
    batch.deleteInstance(75 + f);
    addInstance();
    const invisible = 100 + f;
    batch.setVisibleAt(invisible, !batch.getVisibleAt(invisible));
    occlusion.update(camera);
    const {drawn, instances} = render(scene, camera);
    hidden += occlusion.hiddenFrom(camera);
    for (let x = 0; x < 40; ++x) {
      for (let y = 0; y < 26; ++y) {
        raycaster.setFromCamera(new THREE.Vector2((2 * x + 1) / 40 - 1, (2 * y + 1) / 26 - 1), camera);
        raycaster.near = camera.near / raycaster.ray.direction.dot(camera.getWorldDirection(new THREE.Vector3()));
        for (const {object, batchId} of raycaster.intersectObjects(scene.children)) {
          assert.ok(drawn.has(object), `frame ${f}: a ray finds what is left out`);
          if (object === batch) assert.ok(instances.get(batch).has(batchId), `frame ${f}: a ray finds an instance that is left out`);
          if (!object.material.transparent) break;
        }
      }
    }
  }
  console.log(`${hidden} of ${12 * 450} are left out`);
  assert.ok(hidden > 1500);
});

test("memory is steady over 10,000 frames, of a scene that changes", async () => {
  const own = await load(), before = own.memoryBytes, filler = [], vertices = new Float64Array(30000);
  while (own.memoryBytes === before) filler.push(new own.OccluderMesh({vertices, indices: [0, 1, 2]})); // so that little is left
  const next = random(9), scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(60, 1.6, 0.1, 100);
  const batch = new THREE.BatchedMesh(30, 1000, 2000, new THREE.MeshBasicMaterial()), cube = batch.addGeometry(cubes());
  const somewhere = () => [20 * next() - 10, 10 * next() - 5, -5 - 30 * next()];
  for (let i = 0; i < 20; ++i) scene.add(mesh({transparent: i % 5 === 0}, [1 + 3 * next(), 1 + 3 * next(), 1], somewhere()));
  for (let i = 0; i < 20; ++i) batch.setMatrixAt(batch.addInstance(cube), new THREE.Matrix4().setPosition(...somewhere()));
  const occlusion = new Occlusion(own, scene);
  let memoryBytes = 0;
  for (let f = 0; f < 10000; ++f) {
    const [first] = scene.children;
    if (f % 3 === 0) first.position.set(...somewhere());
    if (f % 7 === 0) scene.remove(first), scene.add(f % 2 ? first : mesh({}, [1, 1, 1], somewhere()));
    if (f % 5 === 0) batch.setMatrixAt(f % 20, new THREE.Matrix4().setPosition(...somewhere()));
    if (f % 11 === 0) batch.deleteInstance(f % 20), batch.addInstance(cube);
    if (f % 500 === 0) batch.parent ? scene.remove(batch) : scene.add(batch);
    occlusion.update(camera);
    if (f === 3000) memoryBytes = own.memoryBytes;
  }
  assert.ok(own.memoryBytes - memoryBytes <= 4 * 65536, "a few pages, as what is alive at once varies; leaked meshes were 29");
  for (const each of [...filler, occlusion]) each.dispose();
});
