// SPDX-License-Identifier: MIT
// Vectors, and cameras as matrices. Vectors are arrays of three numbers; matrices have their columns one after another.

const add = (a, b) => a.map((x, i) => x + b[i]);
const subtract = (a, b) => a.map((x, i) => x - b[i]);
const scale = (a, s) => a.map(x => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(...a);
const unit = a => scale(a, 1 / length(a));
const distance = (a, b) => length(subtract(a, b));

/** Two unit vectors across `up`, which with it make right-handed axes. */
function levelAxes(up) {
  const helper = Math.abs(up[0]) < 0.9 * length(up) ? [1, 0, 0] : [0, 1, 0];
  const north = unit(subtract(helper, scale(up, dot(helper, up) / dot(up, up))));
  return {east: north, north: unit(cross(up, north)), up: unit(up)};
}

/** Right, up and forward of a camera. */
function axesOf(camera) {
  const forward = unit(subtract(camera.target, camera.eye));
  const right = unit(cross(forward, camera.up));
  return {right, up: cross(right, forward), forward};
}

/**
 * From coordinates relative to the eye to the picture. A camera has eye, target, up, aspect, near, far and either fov_y_deg or,
 * if it is orthographic, height. With `window` it is only a part of the picture: {x, y, across, up}, its middle (the picture
 * reaches from -1 to 1 on both axes) and by how much it is magnified.
 */
function projection(camera) {
  const {right, up, forward} = axesOf(camera);
  const {near, far} = camera;
  const isPerspective = camera.projection !== 'orthographic';
  const y = isPerspective ? 1 / Math.tan(camera.fov_y_deg * Math.PI / 360) : 2 / camera.height;
  const x = y / camera.aspect;
  // Depth is (a z + b) / w, where z is the distance along the line of sight and w is z, or 1.
  const a = isPerspective ? (far + near) / (far - near) : 2 / (far - near);
  const b = isPerspective ? -2 * far * near / (far - near) : -(far + near) / (far - near);
  const w = isPerspective ? [...forward, 0] : [0, 0, 0, 1];
  const {window = {x: 0, y: 0, across: 1, up: 1}} = camera;
  const inWindow = (row, middle, magnified) => row.map((c, i) => magnified * (c - middle * w[i]));
  const rows = [
    inWindow([...scale(right, x), 0], window.x, window.across),
    inWindow([...scale(up, y), 0], window.y, window.up),
    [...scale(forward, a), b],
    w,
  ];
  return new Float32Array([0, 1, 2, 3].flatMap(column => rows.map(row => row[column])));
}

/** The corners of what the camera sees at a distance from the eye, counter-clockwise from the lower left. */
function pictureCorners(camera, away) {
  const {right, up, forward} = axesOf(camera);
  const half = camera.projection === 'orthographic' ? camera.height / 2 : Math.tan(camera.fov_y_deg * Math.PI / 360) * away;
  const middle = add(camera.eye, scale(forward, away));
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(
    ([x, y]) => add(middle, add(scale(right, x * half * camera.aspect), scale(up, y * half))));
}
