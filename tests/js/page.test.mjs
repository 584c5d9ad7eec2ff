// SPDX-License-Identifier: MIT
// The parts of the page that need no browser: proofs, the rivals and their judge, links, recorded paths, models that are inside and
// built-in scenes. In a browser the page is tested by tests/page/flight_test.py.
import assert from "node:assert/strict";
import {test} from "node:test";
import {deflateSync} from "node:zlib";

import {dist, need, packageFolder, random} from "./common.mjs";

const made = `${packageFolder}/page/made`;
const isMade = need(`${made}/main.mjs`, "page (culler/js/page/build.sh)");
const part = name => import(`${made}/${name}.mjs`);

// ---- Proofs ----

/** Doubles as integers of 2^-1074. */
function exact(value) {
  const bits = new BigUint64Array(Float64Array.of(value).buffer)[0];
  const exponent = (bits >> 52n) & 2047n, fraction = bits & ((1n << 52n) - 1n);
  const size = exponent === 0n ? fraction : (fraction | (1n << 52n)) << (exponent - 1n);
  return bits >> 63n ? -size : size;
}
const signOf = big => (big > 0n ? 1 : big < 0n ? -1 : 0);

/** As side() would be with exact numbers. */
function exactSide(...points) {
  const [a, b, c, d] = points.map(point => point.map(exact));
  const [u, v, w] = [a, b, c].map(point => point.map((x, i) => x - d[i]));
  return signOf(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]));
}

test("a side that is told is the exact one, also of points on a plane but for rounding", isMade, async () => {
  const {side} = await part("proof");
  const next = random(58), point = () => [0, 1, 2].map(() => Math.fround(100 * next() - 50));
  let told = 0, untold = 0;
  for (let i = 0; i < 20000; ++i) {
    const a = point(), b = point(), c = point(), [s, t] = [next(), next()];
    // On the plane, but for rounding, or near to it.
    const near = a.map((x, k) => x + s * (b[k] - x) + t * (c[k] - x) + (i % 2) * 1e-13 * next());
    for (const d of [near, point()]) {
      const answer = side(a, b, c, d);
      if (answer === 0) untold += 1;
      else assert.equal(answer, exactSide(a, b, c, d), `case ${i}`);
      told += Number(answer !== 0);
    }
  }
  assert.ok(told > 20000 && untold > 5000, `${told} told, ${untold} not`);
});

test("a segment crosses, misses, or is not told of where it touches", isMade, async () => {
  const {crosses} = await part("proof");
  const triangle = [[-1, -1, 5], [1, -1, 5], [0, 1, 5]];
  const at = (x, y, far) => crosses([0, 0, 0], [x * far, y * far, 5 * far], ...triangle);
  assert.equal(at(0, 0, 2), true);
  assert.equal(at(0, 0, 0.9), false, "it ends before");
  assert.equal(at(3, 0, 2), false, "it passes by");
  assert.equal(at(0, -1, 2), undefined, "through an edge");
  assert.equal(at(0, 1, 2), undefined, "through a corner");
  assert.equal(at(0, 0, 1), undefined, "it ends on it");
});

// ---- Both methods ----

const box = (x0, y0, z0, x1, y1, z1) => [x0, y0, z0, x1, y1, z1];
/** Twelve triangles. */
function trianglesOf([x0, y0, z0, x1, y1, z1]) {
  const corner = i => [i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0];
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  return faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d].flatMap(corner));
}

async function modelOf(boxes, colours = () => 255) {
  const {Builder} = await part("builder");
  const builder = new Builder();
  boxes.forEach((of, i) => builder.add(`Box ${i}`, Float32Array.from(trianglesOf(of)), new Uint8Array(144).fill(colours(i))));
  return builder.model({name: "Boxes", up: [0, 0, 1], isColoured: true, cameras: [], flightIn: () => ({places: [], seconds: 1})});
}

const looking = (eye, target = [eye[0] + 1, eye[1], eye[2]]) => ({eye, target, up: [0, 0, 1], fovY: 60, aspect: 1.6, near: 0.1});

/** A wall, what it hides, and what is behind the camera. */
const room = [box(10, -20, -20, 10.5, 20, 20), box(20, -1, -1, 21, 1, 1), box(-21, -1, -1, -20, 1, 1)];

