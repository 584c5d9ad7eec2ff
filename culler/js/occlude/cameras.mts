// SPDX-License-Identifier: MIT
import {structs} from "./layout.mjs";
import type {Library, Scratch} from "./library.mjs";
import {choiceOf, fixed, pointOf, type Point} from "./numbers.mjs";

/**
 * Where the eye may be, relative to a camera's: in a ball, or in a box whose corners are all sums of the half edges and
 * their negatives. What is culled is hidden from each of these eyes.
 */
export interface EyeRegion {
  readonly radius?: number;
  readonly halfEdges?: readonly [Point, Point, Point];
}

/** A right-handed camera that looks from `eye` to `target`. */
export interface LookAtCamera {
  readonly eye: Point;
  readonly target: Point;
  /** Towards the top of the picture. Default: z, [0, 0, 1]. */
  readonly up?: Point;
  readonly projection?: "perspective" | "orthographic";
  /** The full vertical opening angle in degrees, in [0.001, 179]. Default: 60. */
  readonly fovY?: number;
  /** Of an orthographic picture, in units of the scene. Default: 100. */
  readonly height?: number;
  /** Width over height of the picture. Default: 16 / 9. */
  readonly aspect?: number;
  /** Distance of the near plane from the eye, above 0. Default: 0.1. */
  readonly near?: number;
  /** Default: no far plane. */
  readonly far?: number;
  readonly eyes?: EyeRegion;
}

/** The clip volume in depth: -w <= z <= w as in WebGL, or 0 <= z <= w as in WebGPU. */
export type ClipDepth = "minus_w_to_w" | "zero_to_w";
/** Which depth the renderer draws before the other; `greater` is reversed depth. */
export type Nearer = "less" | "greater";

/** A camera that is the matrix of the renderer, from the coordinates of the scene to clip space. */
export interface MatrixCamera {
  /** 16 numbers, column after column: the `elements` of a Matrix4 of three.js, `projection x view`. */
  readonly matrix: ArrayLike<number>;
  /** Must be said: with the wrong one, what is visible might be hidden. */
  readonly depth: ClipDepth;
  /** Default: that which the matrix has nearer to its eye; must be said with parallel rays. */
  readonly nearer?: Nearer;
  readonly eyes?: EyeRegion;
}

export type Camera = LookAtCamera | MatrixCamera;

// The first is OCCLUDE_..._UNSAID.
const depths = ["", "minus_w_to_w", "zero_to_w"] as const;
const nearers = ["", "less", "greater"] as const;
const projections = ["perspective", "orthographic"] as const;

const eyesOf = (eyes: EyeRegion = {}) => ({
  "eyes.radius": eyes.radius,
  "eyes.half_edges": eyes.halfEdges?.flatMap((edge, i) => Array.from(pointOf(edge, `half edge ${i} of the eyes`))),
});

const lookAtValues = (camera: LookAtCamera) => ({
  eye: pointOf(camera.eye, "eye"),
  target: pointOf(camera.target, "target"),
  up: camera.up && pointOf(camera.up, "up"),
  fov_y_deg: camera.fovY,
  height: camera.height,
  aspect: camera.aspect,
  near_plane: camera.near,
  far_plane: camera.far,
  projection: choiceOf(camera.projection ?? "perspective", projections, "projection"),
  ...eyesOf(camera.eyes),
});

/** A struct of C, and what is appended to the name of the function that takes it. */
export function cameraOf(scratch: Scratch, camera: Camera): {place: number; suffix: "" | "_look_at"} {
  if (!("matrix" in camera)) {
    return {place: scratch.struct(structs.lookAtCamera, lookAtValues(camera)), suffix: "_look_at"};
  }
  const matrix = scratch.copyOf(Float64Array.from(fixed(camera.matrix, 16, "matrix")));
  const place = scratch.struct(structs.matrixCamera, {
    matrix,
    depth: choiceOf(camera.depth ?? "", depths, "depth"),
    nearer: choiceOf(camera.nearer ?? "", nearers, "nearer"),
    ...eyesOf(camera.eyes),
  });
  return {place, suffix: ""};
}

/** How far an eye may leave its way, and the camera turn. The lengths are for somebody who walks, in metres. */
export interface Way {
  /** To both sides of the way, and before and after a way that is shorter. Default: 0.1. */
  readonly aside?: number;
  /** To both sides across that. Default: 0.05. */
  readonly up?: number;
  /** By how much the camera may turn, about any axis. Default: 0; of held culls 2. */
  readonly turnDegrees?: number;
}

export const wayOf = (scratch: Scratch, way: Way): number =>
  scratch.struct(structs.aheadOptions, {aside: way.aside, up: way.up, turn_degrees: way.turnDegrees});

/** See Occlude.ahead. */
export function ahead(library: Library, camera: Camera, velocity: Point, seconds: number, way: Way): LookAtCamera {
  return library.using(scratch => {
    const {place, suffix} = cameraOf(scratch, camera);
    const to = scratch.struct(structs.lookAtCamera);
    const speed = scratch.copyOf(Float64Array.from(pointOf(velocity, "velocity")));
    library.check(library.c[`occlude_ahead${suffix}`]!(place, speed, seconds, wayOf(scratch, way), to));
    return read(library.memory, to);
  });
}

function read(memory: DataView, at: number): LookAtCamera {
  const {lookAtCamera: struct} = structs;
  const edges = edgesAt(memory, at);
  return {
    eye: struct.readPoint(memory, at, "eye"),
    target: struct.readPoint(memory, at, "target"),
    up: struct.readPoint(memory, at, "up"),
    projection: projections[struct.read(memory, at, "projection")]!,
    fovY: struct.read(memory, at, "fov_y_deg"),
    height: struct.read(memory, at, "height"),
    aspect: struct.read(memory, at, "aspect"),
    near: struct.read(memory, at, "near_plane"),
    far: struct.read(memory, at, "far_plane"),
    eyes: {radius: struct.read(memory, at, "eyes.radius"), halfEdges: edges},
  };
}

function edgesAt(memory: DataView, at: number): [Point, Point, Point] {
  const start = at + structs.lookAtCamera.offsets.get("eyes.half_edges")!;
  return [0, 24, 48].map(edge => [0, 8, 16].map(i => memory.getFloat64(start + edge + i, true))) as [number[], number[], number[]];
}

/** See Occlude.matrixOf. */
export function matrixOf(library: Library, camera: LookAtCamera, depth: ClipDepth, nearer: Nearer): MatrixCamera {
  return library.using(scratch => {
    const from = scratch.struct(structs.lookAtCamera, lookAtValues(camera));
    const to = scratch.room(128);
    const {c} = library;
    library.check(c.occlude_look_at_matrix!(from, choiceOf(depth, depths, "depth"), choiceOf(nearer, nearers, "nearer"), to));
    const made: MatrixCamera = {matrix: library.doubles(to, 16), depth, nearer};
    return camera.eyes === undefined ? made : {...made, eyes: camera.eyes};
  });
}
