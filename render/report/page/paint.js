// SPDX-License-Identifier: MIT
// What the viewer draws with, beside lines: the model, boxes and faces.

const isParallel = camera => camera.fovY === undefined;

/** As depths take it (programs.mjs). */
const nearOf = camera => isParallel(camera) ? 0 : camera.near;

/** A vertex array whose attributes lie in buffers of their own. */
class Arrays {
  constructor(gl) {
    this.gl = gl;
    this.array = gl.createVertexArray();
    this.buffers = new Map();
  }
  /** Attribute `place` of `size` numbers each; of whole numbers if `isWhole`. */
  set(place, data, size, {type = this.gl.FLOAT, isWhole = false, everyInstance = 0} = {}) {
    const gl = this.gl;
    gl.bindVertexArray(this.array);
    if (!this.buffers.has(place)) this.buffers.set(place, gl.createBuffer());
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers.get(place));
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    if (isWhole) gl.vertexAttribIPointer(place, size, type, 0, 0);
    else gl.vertexAttribPointer(place, size, type, false, 0, 0);
    gl.vertexAttribDivisor(place, everyInstance);
  }
  dispose() {
    for (const buffer of this.buffers.values()) this.gl.deleteBuffer(buffer);
    this.gl.deleteVertexArray(this.array);
  }
}

/** A texture with one whole number a texel, always bound to the same unit. */
class NumberTexture {
  constructor(gl, unit, format, type, wide, numbers) {
    Object.assign(this, {gl, unit, type, wide, rows: Math.ceil(numbers.length / wide)});
    this.texels = new numbers.constructor(this.rows * wide);
    gl.activeTexture(gl.TEXTURE0 + unit);
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, wide, this.rows);
    this.set(numbers);
  }
  set(numbers) {
    const gl = this.gl;
    this.texels.set(numbers);
    gl.activeTexture(gl.TEXTURE0 + this.unit);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, this.wide, this.rows, gl.RED_INTEGER, this.type, this.texels);
  }
}

/** The polygons of a model, each in the colour of its fate. */
class ModelPainter {
  constructor(gl) {
    this.gl = gl;
    this.colours = link(gl, kModelVertices, kModelColours);
    this.numbers = link(gl, kModelVertices, kModelNumbers);
  }
  setModel(model) {
    const {gl} = this;
    this.model = model;
    this.arrays?.dispose();
    for (const {texture} of [this.fates, this.marks].filter(known => known)) gl.deleteTexture(texture);
    this.arrays = new Arrays(gl);
    this.arrays.set(0, model.corners, 3, {type: gl.INT, isWhole: true});
    this.arrays.set(1, model.cornerLeaves, 1, {type: gl.UNSIGNED_INT, isWhole: true});
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    // Units 0 and 1 have the picture that comes to the screen.
    this.fates = new NumberTexture(gl, 2, gl.R16UI, gl.UNSIGNED_SHORT, kFatesWide, new Uint16Array(model.leaves));
    this.vain = this.levelsOfVain();
    this.marks = new NumberTexture(gl, 3, gl.R8UI, gl.UNSIGNED_BYTE, kTrianglesWide, this.vain);
  }
  /** Of each triangle 2 times how often its polygon was drawn in vain, in 127 steps of the logarithm. */
  levelsOfVain() {
    const {vain, mostVain, firstTriangle, polygons, triangles} = this.model;
    const levels = new Uint8Array(triangles);
    for (let p = 0; p < polygons; ++p) {
      if (vain[p] > 0) levels.fill(2 * Math.round(1 + 126 * shareOfVain(vain[p], mostVain)), firstTriangle[p], firstTriangle[p + 1]);
    }
    return levels;
  }
  /** `seen` has 1 for each triangle that the camera sees. */
  setSeen(seen) {
    this.marks.set(seen.map((isSeen, triangle) => isSeen | this.vain[triangle]));
  }
  /** The program for the next draws, with what all of them share. */
  use({program, uniforms}, camera, shown, ceiling) {
    const gl = this.gl;
    gl.useProgram(program);
    gl.bindVertexArray(this.arrays.array);
    gl.uniformMatrix4fv(uniforms.projection, false, projectionOf(camera, camera.window));
    const onGrid = camera.eye.map((c, axis) => (c - this.model.low[axis]) / this.model.step), cell = onGrid.map(Math.floor);
    gl.uniform3iv(uniforms.eyeCell, cell);
    gl.uniform3fv(uniforms.eyeRest, subtract(onGrid, cell));
    gl.uniform1f(uniforms.step, this.model.step);
    gl.uniform1f(uniforms.near, nearOf(camera));
    gl.uniform1i(uniforms.showsDrawn, shown.drawn);
    gl.uniform1i(uniforms.showsOutOfView, shown.outOfView);
    gl.uniform1i(uniforms.showsHidden, shown.hidden);
    gl.uniform1i(uniforms.showsAll, false);
    gl.uniform3fv(uniforms.up, ceiling.up);
    gl.uniform1f(uniforms.ceiling, ceiling.height);
    gl.uniform1i(uniforms.fates, this.fates.unit);
    gl.uniform1i(uniforms.marks ?? null, this.marks.unit);
    this.showsOnlyDrawn = shown.drawn && !shown.outOfView && !shown.hidden;
  }
  /** All that is shown. Where that is only what the frame draws, nothing else is sent to the graphics card. */
  drawAll() {
    if (!this.showsOnlyDrawn) return this.drawTriangles(0, this.model.triangles);
    const {leaves, firstPolygon, firstTriangle} = this.model, fates = this.fates.texels;
    for (let leaf = 0, end; leaf < leaves; leaf = end + 1) {
      while (leaf < leaves && fates[leaf] !== Fate.drawn) ++leaf;
      for (end = leaf; end < leaves && fates[end] === Fate.drawn;) ++end;
      this.drawTriangles(firstTriangle[firstPolygon[leaf]], firstTriangle[firstPolygon[end]]);
    }
  }
  drawTriangles(first, end) {
    if (first < end) this.gl.drawArrays(this.gl.TRIANGLES, 3 * first, 3 * (end - first));
  }
  /** Polygons with a share of one colour, whatever became of them; after use(this.colours, ...). */
  drawPolygons(polygons, colour, share) {
    const gl = this.gl, {uniforms} = this.colours, {firstTriangle} = this.model;
    gl.uniform1i(uniforms.showsAll, true);
    gl.uniform4fv(uniforms.tint, [...colour, share]);
    for (let i = 0; i < polygons.length;) {
      let end = i + 1;
      while (end < polygons.length && polygons[end] === polygons[end - 1] + 1) ++end;
      this.drawTriangles(firstTriangle[polygons[i]], firstTriangle[polygons[end - 1] + 1]);
      i = end;
    }
    gl.uniform4f(uniforms.tint, 0, 0, 0, 0);
    gl.uniform1i(uniforms.showsAll, false);
  }
}