async function cullingOf(method) {
  const {load} = await import(`${dist}/occlude.mjs`), {Culling} = await part("culling");
  return new Culling(await load(), await modelOf(room), method);
}

for (const method of ["polygons", "objects"]) {
  test(`${method}: what is hidden and what is out of view are told apart`, isMade, async () => {
    const culling = await cullingOf(method), frame = culling.cull(looking([0, 0, 0]), {margin: 0}, 0, 0), fates = new Uint8Array(36);
    frame.tellFates(fates);
    const {Fate} = await part("frame");
    assert.ok(fates.subarray(12, 24).every(fate => fate === Fate.hidden) && fates.subarray(24).every(fate => fate === Fate.outOfView));
    assert.deepEqual([frame.counts.hidden >= 12, frame.counts.outOfView >= 12], [true, true]);
    const drawn = [];
    for (let i = 0; i < frame.drawn.length; i += 2) {
      for (let t = frame.drawn[i]; t < frame.drawn[i] + frame.drawn[i + 1]; ++t) drawn.push(frame.index[3 * t] / 3);
    }
    const told = [...fates.keys()].filter(t => fates[t] === Fate.drawn);
    assert.deepEqual(drawn.sort((a, b) => a - b), told);
    assert.equal(frame.counts.drawn, told.length);
    assert.deepEqual(culling.everything.drawn, Uint32Array.of(0, 36));
  });

  test(`${method}: a frame is held while it holds, and for the same limits`, isMade, async () => {
    const culling = await cullingOf(method), limits = {margin: 0};
    const isHeldAt = (x, seconds, hold = 0.5, how = limits) => {
      culling.cull(looking([x, 0, 0]), how, hold, seconds);
      return culling.isHeld;
    };
    assert.deepEqual([isHeldAt(0, 0), isHeldAt(0.03, 0.1), isHeldAt(0.06, 0.2)], [false, true, true]);
    assert.equal(isHeldAt(0.07, 0.3, 0.5, {margin: 0.001}), false, "other limits");
    assert.equal(isHeldAt(5, 0.4, 0.5, {margin: 0.001}), false, "too far away");
    assert.deepEqual([isHeldAt(5, 0.5, 0), isHeldAt(5, 0.6, 0), isHeldAt(5, 0.7)], [false, false, false], "of one frame alone");
  });
}

// ---- The judge ----

/** Draws numbers of triangles by a ray through the centre of each pixel, in doubles. */
async function painterOf(model) {
  const {rayOf} = await part("picture"), {subtract, cross, dot} = await part("points");
  const {cornerOf, triangleCount, isSeeThrough} = await part("model");
  const corners = Array.from({length: triangleCount(model)}, (_, t) => [0, 1, 2].map(c => cornerOf(model, t, c)));
  const numbers = (camera, width, height) => {
    const picture = {triangles: new Uint32Array(width * height), width, height, camera};
    for (let i = 0; i < width * height; ++i) {
      const ray = rayOf(picture, i % width, Math.floor(i / width));
      let nearest = Infinity;
      corners.forEach(([a, b, c], t) => {
        if (isSeeThrough(model, t)) return;
        const u = subtract(b, a), v = subtract(c, a), p = cross(ray, v), size = dot(u, p), from = subtract(camera.eye, a);
        const s = dot(from, p) / size, q = cross(from, u), r = dot(ray, q) / size, far = dot(v, q) / size;
        if (!(s >= 0 && r >= 0 && s + r <= 1 && far > camera.near && far < nearest)) return;
        nearest = far;
        picture.triangles[i] = t + 1;
      });
    }
    return picture;
  };
  return {numbers};
}

/** Who is caught in the last of these frames. */
async function caughtIn(boxes, cameras, colours) {
  const {load} = await import(`${dist}/occlude.mjs`), {Culling} = await part("culling"), {Judge, newScores} = await part("judge");
  const occlude = await load(), model = await modelOf(boxes, colours), judge = new Judge(await painterOf(model), model);
  let caught;
  for (const method of ["polygons", "objects"]) {
    const culling = new Culling(occlude, model, method), scores = newScores();
    judge.restart();
    for (const camera of cameras) caught = judge.judge(camera, culling.cull(camera, {margin: 0}, 0, 0), 0, [800, 500], scores);
    assert.equal(scores.occlude.wrongFrames, 0, `${method}: ours`);
    culling.dispose();
  }
  return caught;
}
const names = caught => caught.map(({accused}) => accused).sort();

