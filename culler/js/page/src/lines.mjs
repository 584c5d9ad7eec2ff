// SPDX-License-Identifier: MIT
// Straight lines some pixels wide.
import {subtract} from "./points.mjs";
import {kDepth, link} from "./programs.mjs";

/** @import {Rgb} from "./colours.mjs" */
/** @import {Point} from "./points.mjs" */
/** @typedef {{readonly from: Point, readonly to: Point, readonly colour: Rgb, readonly alpha?: number}} ColouredLine */

/** Each is a quad. */
const kLineVertices = `#version 300 es
precision highp float;
uniform mat4 projection;
uniform vec2 size;  // of the picture, in pixels
uniform float width;
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
out vec4 tint;
void main() {
  vec4 a = projection * vec4(from, 1), b = projection * vec4(to, 1);
  // Cut off at the near plane, where z = -w.
  float da = a.z + a.w, db = b.z + b.w;
  if (da < 0.0 && db > 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0 && da > 0.0) b = mix(b, a, db / (db - da));
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) * width / size : vec2(0);
  vec4 end = (gl_VertexID & 2) == 0 ? a : b;
  end.xy += ((gl_VertexID & 1) == 0 ? across : -across) * end.w;
  tint = colour;
  gl_Position = da < 0.0 && db < 0.0 ? vec4(0, 0, 2, 1) : end;
}`;

/** What is painted over a picture, by its alpha. */
export const kPaint = `#version 300 es
precision highp float;
uniform float near;
in vec4 tint;
out vec4 colour;
void main() {
  colour = vec4(tint.rgb * tint.a, tint.a);
  ${kDepth}
}`;

export class Lines {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.lines = link(gl, kLineVertices, kPaint);
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    // Two points and a colour, for each of a line's four vertices.
    for (const [place, size, offset] of /** @type {const} */ ([[0, 3, 0], [1, 3, 12], [2, 4, 24]])) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 40, offset);
      gl.vertexAttribDivisor(place, 1);
    }
  }

  /**
   * Draws into a picture of so many pixels; `projection` takes what is relative to the eye.
   * @param {readonly ColouredLine[]} lines
   * @param {{readonly eye: Point, readonly near: number, readonly projection: Float32Array}} camera
   * @param {readonly [number, number]} size
   * @param {number} width
   */
  draw(lines, {eye, near, projection}, size, width) {
    if (lines.length === 0) return;
    const {gl} = this, {program, uniforms} = this.lines;
    const numbers = lines.flatMap(({from, to, colour, alpha = 1}) => [...subtract(from, eye), ...subtract(to, eye), ...colour, alpha]);
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.projection ?? null, false, projection);
    gl.uniform2f(uniforms.size ?? null, ...size);
    gl.uniform1f(uniforms.width ?? null, width);
    gl.uniform1f(uniforms.near ?? null, near);
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STREAM_DRAW);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.length);
  }
}