/** The edges of boxes: {low, high, colour}. */
class BoxPainter {
  constructor(gl) {
    this.gl = gl;
    this.boxes = link(gl, kBoxVertices, kPaint);
    this.arrays = new Arrays(gl);
  }
  draw(boxes, camera) {
    const gl = this.gl, {program, uniforms} = this.boxes, kEdges = 12;
    if (boxes.length === 0) return;
    gl.useProgram(program);
    for (const [place, key] of ['low', 'high'].entries()) {
      const corners = new Float32Array(3 * boxes.length);
      boxes.forEach((box, i) => corners.set(subtract(box[key], camera.eye), 3 * i));
      this.arrays.set(place, corners, 3, {everyInstance: 1});
    }
    const colours = new Float32Array(4 * boxes.length);
    boxes.forEach((box, i) => colours.set(box.colour, 4 * i));
    this.arrays.set(2, colours, 4, {everyInstance: 1});
    gl.uniformMatrix4fv(uniforms.projection, false, projectionOf(camera));
    gl.uniform1f(uniforms.near, nearOf(camera));
    gl.drawArraysInstanced(gl.LINES, 0, 2 * kEdges, boxes.length);
  }
}

/** Triangles: {corners, colour}, three corners each. */
class FacePainter {
  constructor(gl) {
    this.gl = gl;
    this.faces = link(gl, kFaceVertices, kPaint);
    this.arrays = new Arrays(gl);
  }
  draw(faces, camera) {
    const gl = this.gl, {program, uniforms} = this.faces;
    if (faces.length === 0) return;
    gl.useProgram(program);
    const corners = faces.flatMap(face => face.corners.flatMap(corner => subtract(corner, camera.eye)));
    this.arrays.set(0, new Float32Array(corners), 3);
    this.arrays.set(1, new Float32Array(faces.flatMap(face => face.corners.flatMap(() => face.colour))), 4);
    gl.uniformMatrix4fv(uniforms.projection, false, projectionOf(camera));
    gl.uniform1f(uniforms.near, nearOf(camera));
    gl.drawArrays(gl.TRIANGLES, 0, 3 * faces.length);
  }
}