// A gap of 2 cm at 10 m is 1.4 pixels of the picture, and .6 of the coarse one, whose centres miss it.
const gap = 10.02, wallWithGap = [box(10, -20, -20, 10.5, 0.01, 20), box(10, 0.03, -20, 10.5, 20, 20)];

test("coarse rays and depth pyramids are caught where something shows through a gap", isMade, async () => {
  const caught = await caughtIn([...wallWithGap, box(20, -1, -1, 21, 1, 1)], [looking([0, 0, 0])]);
  assert.deepEqual(names(caught), ["pyramid", "rays"]);
  for (const {object, pixels, proof} of caught) {
    assert.equal(object, 2);
    assert.ok(pixels > 10, `${pixels} pixels`);
    assert.ok(Math.floor(proof.triangle / 12) === 2 && proof.missed === 35 && gap > 10);
  }
});

test("nobody is caught where the gap is closed", isMade, async () => {
  const boxes = [...wallWithGap, box(20, -1, -1, 21, 1, 1), box(9.5, -1, -20, 9.9, 1, 20)];
  assert.deepEqual(names(await caughtIn(boxes, [looking([0, 0, 0])])), []);
});

test("the depth of the last frame is caught where the camera comes round a corner", isMade, async () => {
  const boxes = [box(10, -20, -20, 10.5, 0, 20), box(20, -1, -1, 21, -0.2, 1)];
  assert.deepEqual(names(await caughtIn(boxes, [looking([0, -2, 0]), looking([0, 1, 0])])), ["last"]);
  assert.deepEqual(names(await caughtIn(boxes, [looking([0, -2, 0])])), [], "while it is hidden, and in the first frame");
  assert.deepEqual(names(await caughtIn(boxes, [looking([0, 1, 0]), looking([0, 1, 0])])), [], "while it shows");
});

test("what light comes through hides nothing, and nobody is caught for it", isMade, async () => {
  const boxes = [box(10, -20, -20, 10.5, 20, 20), box(20, -1, -1, 21, 1, 1)];
  assert.deepEqual(names(await caughtIn(boxes, [looking([0, 0, 0])], i => (i === 0 ? 0 : 255))), []);
});

test("a package that hid what shows would be caught", isMade, async () => {
  const {Judge, newScores} = await part("judge"), {Fate} = await part("frame");
  const model = await modelOf([box(10, -1, -1, 11, 1, 1)]), judge = new Judge(await painterOf(model), model), scores = newScores();
  const liar = {index: new Uint32Array(), drawn: new Uint32Array(), counts: {}, tellFates: fates => fates.fill(Fate.hidden)};
  const [caught] = judge.judge(looking([0, 0, 0]), liar, 0, [160, 100], scores);
  assert.deepEqual([caught.accused, scores.occlude.wrongFrames, scores.rays.wrongFrames], ["occlude", 1, 0]);
});

test("a ray proves nothing where it meets or touches something before, but glass", isMade, async () => {
  const {prove} = await part("proof"), {ownersOf} = await part("model");
  const far = box(20, -1, -1, 21, 1, 1), triangleOf = model => ownersOf(model).findIndex((owner, t) => owner === 0 && isFront(model, t));
  // The side that faces the eye, in two triangles, of which one holds the point at y = .5, z = .25.
  const isFront = (model, t) => {
    const corners = model.corners.subarray(9 * t, 9 * t + 9);
    return [0, 3, 6].every(i => corners[i] === 20) && prove(model, [15, 0.5, 0.25], [1, 0, 0], t) !== undefined;
  };
  const proofWith = async (other, colours) => {
    const model = await modelOf([far, other], colours);
    return prove(model, [0, 0.5, 0.25], [1, 0, 0], triangleOf(model));
  };
  assert.equal((await proofWith(box(5, 3, 3, 6, 4, 4))).missed, 23, "it passes by");
  assert.equal(await proofWith(box(5, -1, -1, 6, 1, 1)), undefined, "it meets");
  assert.equal(await proofWith(box(5, -1, 0.25, 6, 1, 1)), undefined, "it touches a side");
  assert.equal(await proofWith(box(5, 0.5, 0.25, 6, 1, 1)), undefined, "it touches an edge");
  assert.equal((await proofWith(box(5, -1, -1, 6, 1, 1), i => (i === 1 ? 0 : 255))).missed, 11, "through glass");
});

