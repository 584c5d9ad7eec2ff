// SPDX-License-Identifier: MIT
// Cameras as matrices, which have their columns one after another.

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
