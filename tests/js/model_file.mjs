// SPDX-License-Identifier: MIT

/** What js_model writes: five counts, and as many vertices, indices, polygons, marks, cameras and answers. */
export function readModel(bytes) {
  const buffer = new Uint8Array(bytes).buffer;
  const [points, corners, polygons, marks, frames] = new Float64Array(buffer, 0, 5);
  let place = 40;
  const take = (Type, count) => {
    const numbers = new Type(buffer, place, count);
    place += Math.ceil((count * Type.BYTES_PER_ELEMENT) / 8) * 8;
    return numbers;
  };
  const vertices = take(Float64Array, 3 * points), indices = take(Uint32Array, corners), sizes = take(Uint32Array, polygons);
  const seeThrough = marks > 0 ? take(Uint8Array, marks) : undefined;
  const numbers = take(Float64Array, 10 * frames), hashes = take(Uint32Array, frames);
  const cameras = Array.from({length: frames}, (_, f) => {
    const [x, y, z, tx, ty, tz, fovY, aspect, near, far] = numbers.subarray(10 * f, 10 * f + 10);
    return {eye: [x, y, z], target: [tx, ty, tz], fovY, aspect, near, far};
  });
  return {vertices, indices, sizes, seeThrough, cameras, hashes};
}