test("a point is in the picture beyond the near plane and within its edges", isMade, async () => {
  const {isInPicture} = await part("picture"), high = 10 * Math.tan(Math.PI / 6), camera = looking([0, 0, 0]);
  const cases = [[[10, 0, 0], true], [[0.09, 0, 0], false], [[-10, 0, 0], false], [[10, 0, 0.99 * high], true],
    [[10, 0, 1.01 * high], false], [[10, 1.59 * high, 0], true], [[10, -1.61 * high, 0], false]];
  for (const [point, isIn] of cases) assert.equal(isInPicture(camera, point), isIn, String(point));
});

test("rays keep what pixels show, and pyramids what is near or out of the picture", isMade, async () => {
  const {rivals} = await part("rivals"), {ownersOf} = await part("model");
  const boxes = [box(10, -30, -30, 11, 30, 30), box(20, -1, -1, 21, 1, 1), box(-5, -1, -1, 5, 1, 1), box(20, 90, 0, 21, 91, 1)];
  const model = await modelOf(boxes), owners = ownersOf(model), [rays, pyramid] = rivals;
  const wall = (await painterOf(await modelOf(boxes.slice(0, 1)))).numbers(looking([0, 0, 0]), 32, 20);
  assert.deepEqual([...pyramid.hide(model, owners, {coarse: wall})], [0, 1, 0, 0]);
  const last = {...wall, triangles: Uint32Array.of(12, 0, 36)};
  assert.deepEqual([...rays.hide(model, owners, {coarse: last})], [0, 1, 0, 1], "the last triangles of two boxes show");
});

// ---- The rest ----

test("a link names place and settings, to the last digit", isMade, async () => {
  const {parse, format, defaults} = await part("address");
  const place = {eye: [1 / 3, -2e-7, 1e6], target: [0.1 + 0.2, 5, 6]};
  const all = {scene: "town", model: undefined, place, frame: undefined, before: {eye: [0, 0, 0], target: [1, 0, 0]},
    settings: {method: "objects", isCulling: false, budget: 1.5, hold: 0.5, isClay: true, isCatching: true}};
  assert.deepEqual(parse(format(all)), all);
  assert.deepEqual(parse(""), {scene: undefined, model: undefined, place: undefined, frame: undefined, before: undefined, settings: defaults});
  assert.equal(parse("#frame=7").frame, 7);
  assert.equal(parse("#eye=1,2&target=3,4,5").place, undefined);
  assert.equal(parse("#eye=1,2,3&target=1,2,3").place, undefined, "looking nowhere");
});

test("a recorded path has a keyframe for each thirtieth of a second, and two at least", isMade, async () => {
  const {Recorder} = await part("path");
  const model = {name: "a.glb", lens: {fovY: 60, near: 0.1}, up: [0, 1, 0]}, recorder = new Recorder(), at = x => ({eye: [x, 0, 0], target: [x + 1, 0, 0]});
  recorder.start();
  recorder.record(at(0), 0);
  assert.equal(JSON.parse(recorder.text(model)).keyframes.length, 2);
  recorder.record(at(1), 0.5);
  const path = JSON.parse(recorder.text(model));
  const {frames, keyframes, up, fov_y_deg: fovY, near} = path;
  assert.deepEqual([frames, keyframes.length, keyframes[15], up, fovY, near], [16, 16, at(1), [0, 1, 0], 60, 0.1]);
});

test("objects are at most 256 triangles, and all triangles are there", isMade, async () => {
  const {Builder} = await part("builder"), builder = new Builder(), next = random(3);
  const corners = Float32Array.from({length: 9 * 1000}, next);
  builder.add("Many", corners, new Uint8Array(12 * 1000), Uint32Array.from({length: 1000}, (_, t) => 2 * t));
  const model = builder.model({name: "", up: [0, 0, 1], isColoured: false, cameras: [], flightIn: () => ({})});
  assert.deepEqual([...model.firsts].map((first, i, all) => (all[i + 1] ?? first) - first), [250, 250, 250, 250, 0]);
  const sorted = numbers => Array.from({length: 1000}, (_, t) => numbers.slice(9 * t, 9 * t + 9).join()).sort();
  assert.deepEqual(sorted(model.corners), sorted(corners));
  for (const [t, number] of model.numbers.entries()) {
    assert.deepEqual(model.corners.subarray(9 * t, 9 * t + 9), corners.subarray(4.5 * number, 4.5 * number + 9), "each keeps its number");
  }
});

test("from outside one is behind the camera, turns after it until somebody turns, and what is shifted moves by pixels", isMade, async () => {
  const {Orbit} = await part("orbit"), {axesOf} = await part("axes"), {dot, subtract, distance} = await part("points");
  const orbit = new Orbit(), camera = looking([3, 4, 5]), near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);
  orbit.restart(10);
  orbit.follow(camera, 1);
  const behind = orbit.camera(camera, 1.6);
  assert.ok(dot(subtract(behind.eye, camera.eye), [1, 0, 0]) < 0 && behind.eye[2] > camera.eye[2], "behind and above");
  near(distance(behind.eye, behind.target), 10);
  near(axesOf(behind).forward[1], 0);
  orbit.follow(looking([3, 4, 5], [3, 5, 5]), 0.5);
  near(orbit.yaw, Math.PI / 4);
  const {right, up} = axesOf(orbit.camera(camera, 1)), before = orbit.camera(camera, 1).target;
  orbit.shift(camera, 0.2, 0.1);
  const moved = subtract(orbit.camera(camera, 1).target, before);
  near(dot(moved, right), -2);
  near(dot(moved, up), -1);
  orbit.turn(1, 9);
  orbit.follow(camera, 1);
  assert.deepEqual([orbit.yaw, orbit.pitch, orbit.isFollowing], [1 + Math.PI / 4, 1.5, false]);
});

test("the way round a model is higher where the model is high, so that one looks into it, whichever way is up", isMade, async () => {
  const {orbit} = await part("flight"), {subtract, length} = await part("points");
  const slopeOf = (high, up) => {
    const {eye, target} = orbit({low: [0, 0, 0], high, size: length(high)}, up).places[0], way = subtract(target, eye);
    return Math.abs(way[up.findIndex(x => x !== 0)]) / length(way);
  };
  const flat = slopeOf([90, 50, 2], [0, 0, 1]), court = slopeOf([30, 18, 12], [0, 0, 1]), tower = slopeOf([10, 10, 90], [0, 0, 1]);
  assert.ok(flat > 0.3 && flat < 0.4, `flat ${flat}`);
  assert.ok(court > 0.45 && court <= tower && tower < 0.65, `court ${court}, tower ${tower}`);
  for (const y of [1, -1]) assert.ok(Math.abs(slopeOf([30, 12, 18], [0, y, 0]) - court) < 1e-9);
});

test("a model inside of a page has the colours of its polygons, or is in clay", isMade, async () => {
  const {sceneInside} = await part("inside");
  const start = {name: "a.glb", origin: [0, 0, 0], up: [0, 0, 1]};
  // A quadrilateral and two triangles, the second see-through, over four vertices, which are all where 0 is.
  const soup = [3, 4 << 2, 3 << 2, (3 << 2) | 1, 0, 2, 2, 2, 5, 2, 2, 3, 2, 2], vertices = new Array(48).fill(0);
  const read = async colours => {
    const parts = {"part-start": new TextEncoder().encode(JSON.stringify(start)), "part-model": Uint8Array.from([...soup, ...colours, ...vertices])};
    globalThis.document = {getElementById: id => id in parts ? {textContent: deflateSync(parts[id]).toString("base64")} : null};
    try {
      const {colours: found, isColoured, numbers} = (await sceneInside()).make();
      return {isColoured, numbers: [...numbers], colours: Array.from(numbers, (_, t) => [...found.subarray(12 * t, 12 * t + 12)])};
    } finally {
      delete globalThis.document;
    }
  };
  const all = corner => [...corner, ...corner, ...corner], numbers = [0, 0, 1, 2];
  const white = all([255, 255, 255, 255]), glass = all([255, 255, 255, 0]);
  assert.deepEqual(await read([0]), {isColoured: false, numbers, colours: [white, white, white, glass]});
  // 0x000102 and, 0x7f0000 above it, 0x7f0102; the second, the first, the second.
  const blue = all([0, 1, 2, 255]), red = all([0x7f, 1, 2, 255]), redGlass = all([0x7f, 1, 2, 0]);
  assert.deepEqual(await read([2, 0x82, 2, 0x80, 0x80, 0xfc, 3, 2, 1, 2]), {isColoured: true, numbers, colours: [red, red, blue, redGlass]});
});

test("PLY files of each kind are read, with faces of many corners", isMade, async () => {
  const {readPly} = await part("ply");
  const header = (format, type, more = "") => `ply\nformat ${format} 1.0\nelement vertex 5\nproperty ${type} x\nproperty ${type} y\n` +
    `property ${type} z\n${more}element face 3\nproperty list uchar int vertex_indices\nend_header\n`;
  const points = [[0, 0, 0], [2, 0, 0], [3, 1, 0.5], [2, 2, 0], [0, 2, 0]], faces = [[0, 1, 2, 3, 4], [0, 1], [4, 1, 0]];
  const corners = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [4, 1, 0]].flatMap(loop => loop.flatMap(vertex => points[vertex]));
  const bytes = text => new TextEncoder().encode(text);
  const text = `${points.map(p => p.join(" ")).join("\n")}\n${faces.map(f => [f.length, ...f].join(" ")).join("\n")}\n`;
  const binary = (isLittle, type) => {
    const size = type === "double" ? 8 : 4, data = new DataView(new ArrayBuffer(15 * size + 3 + 40));
    let at = 0;
    for (const x of points.flat()) {
      if (size === 8) data.setFloat64(at, x, isLittle);
      else data.setFloat32(at, x, isLittle);
      at += size;
    }
    for (const face of faces) {
      data.setUint8(at++, face.length);
      for (const vertex of face) data.setInt32((at += 4) - 4, vertex, isLittle);
    }
    return Uint8Array.from([...bytes(header(isLittle ? "binary_little_endian" : "binary_big_endian", type)), ...new Uint8Array(data.buffer)]);
  };
  for (const file of [bytes(header("ascii", "float") + text), binary(true, "double"), binary(true, "float"), binary(false, "double")]) {
    const ply = readPly(file, "a.ply");
    assert.deepEqual([[...ply.corners], [...ply.faces], ply.isColoured], [corners, [0, 0, 0, 1], false]);
  }
  const coloured = header("ascii", "float", "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  const rows = points.map((p, i) => `${p.join(" ")} ${10 * i} 20 30`).join("\n");
  const ply = readPly(bytes(`${coloured}${rows}\n5 0 1 2 3 4\n0\n0\n`), "a.ply");
  assert.deepEqual([[...ply.colours.subarray(0, 12)], ply.isColoured], [[0, 20, 30, 255, 10, 20, 30, 255, 20, 20, 30, 255], true]);
  const broken = {"obj\n": /^Error: a.ply: this is no PLY file$/, [header("ascii", "float") + text.replace("4 1 0", "4 1 5")]: /vertex 5, which is not there/,
    [header("ascii", "float") + text.slice(0, 30)]: /ends early/, [header("binary_little_endian", "float") + "xyz"]: /ends early/,
    [header("binary_little_endian", "quaternion")]: /no type quaternion/};
  for (const [file, reason] of Object.entries(broken)) assert.throws(() => readPly(bytes(file), "a.ply"), reason);
});

test("built-in scenes are the same each time, and one flies through none of their walls", isMade, async () => {
  const {scenes} = await part("scenes"), {triangleCount, cornerOf} = await part("model"), {crosses} = await part("proof");
  assert.equal(scenes.length, 5);
  for (const {key, make} of scenes) {
    const model = make();
    assert.deepEqual(make().corners, model.corners);
    assert.ok(triangleCount(model) < 150000, `${key}: ${triangleCount(model)} triangles`);
    const {places} = model.flight;
    for (let t = 0; t < triangleCount(model); ++t) {
      const corners = [0, 1, 2].map(c => cornerOf(model, t, c));
      for (let i = 4; i < places.length; i += 4) {
        assert.notEqual(crosses(places[i - 4].eye, places[i].eye, ...corners), true, `${key}: triangle ${t} at place ${i}`);
      }
    }
  }
});
